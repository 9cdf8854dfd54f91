#!/usr/bin/env bash
# Compares two builds bit by bit: 19 short runs (both integrators, fibres, kept numbers, lattices, a resumed
# run and a branch) must end at the same trajectory hashes.
#   tests/long/same_bits.sh PROGRAM OTHER_PROGRAM
#   tests/long/same_bits.sh PROGRAM                    prints the hashes of one
set -euo pipefail

hashes() { # PROGRAM: a line a run
  local program folder
  program=$(realpath "$1")
  folder=$(mktemp -d)
  cd "$folder"
  short() { # NAME, then options of `run`
    local name=$1
    shift
    "$program" run "$@" -o "$name" --quiet >/dev/null || { echo "$name: exit code $?"; return; }
    echo "$name $(sed -n 's/.*"trajectory_hash": "\([0-9a-f]*\)".*/\1/p' "$name/run.json")"
  }
  for preset in baseline soft stiff strong-contraction long-protrusions frequent-protrusions insensitive-adhesions \
    fibrillar one-protrusion four-protrusions two-protrusions-fibres four-protrusions-fibres; do
    "$program" new "$preset.toml" --preset "$preset" >/dev/null
    short "$preset" "$preset.toml" --seed 3 --hours 0.5
  done
  local reference=(--set run.integrator=reference)
  short reference baseline.toml --seed 5 --hours 0.1 "${reference[@]}"
  short reference-four four-protrusions.toml --seed 5 --hours 0.1 "${reference[@]}"
  short reference-fibres two-protrusions-fibres.toml --seed 5 --hours 0.1 "${reference[@]}"
  short hexagonal baseline.toml --seed 7 --hours 0.25 --set ecm.lattice=hexagonal
  short threads baseline.toml --seed 3 --hours 0.5 --set run.threads=2
  "$program" run four-protrusions.toml --seed 9 --hours 0.3 --wall-time 1 -o resumed --quiet &>/dev/null || true
  "$program" resume resumed --quiet >/dev/null
  echo "resumed $(sed -n 's/.*"trajectory_hash": "\([0-9a-f]*\)".*/\1/p' resumed/run.json)"
  "$program" resume baseline --at "0.5 h" --hours 0.7 --set ecm.youngs_modulus="400 Pa" -o branch --quiet >/dev/null || true
  echo "branch $(sed -n 's/.*"trajectory_hash": "\([0-9a-f]*\)".*/\1/p' branch/run.json)"
  cd / && rm -rf "$folder"
}

first=$(hashes "$1")
echo "$first"
[ $# -gt 1 ] || exit 0
second=$(hashes "$2")
if [ "$first" = "$second" ]; then
  echo "the same $(wc -l <<<"$first") hashes"
else
  echo "the hashes differ:"
  diff <(echo "$first") <(echo "$second") || true
  exit 1
fi
