#!/usr/bin/env bash
# Runs with parameters drawn over the ranges of the paper's sweeps, or FACTOR times wider ones, and a table of how each
# ended: done, or with a reason and its exit code. The draws are the same every time; runs that exist go on.
#   tests/long/stress.sh PROGRAM FOLDER [RUNS] [HOURS] [FACTOR] [JOBS]      (50 runs of 6 hours, factor 1, 2 at a time)
set -euo pipefail
program=$(realpath "$1")
folder=$2
runs=${3:-50}
hours=${4:-6}
factor=${5:-1}
jobs=${6:-2}

draw() { # RUN FACTOR: one --set argument a line
  awk -v run="$1" -v wide="$2" '
    function between(low, high) { low /= wide; high *= wide; return low * exp(rand() * log(high / low)) }
    BEGIN {
      srand(run); rand()
      E = between(50, 400)
      printf "ecm.youngs_modulus=%.4g Pa\n", E
      printf "actomyosin.force=%.4g nN\n", between(0.4, 2)
      printf "protrusion.growth_time=%.4g s\n", between(200, 600)
      printf "protrusion.initiation_rate=%.4g 1/s\n", between(1e-5, 1e-4)
      printf "adhesion.zeta_diss=%.4g 1/nN\n", between(20, 80)
      printf "adhesion.r_off_min=%.4g 1/s\n", between(2.78e-4, 1.667e-3)
      printf "protrusion.number=%d\n", rand() < 0.5 ? 0 : 1 + int(4 * rand())
      if (rand() < 0.25) {
        printf "fibres.arrangement=uniaxial\nfibres.stiffness=%.4g Pa\n", between(1000, 10000)
        print "adhesion.rupture=true"
      }
      print "run.integrator=adaptive"
      print "run.time_step=" (E <= 400 ? 5 : E <= 1200 ? 1.25 : 0.4) " s"
    }'
}

one() { # PROGRAM FOLDER HOURS FACTOR RUN
  local arguments=()
  while read -r set; do arguments+=(--set "$set"); done < <(draw "$5" "$4")
  local code=0
  timeout 3600 "$1" run scenarios/baseline.toml --hours "$3" --seed "$5" "${arguments[@]}" -o "$2/run-$5" --quiet \
    >/dev/null 2>"$2/run-$5.log" || code=$?
  echo "$code" >"$2/run-$5.code"
}
export -f one draw

mkdir -p "$folder"
folder=$(realpath "$folder")
cd "$(dirname "$0")/../.."
seq "$runs" | xargs -n 1 -P "$jobs" bash -c 'one "$0" "$1" "$2" "$3" "$4"' "$program" "$folder" "$hours" "$factor"

echo "runs  exit code  how it ended"
for run in $(seq "$runs"); do
  code=$(cat "$folder/run-$run.code")
  # the sentence without its numbers
  reason=$(grep -v ' was written by ' "$folder/run-$run.log" | head -n 1 |
    sed -E 's/^matrigrate: //; s/Failed after .*\(t = [^)]*\): //; s/; the last good.*//; s/-?[0-9]+(\.[0-9]+)?(e-?[0-9]+)?/N/g' || true)
  [ "$code" != 0 ] || reason=done
  echo "$code|${reason:-ended by a signal}"
done | sort | uniq -c | sed -E 's/^ *([0-9]+) ([0-9]+)\|/\1\t\2\t/'
echo "iterations  rows of health.csv whose largest number of iterations it is"
cat "$folder"/run-*/health.csv 2>/dev/null | awk -F, '$4 ~ /^[0-9]+$/ { n[$4]++ } END { for (k in n) print k "\t" n[k] }' | sort -n
