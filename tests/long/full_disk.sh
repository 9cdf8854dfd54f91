#!/usr/bin/env bash
# A run into a file system of 5 MB that fills up: it must end with exit code 5, leave no broken file, and go on to the
# bits of a run with room once there is some. Mounts a tmpfs, so it wants root.
#   tests/long/full_disk.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
folder=$(mktemp -d)
trap 'umount "$folder/small" 2>/dev/null || true; rm -rf "$folder"' EXIT
mkdir "$folder/small"
mount -t tmpfs -o size=5m tmpfs "$folder/small"
cd "$folder"
cat >s.toml <<'END'
[run]
duration = "400 s"
[ecm]
radius = "60 um"
[protrusion]
initiation_rate = "2e-4 1/s"
[output]
track_interval = "4 s"
checkpoint_interval = "7 s"
kept_checkpoint_interval = "20 s"
END
"$program" run s.toml -o whole --quiet >/dev/null
hash() { grep -o '"trajectory_hash": "[0-9a-f]*"' "$1/run.json"; }

head -c 1500000 /dev/zero >small/filler
code=0
"$program" run s.toml -o small/run --quiet >/dev/null 2>said || code=$?
cat said
[ $code -eq 5 ] || { echo "exit code $code, not 5" && exit 1; }
grep -q 'are safe in checkpoint.h5' said
df --output=avail small | tail -n 1
for file in tracks health protrusions; do # whole lines only, all with as many fields
  awk -F, -v file=$file 'NR == 1 { n = NF } NF != n { print file ": a broken row"; exit 1 }' small/run/$file.csv
  [ -z "$(tail -c 1 small/run/$file.csv)" ] || { echo "$file.csv ends in the middle of a row" && exit 1; }
done
! ls -A small/run | grep -E '\.[A-Za-z0-9]{6}$' || { echo "a temporary file is left" && exit 1; }

rm small/filler small/run/checkpoints/*
code=0
"$program" resume small/run --quiet >/dev/null 2>said || code=$?
while [ $code -eq 5 ]; do # it fills up again: room is made by taking kept checkpoints away
  rm -f small/run/checkpoints/*
  code=0
  "$program" resume small/run --quiet >/dev/null 2>said || code=$?
done
[ "$(hash whole)" = "$(hash small/run)" ] || { echo "another trajectory" && exit 1; }
for file in tracks.csv health.csv protrusions.csv summary.json; do cmp "whole/$file" "small/run/$file"; done
echo "exit code 5, then the bits of the run with room: $(hash small/run)"
