#!/usr/bin/env bash
# Builds the live page into build/web/live/: one folder of static files. Emscripten comes from Debian; it is large, so that
# nothing else of the project asks for it.
#   web/build.sh [--keep]    --keep: also renews live/, the page that a clone has, for a release
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/setup.sh

packages_for_web="
dpkg-dev: unpacks the source of muParser, which Debian has compiled for processors alone
emscripten: compiles the core to WebAssembly
"
install_packages "$packages_to_build$packages_for_web"
# Node.js from elsewhere does not look for Debian's modules, of which Emscripten uses one.
export NODE_PATH=/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}
toolchain=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake
[ -f "$toolchain" ] || die "Emscripten's file for CMake is not at $toolchain"
# muparser SUITE: the source of muParser into build/web/muparser, from Debian's archive of sources, whose lists apt keeps below build/web.
muparser() {
  [ ! -f build/web/muparser/include/muParser.h ] || return 0
  say "fetching the source of muParser"
  local apt=$PWD/build/web/apt
  rm -rf "$apt" build/web/muparser
  mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial"
  echo "deb-src http://deb.debian.org/debian $1 main" >"$apt/sources.list"
  local options=(-q -o Dir::Etc::SourceList="$apt/sources.list" -o Dir::Etc::SourceParts=/dev/null -o Dir::State::Lists="$apt/lists"
    -o Dir::Cache="$apt/cache" -o APT::Sandbox::User=root)
  (cd "$apt" && apt-get "${options[@]}" update && apt-get "${options[@]}" source muparser) >/dev/null ||
    die "the source of muParser could not be fetched from deb.debian.org"
  mv "$apt"/muparser-*/ build/web/muparser
  rm -rf "$apt"
}
muparser "$(. /etc/os-release && echo "$VERSION_CODENAME")"
say "compiling the core to WebAssembly"
cmake -S web -B build/web/core -G Ninja -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DCMAKE_BUILD_TYPE=Release >/dev/null ||
  die "the build could not be configured"
cmake --build build/web/core -j "$(job_count)" || die "the build failed"

say "building the page"
viewer=build/web/viewer
mkdir -p "$viewer" build/web/live
rm -rf "$viewer/src" "$viewer/sample" "$viewer/tests" "$viewer/dist" # copies of files that may be gone
cp -r viewer/src viewer/sample viewer/tests viewer/*.html viewer/*.json viewer/*.ts "$viewer"
(
  cd "$viewer"
  [ -d node_modules ] || npm ci --no-audit --no-fund --loglevel=error
  npm run build:live --silent
) || die "the page could not be built"
# Of which commit the page is; tools/release.sh takes no other. The archive of a release has the name in a file.
commit=$(git rev-parse HEAD 2>/dev/null || cat COMMIT 2>/dev/null || echo unknown)
[ -z "$(git status --porcelain --untracked-files=no 2>/dev/null)" ] || commit="$commit, with changes"
# What the page contains of others, under the terms that Debian states for each.
{
  printf 'Matrigrate %s, commit %s\n\n' "$(sed -n 's/^project(matrigrate VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)" "$commit"
  cat LICENSE
  for package in emscripten libeigen3-dev libfmt-dev libmuparser-dev libtomlplusplus-dev nlohmann-json3-dev librandom123-dev libxxhash-dev; do
    printf '\n==== %s ====\n\n' "$package"
    cat "/usr/share/doc/$package/copyright"
  done
} >build/web/live/NOTICES
node web/join.mjs "$viewer/dist/live.html" build/web/core/core_worker.js "$viewer/dist/live_worker.js" build/web/live/NOTICES build/web/live/index.html
echo "$commit" >build/web/live/COMMIT
if [ "${1:-}" = --keep ]; then
  case $commit in *changes) die "live/ is made of committed sources only" ;; esac
  cp build/web/live/index.html live/index.html
  {
    sed -n 's/^project(matrigrate VERSION \([0-9.]*\).*/version \1/p' CMakeLists.txt
    for folder in src viewer web; do echo "$folder $(git rev-parse "HEAD:$folder")"; done # tools/release.sh compares them
  } >live/SOURCES
  say "renewed live/index.html"
fi
say "open build/web/live/index.html ($(du -h build/web/live/index.html | cut -f1))"
