#!/usr/bin/env bash
# Times two commands in turn, so that both see the same machine, and prints the user times and the ratio of medians.
#   benchmarks/pair.sh "COMMAND A" "COMMAND B" [TIMES]
# Two builds, or two settings of one: {} in a command becomes a fresh folder.
#   benchmarks/pair.sh \
#     "build/release/bin/matrigrate run scenarios/baseline.toml --hours 0.2 --quiet -o {} --set run.integrator=reference" \
#     "build/release/bin/matrigrate run scenarios/baseline.toml --hours 0.2 --quiet -o {}"
set -euo pipefail
a=$1
b=$2
times=${3:-3}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

user_seconds() { # COMMAND
  local folder
  folder=$(mktemp -d -p "$scratch")
  TIMEFORMAT=%U
  { time bash -c "${1//\{\}/$folder}" >"$scratch/output" 2>&1; } 2>&1 || { cat "$scratch/output" >&2; return 1; }
}
median() { sort -n | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 }'; }

for _ in $(seq "$times"); do
  user_seconds "$a" >>"$scratch/a"
  user_seconds "$b" >>"$scratch/b"
done
A=$(median <"$scratch/a")
B=$(median <"$scratch/b")
echo "A: $(tr '\n' ' ' <"$scratch/a")s, median $A s"
echo "B: $(tr '\n' ' ' <"$scratch/b")s, median $B s"
awk -v a="$A" -v b="$B" 'BEGIN { printf "A / B = %.2f\n", a / b }'
