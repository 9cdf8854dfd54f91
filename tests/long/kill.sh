#!/usr/bin/env bash
# Ends a run with a signal at random moments, resumes it, and compares: every trajectory hash, table and snapshot must be
# that of the run without a break, and no other file may be there.
#   tests/long/kill.sh PROGRAM [TIMES] [SIGNAL...]      (50 times KILL and 50 times TERM by default)
set -euo pipefail
program=$(realpath "$1")
times=${2:-50}
signals=(KILL TERM)
[ $# -le 2 ] || signals=("${@:3}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat >s.toml <<'END'
[run]
duration = "240 s"
[ecm]
radius = "60 um"
[protrusion]
initiation_rate = "4e-4 1/s"
[output]
track_interval = "4 s"
snapshot_interval = "30 s"
field_interval = "11 s"
checkpoint_interval = "7 s"
kept_checkpoint_interval = "60 s"
END

begin=$(date +%s%N)
"$program" run s.toml -o whole --quiet >/dev/null
wall=$((($(date +%s%N) - begin) / 1000000)) # [ms]
hash() { grep -o '"trajectory_hash": "[0-9a-f]*"' "$1/run.json"; }
failed=0
for signal in "${signals[@]}"; do
  stopped=0
  for i in $(seq "$times"); do
    after=$((RANDOM * 32768 + RANDOM))
    after=$((after % wall))
    "$program" run s.toml -o here --quiet >/dev/null 2>&1 &
    process=$!
    sleep "$(printf '%d.%03d' $((after / 1000)) $((after % 1000)))"
    kill -s "$signal" $process 2>/dev/null && stopped=$((stopped + 1))
    wait $process 2>/dev/null || true
    "$program" run s.toml -o here --quiet >/dev/null
    for file in tracks.csv health.csv protrusions.csv summary.json snapshots.svg fields.h5 fields.xdmf; do
      cmp -s "whole/$file" "here/$file" || { echo "$signal after $after ms: $file differs" && failed=1; }
    done
    diff -rq whole/snapshots here/snapshots || { echo "$signal after $after ms: other snapshots" && failed=1; }
    [ "$(cd whole && find . | sort)" = "$(cd here && find . | sort)" ] \
      || { echo "$signal after $after ms: other files: $(diff <(cd whole && find . | sort) <(cd here && find . | sort))" && failed=1; }
    [ "$(hash whole)" = "$(hash here)" ] || { echo "$signal after $after ms: another trajectory" && failed=1; }
    rm -rf here
  done
  echo "$signal: $times times, $stopped before the end; $(hash whole)"
done
exit $failed
