#!/usr/bin/env bash
# Keeps what `matrigrate reproduce` has come to: copies the tables of its folder to docs/validation, judges these copies, and
# writes the pages of verdicts anew. tools/site/figures.py draws the tables.
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
among_fibres=$(awk -F, '$2 == "n_prot 2" && /,done,/ { print $1; exit }' "$to/kept-protrusions-fibres-results.csv")
if [ -e "$from/kept-protrusions-fibres/runs/$among_fibres/fields.h5" ]; then # Fig 13
  tools/site/figures.py --fibre-stress "$from/kept-protrusions-fibres/runs/$among_fibres" | tenths /dev/stdin >"$to/fibre-stress.csv"
fi
judged=$(mktemp -d)
trap 'rm -rf "$judged"' EXIT
# judge ROWS: the verdicts of the kept tables; some claims do not hold
judge() { "$program" reproduce "$1" --from "$to" -o "$judged" >/dev/null || [ $? -eq 4 ]; }
judge all
cp "$judged/claims.csv" "$to/"
cp "$judged/claims-all.csv" "$to/conditions.csv"
if compgen -G "$to/durotaxis-results.csv" >/dev/null; then
  judge X
  cp "$judged/claims.csv" "$to/experiments.csv"
fi
tools/validation_page.py
