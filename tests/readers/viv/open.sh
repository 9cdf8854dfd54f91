#!/bin/sh
# Opens a picture with the loader of Viv, a viewer of OME-TIFF in browsers: open.sh FOLDER_OF_THE_RUN PYTHON FOLDER SOURCE
# FOLDER keeps what npm has of it. Exit code 77 if it cannot be got.
set -eu
mkdir -p "$3"
"$2" "$4/../field_pixels.py" "$1" >"$3/pixels.json"
cp "$4/open.mjs" "$4/package.json" "$3"
cd "$3"
[ -d node_modules/@vivjs/loaders ] || npm install --ignore-scripts --no-audit --no-fund --silent || exit 77
exec node open.mjs "$1/export/fields.ome.tif" pixels.json
