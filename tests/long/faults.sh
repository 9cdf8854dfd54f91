#!/usr/bin/env bash
# Makes the calls of a short run fail, one run for each of them: errors of files (EIO, ENOSPC, EDQUOT, short writes), then
# memory that ends; once or from then on; until a run is done before its fault. Each must end with an exit code of the
# table, and the run that goes on after it must have the files of an undisturbed one, and none besides.
#   tests/long/faults.sh PROGRAM [STEP] [io|malloc]      (every 5th call of files by default, of memory ever fewer; both)
# Needs a C compiler.
set -euo pipefail
program=$(realpath "$1")
step=${2:-5}
only=${3:-}
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for library in io_fault malloc_fault; do cc -shared -fPIC -O1 -Wall "$here/$library.c" -o $library.so -ldl; done
cat >s.toml <<'END'
[run]
duration = "0.02 h"
[cell]
radius = "6 um"
particles = 48
[protrusion]
initiation_rate = "4e-4 1/s"
half_width = 8
[ecm]
radius = "26 um"
[output]
track_interval = "12 s"
snapshot_interval = "60 s"
field_interval = "20 s"
checkpoint_interval = "15 s"
kept_checkpoint_interval = "30 s"
END
"$program" run s.toml -o whole --quiet --threads 1 >/dev/null
hash() { grep -s '"trajectory_hash"' "$1/run.json"; }
names() { (cd "$1" && find . ! -name .lock ! -name checkpoint_prev.h5 | sort); }
declare -A codes calls
faults=0 wrong=0

# again RUN_OR_RESUME: goes on, and compares with the undisturbed run; prints what differs.
again() {
  local code=0
  [ "$1" = run ] || "$program" resume run --quiet --threads 1 >said 2>&1 || code=$?
  if [ "$1" = run ] || [ $code = 5 ]; then # there may have been no checkpoint yet
    code=0
    "$program" run s.toml -o run --quiet --threads 1 >said 2>&1 || code=$?
  fi
  [ $code = 0 ] || { echo "goes on with exit code $code: $(tail -n 1 said)" && return; }
  [ "$(hash whole)" = "$(hash run)" ] || echo "another trajectory"
  diff <(names whole) <(names run) || true
  for file in tracks.csv health.csv protrusions.csv msd.csv summary.json fields.h5 fields.xdmf snapshots.svg; do
    cmp "whole/$file" "run/$file" 2>&1 || true
  done
}

# inject LIBRARY KIND once|lasting FIRST STEP: faults until a run is done before its own. STEP 0: ever longer ones.
inject() {
  local at=$4 code lasting=() before=$faults
  [ -z "$only" ] || [ "$1" = "${only}_fault" ] || return 0
  [ "$3" = once ] || lasting=(FAULT_LASTS=1)
  while true; do
    rm -rf run told
    code=0
    env "${lasting[@]}" FAULT_AT=$at FAULT_KIND="$2" FAULT_TOLD=told LD_PRELOAD="$PWD/$1.so" \
      timeout 60 "$program" run s.toml -o run --quiet --threads 1 >said 2>&1 </dev/null || code=$?
    [ -s told ] || break
    faults=$((faults + 1))
    codes[$code]=$((${codes[$code]:-0} + 1))
    local call trouble=""
    call=$(head -n 1 told)
    calls[$call]=$((${calls[$call]:-0} + 1))
    case $code in
      0 | 2 | 3 | 4 | 5 | 75 | 130) ;;
      *) trouble="exit code $code: $(tail -n 1 said)"$'\n' ;;
    esac
    trouble+=$(again $([ $((at % 2)) = 0 ] && echo run || echo resume))
    if [ -n "$trouble" ]; then
      wrong=$((wrong + 1))
      echo "$1, $2, $3, call $at ($call): $trouble"
    fi
    at=$((at + ($5 > 0 ? $5 : 1 + at / 12)))
  done
  echo "$1, $2, $3: $((faults - before)) faults, up to call $at"
}

first=0
for kind in EIO ENOSPC EDQUOT short; do
  for how in once lasting; do
    inject io_fault $kind $how $((1 + first % step)) "$step"
    first=$((first + 1))
  done
done
inject malloc_fault memory once 1 0
inject malloc_fault memory lasting 1 0
for code in "${!codes[@]}"; do echo "exit code $code: ${codes[$code]}"; done | sort -t ' ' -k 3 -n
for call in "${!calls[@]}"; do echo "$call: ${calls[$call]}"; done | sort
echo "$faults faults injected; $wrong wrong"
[ $wrong = 0 ]
