#!/usr/bin/env bash
# Makes the calls of a short run fail, one run for each of them: errors of files (EIO, ENOSPC, EDQUOT, short writes), until
# a run is done before its fault, with one and two threads in turn; then memory, at each place of the program that takes
# it: a chain of callers of malloc, the first time that it comes; once or from then on. Each must end with an exit code of
# the table, and the run that goes on after it must have the files of an undisturbed one, and none besides.
#   tests/long/faults.sh PROGRAM [STEP] [io|malloc] [once|lasting]      (every 5th call or place; all)
# FAULT_DEPTH=8 in the environment: the nearest eight callers make a place, and not all. Needs a C compiler.
set -euo pipefail
program=$(realpath "$1")
step=${2:-5}
only=${3:-} how_long=${4:-}
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
field_interval = "20 s"
checkpoint_interval = "15 s"
kept_checkpoint_interval = "30 s"
END
"$program" run s.toml -o whole --quiet --threads 1 >/dev/null
hash() { grep -s '"trajectory_hash"' "$1/run.json"; }
names() { (cd "$1" && find . ! -name .lock ! -name checkpoint_prev.h5 | sort); }
declare -A codes calls
faults=0 wrong=0 sudden=0

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
  for file in tracks.csv health.csv protrusions.csv msd.csv summary.json fields.h5 fields.xdmf; do
    cmp "whole/$file" "run/$file" 2>&1 || true
  done
}

# inject LIBRARY KIND once|lasting FIRST: faults until a run is done before its own.
inject() {
  local at next=$(($4 - 1)) last=0 code threads=1 lasting=() before=$faults
  [ -z "$only" ] || [ "$1" = "${only}_fault" ] || return 0
  [ -z "$how_long" ] || [ "$3" = "$how_long" ] || return 0
  [ "$3" = once ] || lasting=(FAULT_LASTS=1)
  while true; do
    at=$((next + 1))
    [ "$1" = io_fault ] || at=$(sed -n "${at}p" places)
    [ -n "$at" ] || break
    rm -rf run told
    code=0
    [ "$1" = malloc_fault ] || threads=$((1 + faults % 2))
    timeout 60 env "${lasting[@]}" FAULT_AT=$at FAULT_KIND="$2" FAULT_TOLD=told LD_PRELOAD="$PWD/$1.so" \
      "$program" run s.toml -o run --quiet --threads $threads >said 2>&1 </dev/null || code=$?
    if [ ! -s told ]; then
      [ "$1" = malloc_fault ] || break
      echo "$1, $2, $3, call $at: did not come" && wrong=$((wrong + 1))
    fi
    faults=$((faults + 1))
    codes[$code]=$((${codes[$code]:-0} + 1))
    local call trouble=""
    call=$(head -n 1 told)
    calls[$call]=$((${calls[$call]:-0} + 1))
    ! grep -q "^matrigrate: ended by " said || sudden=$((sudden + 1))
    case $code in
      0 | 2 | 3 | 4 | 5 | 75 | 130) ;;
      *) trouble="exit code $code: $(tail -n 1 said)"$'\n' ;;
    esac
    trouble+=$(again $([ $((at % 2)) = 0 ] && echo run || echo resume))
    if [ -n "$trouble" ]; then
      wrong=$((wrong + 1))
      echo "$1, $2, $3, call $at ($call): $trouble"
    fi
    last=$at next=$((next + step))
  done
  echo "$1, $2, $3: $((faults - before)) faults, up to call $last"
}

first=0
for kind in EIO ENOSPC EDQUOT short; do
  for how in once lasting; do
    inject io_fault $kind $how $((1 + first % step))
    first=$((first + 1))
  done
done
rm -rf run
[ "$only" = io ] || FAULT_PLACES=$PWD/places LD_PRELOAD=$PWD/malloc_fault.so \
  "$program" run s.toml -o run --quiet --threads 1 >/dev/null
inject malloc_fault memory once 1
inject malloc_fault memory lasting $((1 + step / 2))
for code in "${!codes[@]}"; do echo "exit code $code: ${codes[$code]}"; done | sort -t ' ' -k 3 -n
for call in "${!calls[@]}"; do echo "$call: ${calls[$call]}"; done | sort
echo "$faults faults injected; $sudden ended at once, by a signal or a library; $wrong wrong"
[ $wrong = 0 ]
