#!/bin/sh
# A short run in a small disc with all that it can be written as: run.sh PROGRAM FOLDER
set -eu
rm -rf "$2"
mkdir -p "$(dirname "$2")"
cat >"$2.toml" <<TOML
[ecm]
radius = "60 um"
[protrusion]
initiation_rate = "0.02 1/s"
growth_time = "60 s"
[output]
track_interval = "12 s"
field_interval = "36 s"
[run]
duration = "180 s"
TOML
"$1" run "$2.toml" -o "$2" --quiet
"$1" export "$2" --tracks --simularium --ome-tiff --openvt --times "every 36 s" -o "$2/export"
# 101 times, as the readers of OpenVT's workshop want them
rm -rf "$2-openvt"
"$1" run "$2.toml" -o "$2-openvt" --quiet --set run.duration="200 s" --set output.track_interval="2 s" \
  --set output.field_interval="200 s"
"$1" export "$2-openvt" --openvt -o "$2-openvt/export"
# A study of two points, of which all tracks go into one table
cat >"$2-study.toml" <<TOML
title = "Stiffness"
scenario = "$(basename "$2").toml"
replicates = 2
[[points]]
label = "soft, or so"
ecm.youngs_modulus = "50 Pa"
run.duration = "36 s"
[[points]]
label = "stiff: it's #2"
ecm.youngs_modulus = "100 Pa"
run.duration = "36 s"
TOML
rm -rf "$2-study"
"$1" study run "$2-study.toml" -o "$2-study" --quiet
"$1" export "$2-study" --tracks --openvt -o "$2-study/export"
