#!/bin/sh
# Opens what an export wrote with what npm has: open.sh simularium FILE.simularium FOLDER SOURCE, in Simularium's viewer (whose package
# does not name uuid, which it needs); open.sh viv RUN FOLDER SOURCE PYTHON, with the loader of Viv, a viewer of OME-TIFF in browsers.
# FOLDER keeps what npm has of it, and gets picture.png of Simularium. Exit code 77 if it cannot be got.
set -eu
mkdir -p "$3"
[ "$1" = simularium ] || "$5" "$4/../field_pixels.py" "$2" >"$3/pixels.json"
cp "$4"/* "$3"
cd "$3"
[ -e node_modules/.package-lock.json ] || npm install --ignore-scripts --no-audit --no-fund --silent || exit 77
if [ "$1" = viv ]; then exec node open.mjs "$2/export/fields.ome.tif" pixels.json; fi
node_modules/.bin/esbuild page.jsx --bundle --format=iife --loader:.svg=dataurl --loader:.png=dataurl --outfile=page.js --log-level=error
exec node open.mjs "$2"
