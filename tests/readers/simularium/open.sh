#!/bin/sh
# Opens a file in Simularium's viewer, which npm has: open.sh FILE.simularium FOLDER SOURCE
# The viewer's package does not name uuid, which it needs. FOLDER keeps the viewer and gets picture.png. Exit code 77 if the viewer cannot be got.
set -eu
mkdir -p "$2"
cp "$3/page.jsx" "$3/open.mjs" "$3/package.json" "$2"
cd "$2"
[ -d node_modules/@aics/simularium-viewer ] || npm install --ignore-scripts --no-audit --no-fund --silent || exit 77
node_modules/.bin/esbuild page.jsx --bundle --format=iife --loader:.svg=dataurl --loader:.png=dataurl --outfile=page.js --log-level=error
exec node open.mjs "$1"
