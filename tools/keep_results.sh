#!/usr/bin/env bash
# Keeps what `matrigrate reproduce` has come to: copies the tables of its folder to docs/validation, then writes
# claims.csv from these copies and saves the figures of the pages made of them (tools/figures.mjs, which needs chromium).
# Studies that are not in the folder, or of which runs have not ended, stay as they are kept.
#   tools/keep_results.sh PROGRAM FOLDER_OF_REPRODUCE [first|second]    of which set of closures: all that is kept must be of one
set -euo pipefail
program=$(realpath "$1")
from=$(realpath "$2")
closures=${3:-second}
cd "$(dirname "$0")/.."
to=docs/validation
for folder in "$from"/*/; do
  study=$(basename "$folder")
  [ -e "studies/$study.toml" ] || continue
  if [ ! -e "$folder/results.csv" ] || grep -qE ',(missing|unfinished|running),' "$folder/results.csv"; then
    echo "$study: not kept, since some of its runs have not ended" >&2
    continue
  fi
  for table in results statistics paths msd adhesions shapes centres; do
    [ ! -e "$folder/$table.csv" ] || cp "$folder/$table.csv" "$to/$study-$table.csv"
  done
done
for case in fibres fibres-uniaxial disassembly; do
  [ -e "$from/validate-$case/results.json" ] || continue
  sed '/^  "folder":/d; /"wall_time_s":/d' "$from/validate-$case/results.json" >"$to/validate-$case.json"
  cp "$from/validate-$case/$case.csv" "$to/validate-$case.csv"
done
for table in fields fibre-stress; do
  [ ! -e "$from/$table.csv" ] || cp "$from/$table.csv" "$to/$table.csv"
done
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
"$program" reproduce all --closures "$closures" --from "$to" -o "$drawn" >/dev/null || [ $? -eq 4 ] # some claims do not hold
cp "$drawn"/*.svg "$drawn/claims.csv" "$to/"
node tools/figures.mjs "$drawn/report-all.html" "$to" >/dev/null
cp "$drawn/claims-all.csv" "$to/conditions.csv"
"$program" reproduce X --closures "$closures" --from "$to" -o "$drawn" >/dev/null || [ $? -eq 4 ]
node tools/figures.mjs "$drawn/report-X.html" "$to" >/dev/null
"$program" reproduce all --closures "$closures" --from "$to" --markdown || [ $? -eq 4 ]
