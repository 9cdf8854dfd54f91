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
"$1" export "$2" --vtk --tracks --simularium --ome-tiff --openvt --times "every 36 s" -o "$2/export"
