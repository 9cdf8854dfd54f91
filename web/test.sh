#!/usr/bin/env bash
# Tests the live page that web/build.sh has built: the core in Node.js, then the page in Chromium. Where none is built, the page that is kept
# in live/ is tested, in Chromium alone, with what builds the pages of reports in build/release.
#   web/test.sh [PROGRAM] [WATCH]
# PROGRAM: the native program, which the page must agree with (default: build/release/bin/matrigrate, if it is there)
# WATCH: for how many seconds speed, pictures and memory are measured (default 40; an hour: 3600)
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/setup.sh

program=${1:-build/release/bin/matrigrate}
watch=${2:-40}
page=build/web/live/index.html
viewer=build/web/viewer
if [ ! -f "$page" ]; then
  page=live/index.html
  viewer=build/release/viewer
  [ -d "$viewer/node_modules" ] || die "there is no build/web/live/index.html, which web/build.sh makes, and no $viewer to test $page with"
  say "the page that is kept: $page"
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
compared=()
native=()
if [ -x "$program" ]; then
  say "the baseline for half an hour, natively"
  "$program" new "$work/baseline.toml" >/dev/null
  "$program" run "$work/baseline.toml" -o "$work/run" --hours 0.5 --set output.report=false --quiet
  native=("$work/run")
  compared=(--program "$program" --native "$work/run")
else
  say "without the native program nothing is compared with it"
fi
if [ -f build/web/core/core_node.js ]; then
  say "the core in Node.js"
  node web/tests/core.mjs build/web/core/core_node.js 0.25 "${native[@]}"
fi
say "the page in Chromium"
cp web/tests/page.mjs "$viewer/" # beside playwright
node "$viewer/page.mjs" "$page" "${compared[@]}" --watch "$watch"
