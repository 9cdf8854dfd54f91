#!/usr/bin/env bash
# Draws docs/images/gallery.png: six cells after six hours (soft, stiff, one and four protrusions, fibres, a branch that
# becomes stiff at 3 h), each from the last frame of a run, in one row. Takes some minutes; needs chromium and node.
#   tools/gallery.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
out=$(cd "$(dirname "$0")/.." && pwd)/docs/images/gallery.png
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for preset in soft stiff one-protrusion four-protrusions two-protrusions-fibres baseline; do
  "$program" new $preset.toml --preset $preset >/dev/null
  "$program" run $preset.toml --seed 4 -o $preset --quiet >/dev/null
done
"$program" resume baseline --at "3 h" --set ecm.youngs_modulus="400 Pa" -o branch --quiet >/dev/null
for run in soft stiff one-protrusion four-protrusions two-protrusions-fibres branch; do
  "$program" export $run --png --times "6 h" --layer degradation --whole --size 600x600 -o $run-picture >/dev/null
done
{
  echo '<!doctype html><style>body{margin:0;display:flex;background:#fff;font:17px/1.3 sans-serif;color:#1f2328}'
  echo 'figure{margin:4px}img{width:312px}figcaption{text-align:center}</style>'
  while IFS='|' read -r run caption; do
    echo "<figure><img src=\"$run-picture/frame_0072.svg\"><figcaption>$caption</figcaption></figure>"
  done <<END
soft|soft matrix, 50 Pa
stiff|stiff matrix, 400 Pa
one-protrusion|one protrusion at a time
four-protrusions|four at a time
two-protrusions-fibres|two at a time, fibres along x
branch|200 Pa, 400 Pa from 3 h on
END
} >gallery.html
chromium --headless --no-sandbox --disable-gpu --allow-file-access-from-files --hide-scrollbars \
  --window-size=1920,350 --screenshot="$out" "file://$folder/gallery.html" >/dev/null 2>&1
echo "$out"
