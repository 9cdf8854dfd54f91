#!/bin/sh
# A short run, one of two cells, one that failed, a small study and one of two cells for the tests of Python and R: small_runs.sh PROGRAM FOLDER
set -eu
rm -rf "$2"
mkdir -p "$2"
cd "$2"
cat >cell.toml <<TOML
[ecm]
radius = "60 um"
[protrusion]
initiation_rate = "0.002 1/s"
[run]
duration = "30 min"
integrator = "adaptive"
[output]
report = false
TOML
cat >study.toml <<TOML
title = "Small"
scenario = "cell.toml"
replicates = 2
[set]
run.duration = "6 min"
[[points]]
label = "=soft"
ecm.youngs_modulus = "50 Pa"
[[points]]
label = "NA"
ecm.youngs_modulus = "200 Pa"
TOML
"$1" run cell.toml -o run --quiet >/dev/null
"$1" study run study.toml -o study --quiet >/dev/null
"$1" export study --tracks -o exported >/dev/null
"$1" export study --tracks >/dev/null
"$1" new two.toml --preset two-cells >/dev/null
"$1" run two.toml -o pair --quiet --hours 0.4 --set ecm.radius="75 um" --set nucleus.radius="3 um" \
  --set protrusion.initiation_rate="0.002 1/s" --set output.report=false >/dev/null
cat >pairs.toml <<TOML
scenario = "two.toml"
replicates = 2
[set]
run.duration = "3 min"
run.integrator = "adaptive"
ecm.radius = "75 um"
[[points]]
label = "pair"
TOML
"$1" study run pairs.toml -o pairs --quiet >/dev/null
"$1" run cell.toml -o failed --quiet --set ecm.radius="40 um" --set ecm.youngs_modulus="50 Pa" 2>/dev/null && exit 1
test -f failed/run.json
