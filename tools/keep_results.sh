#!/usr/bin/env bash
# Keeps what `matrigrate reproduce` has come to: copies the tables of its folder to docs/validation, judges these copies, saves
# the figures of the pages made of them (tools/figures.mjs, which needs chromium), and writes the pages of verdicts anew.
# Numbers of tables are kept with six digits, places of paths, shapes and pictures to a tenth of a micrometre.
# Studies that are not in the folder, or of which runs have not ended, stay as they are kept.
#   tools/keep_results.sh PROGRAM FOLDER_OF_REPRODUCE
# --to NAME: copies the tables so far to docs/validation/NAME, and judges nothing: of studies of which runs have not
# ended, and of another set of closures. To go on from them, on any machine: reproduce ID --kept docs/validation/NAME -o FOLDER
#   tools/keep_results.sh --to NAME FOLDER_OF_REPRODUCE
set -euo pipefail
to=docs/validation
apart=
if [ "$1" = --to ]; then
  apart=$2
  shift
else
  program=$(realpath "$1")
fi
from=$(realpath "$2")
cd "$(dirname "$0")/.."
[ -z "$apart" ] || to=$to/$apart
mkdir -p "$to"
rounded() { perl -pe 's/(?<![\w.])-?\d+\.\d{5,}(?:e[-+]?\d+)?(?![\w.])/sprintf("%.6g", $&)/ge' "$1"; }
tenths() { perl -pe 's/(?<=,)-?\d+\.\d{2}(?=,)/sprintf("%.1f", $&) =~ s{^-?0\.0$}{0}r =~ s{\.0$}{}r/ge' "$1"; }
# ended: a run that has not ended is a missing one; why it stopped concerns the machine that it ran on. Of a failed run the cause is kept, not the message
ended() {
  python3 -c 'import csv, sys
rows = csv.reader(sys.stdin)
head = next(rows)
out = csv.writer(sys.stdout, lineterminator="\n")
out.writerow(head)
status, reason = head.index("status"), head.index("reason")
for row in rows:
    row[reason] = ""
    left = row[status] in ("unfinished", "running", "interrupted")
    out.writerow([*row[:status], "missing", *[""] * (len(head) - status - 1)] if left else row)'
}
for folder in "$from"/*/; do
  study=$(basename "$folder")
  [ -e "studies/${study%-larger-disc}.toml" ] || continue
  if [ ! -e "$folder/results.csv" ]; then
    echo "$study: not kept, since it has no results" >&2
    continue
  fi
  # in the larger disc are only cells that reached the rim
  if [ -z "$apart" ] && [ "${study%-larger-disc}" = "$study" ] && grep -qE ',(missing|unfinished|running|interrupted),' "$folder/results.csv"; then
    echo "$study: not kept, since some of its runs have not ended" >&2
    continue
  fi
  tables=results
  case $study in # beside the results what the figures are drawn from
  stiffness) tables="results paths msd shapes adhesions" ;;
  kept-protrusions | kept-protrusions-fibres) tables="results paths msd shapes" ;;
  kept-protrusions-larger-disc | kept-protrusions-fibres-larger-disc) tables="results paths" ;; # E4 takes slopes from paths
  sensitive-adhesions | insensitive-adhesions) tables="results adhesions" ;;
  esac
  for table in $tables; do
    short=rounded
    case $table in paths | shapes) short=tenths ;; esac
    case $table in results) last=ended ;; *) last="cat" ;; esac
    [ ! -e "$folder/$table.csv" ] || $short "$folder/$table.csv" | $last >"$to/$study-$table.csv"
  done
done
[ -z "$apart" ] || exit 0
for case in fibres fibres-uniaxial disassembly; do
  [ -e "$from/validate-$case/results.json" ] || continue
  sed '/^  "folder":/d; /"wall_time_s":/d' "$from/validate-$case/results.json" >"$to/validate-$case.json"
  rounded "$from/validate-$case/$case.csv" >"$to/validate-$case.csv"
done
[ ! -e "$from/fields.csv" ] || cp "$from/fields.csv" "$to/fields.csv"
[ ! -e "$from/fibre-stress.csv" ] || tenths "$from/fibre-stress.csv" >"$to/fibre-stress.csv"
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
# judge ROWS: the verdicts of the kept tables, and their page; some claims do not hold
judge() {
  "$program" reproduce "$1" --from "$to" -o "$drawn" >/dev/null || [ $? -eq 4 ]
  node tools/figures.mjs "$drawn/report-$1.html" "$drawn/figures" >/dev/null
}
judge all
cp "$drawn/claims.csv" "$to/"
cp "$drawn/claims-all.csv" "$to/conditions.csv"
cp "$drawn"/*.svg "$to/" # Fig 13's field
if compgen -G "$to/durotaxis-results.csv" >/dev/null; then
  judge X
  cp "$drawn/claims.csv" "$to/experiments.csv"
fi
for study in stiffness kept-protrusions kept-protrusions-fibres; do # the paper's main figures: 5 and 7, 11, 12
  for kind in "" -paths -shapes -msd; do
    [ ! -e "$drawn/figures/$study$kind.svg" ] || cp "$drawn/figures/$study$kind.svg" "$to/"
  done
done
for study in stiffness sensitive-adhesions insensitive-adhesions; do # Fig 9
  [ ! -e "$drawn/figures/$study-adhesions.svg" ] || cp "$drawn/figures/$study-adhesions.svg" "$to/"
done
for case in fibres fibres-uniaxial disassembly; do # Figs 2 and 4
  [ ! -e "$drawn/figures/validate-$case.svg" ] || cp "$drawn/figures/validate-$case.svg" "$to/"
done
tools/validation_page.py
