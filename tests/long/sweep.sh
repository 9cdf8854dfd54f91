#!/usr/bin/env bash
# Runs the baseline for six hours over the ranges of the paper's sweeps, several seeds each, and prints one line a run:
# whether it finished, and its read-outs. Runs that exist are not repeated.
#   tests/long/sweep.sh PROGRAM FOLDER [JOBS] [SEEDS] [SETS]
# SETS: any of "E F T r" (stiffness, actomyosin force, growth time, rate of initiation); all by default.
set -euo pipefail
program=$1
folder=$2
jobs=${3:-2}
seeds=${4:-3}
sets=${5:-E F T r}

list() { # parameter values of each set
  for value in 200 50 400 100 300; do [[ $sets == *E* ]] && echo "ecm.youngs_modulus=${value} Pa"; done
  for value in 0.4 0.8 1.2 1.6 2.0; do [[ $sets == *F* ]] && echo "actomyosin.force=${value} nN"; done
  for value in 200 300 500 600; do [[ $sets == *T* ]] && echo "protrusion.growth_time=${value} s"; done
  for value in 1e-5 3e-5 8e-5 1e-4; do [[ $sets == *r* ]] && echo "protrusion.initiation_rate=${value} 1/s"; done
  true
}

one() { # PROGRAM FOLDER SETTING SEED
  local output
  output="$2/$(echo "$3" | tr ' =/' '___')-seed$4"
  [ -e "$output" ] && return
  "$1" run scenarios/baseline.toml --set "$3" --seed "$4" -o "$output" --quiet 2>"$output.log" || true
}
export -f one

mkdir -p "$folder"
cd "$(dirname "$0")/../.."
for seed in $(seq 1 "$seeds"); do
  list | while read -r setting; do printf '%s\0%s\0' "$setting" "$seed"; done
done | xargs -0 -n 2 -P "$jobs" bash -c 'one "$0" "$1" "$2" "$3"' "$program" "$folder"

for run in "$folder"/*/run.json; do
  printf '%s %s\n' "$(basename "$(dirname "$run")")" "$(tr -d '\n' <"$run" | grep -o '"status": *"[a-z]*"')"
done
