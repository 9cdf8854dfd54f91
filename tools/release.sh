#!/usr/bin/env bash
# Makes what is given out of a version, in release/<version>: all of it, or the steps that are named.
#   tools/release.sh [--build FOLDER] [--to FOLDER] [STEP...]
# --build: a finished build of this commit (default: build/release, which is built if the program is not there)
# Steps, in this order:
#   live        the live page, which the next four contain; built here (web/build.sh) where Emscripten is installed
#   source      the sources as an archive, with the pages built: needs neither git nor npm
#   deb         the Debian package
#   wheel       the Python package with matrigrate.Simulation, the program and the libraries that both need, for Python 3.11 on Linux
#   site        the documentation, with report pages of short runs and the live page
#   r           the R package as a source archive, matrigrate_<version>.tar.gz; where R is installed
#   containers  the recipes of containers
#   sbom        what the program is made of and linked with, as SPDX
#   checksums   SHA256SUMS and CONTENTS, of all files that are there
# The same commit on the same machine gives the same bytes, but for the site: its report pages hold times.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/setup.sh
umask 022

steps_known="live source deb wheel site r containers sbom checksums"
version=$(sed -n 's/^project(matrigrate VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
name=matrigrate-$version
build=build/release
to=release/$version
steps=()
while [ $# -gt 0 ]; do
  case $1 in
  --build | --to)
    [ $# -ge 2 ] || die "$1 needs a folder"
    [ "$1" = --build ] && build=$2 || to=$2
    shift
    ;;
  -h | --help) sed -n '2,${/^#/!q;s/^# \{0,1\}//p}' "$0" && exit 0 ;;
  *)
    grep -qw -- "$1" <<<"$steps_known" || die "no such step: $1; there are: $steps_known"
    steps+=("$1")
    ;;
  esac
  shift
done
program=$build/bin/matrigrate
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

commit=$(git rev-parse HEAD)
if [ -n "$(git status --porcelain --untracked-files=no)" ]; then
  [ ${#steps[@]} -gt 0 ] || die "there are changes that are not committed: a release is made of a commit"
  say "changes that are not committed are left out"
fi
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH

# the_build: builds program, module and pages unless they are there.
the_build() {
  [ ! -x "$program" ] || return 0
  [ "$build" = build/release ] || die "there is no $program"
  install_packages "$packages_to_build$packages_for_simulation"
  say "building"
  cmake --preset release -DMATRIGRATE_TESTS=OFF -DMATRIGRATE_BENCHMARKS=OFF -DPython3_EXECUTABLE=/usr/bin/python3 >/dev/null || die "the build could not be configured"
  cmake --build --preset release -j "$(job_count)" || die "the build failed"
}

# of_this_commit: the program must be that of the commit; its first lines say which one it is of.
of_this_commit() {
  the_build
  "$program" info | grep -qx "commit *$commit" || die "$program is not of the commit $commit, or was built with changes; build it anew"
}

# live_page: the live page of this commit, or the kept one if it was made of the same sources; else nothing.
live_page() {
  local folder
  if [ "$(cat build/web/live/COMMIT 2>/dev/null)" = "$commit" ]; then
    echo build/web/live/index.html
    return
  fi
  for folder in src viewer web; do
    grep -qsx "$folder $(git rev-parse "HEAD:$folder")" live/SOURCES || return 0
  done
  echo live/index.html
}

# archive FOLDER FILE: a folder as a .tar.gz whose bytes depend on the names and contents of its files alone.
archive() {
  tar --create --directory="$(dirname "$1")" --sort=name --format=gnu --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 \
    --numeric-owner --mode='u=rwX,go=rX' "$(basename "$1")" | gzip -n -9 >"$2"
}

# sources: the files of the commit in $work/$name, with the built pages and the name of the commit.
sources() {
  [ ! -e "$work/$name" ] || return 0
  the_build
  local pages page live
  pages=$(sed -n 's/^MATRIGRATE_PAGES:PATH=//p' "$build/CMakeCache.txt")
  [ -n "$pages" ] || pages=$build/viewer/dist
  git archive --prefix="$name/" HEAD | tar --extract --directory="$work"
  mkdir "$work/$name/pages"
  for page in run study verdicts; do
    cp "$pages/$page.html" "$work/$name/pages/" || die "there are no built pages in $pages"
  done
  live=$(live_page)
  if [ "$live" = build/web/live/index.html ]; then cp "$live" "$work/$name/pages/live.html"; fi # else it is in live/
  echo "$commit" >"$work/$name/COMMIT"
}

step_source() {
  sources
  archive "$work/$name" "$to/$name.tar.gz"
}

step_deb() {
  of_this_commit
  [ ! -e build/web/live/index.html ] || [ -n "$(live_page)" ] ||
    die "build/web/live, which the package would contain, is not of this commit; tools/release.sh live builds it anew"
  cpack --config "$build/CPackConfig.cmake" -B "$work/deb" >"$work/cpack.log" 2>&1 || die "cpack failed: $(tail -n 3 "$work/cpack.log")"
  cp "$work"/deb/matrigrate_*.deb "$to/"
}

step_wheel() {
  of_this_commit
  install_packages "$packages_for_python$packages_for_wheel"
  sources
  local module inside
  inside=$(realpath "$program")
  module=$(realpath "$build"/python/_core*.so)
  [ -e "$module" ] || die "$build has no compiled module: it was built without pybind11-dev"
  (cd "$work/$name" && MATRIGRATE_CORE=$module MATRIGRATE_INSIDE=$inside /usr/bin/python3 -m pip wheel --quiet --no-build-isolation \
    --no-deps --no-index --wheel-dir "$work/wheel" .) || die "pip could not make the wheel"
  /usr/bin/python3 -B tools/wheel_libraries.py "$work"/wheel/matrigrate-*.whl "$to" || die "the libraries could not be taken into the wheel"
}

step_live() {
  local why="Emscripten is not installed; web/build.sh gets it (840 MB) and builds the page"
  if [ -z "$(live_page)" ] && command -v em++ >/dev/null; then
    web/build.sh
    why="there are changes that are not committed"
  fi
  if [ -n "$(live_page)" ]; then
    cp "$(live_page)" "$to/$name-live.html"
  else
    say "the live page is left out, also of source, deb, wheel and site: $why"
  fi
}

step_site() {
  of_this_commit
  install_packages "$packages_for_site"
  sources
  local live=()
  [ -z "$(live_page)" ] || live=(--live "$(live_page)")
  /usr/bin/python3 -B "$work/$name/tools/site/build.py" "$work/$name-site" --program "$program" "${live[@]}" >/dev/null || die "the site could not be built"
  archive "$work/$name-site" "$to/$name-site.tar.gz"
}

# R CMD build writes time and user into DESCRIPTION; the time of the commit takes their place.
step_r() {
  if ! command -v R >/dev/null; then
    say "the R package is left out: R is not installed (apt-get install r-base-core)"
    return
  fi
  mkdir "$work/r"
  git archive HEAD R | tar --extract --directory="$work/r"
  (cd "$work/r" && R CMD build R) >"$work/r.log" 2>&1 || die "the R package could not be built: $(tail -n 3 "$work/r.log")"
  tar --extract --directory="$work/r" --file="$work/r/matrigrate_$version.tar.gz"
  sed -i "s/^Packaged: .*/Packaged: $(date -u -d "@$SOURCE_DATE_EPOCH" '+%F %T UTC'); matrigrate/" "$work/r/matrigrate/DESCRIPTION"
  archive "$work/r/matrigrate" "$to/matrigrate_$version.tar.gz"
}

step_containers() {
  sources
  mkdir "$work/$name-containers"
  (cd "$work/$name" && cp packaging/Dockerfile packaging/matrigrate.def packaging/README.md .dockerignore LICENSE "$work/$name-containers/")
  archive "$work/$name-containers" "$to/$name-containers.tar.gz"
}

step_sbom() {
  the_build
  local wheel=() file
  for file in "$to/$name"-*.whl; do
    [ ! -e "$file" ] || wheel=(--wheel "$file")
  done
  /usr/bin/python3 -B tools/sbom.py "$program" --commit "$commit" "${wheel[@]}" >"$work/sbom.json" || die "the list of parts could not be made"
  cp "$work/sbom.json" "$to/$name.spdx.json"
}

step_checksums() {
  local file
  (
    cd "$to"
    rm -f SHA256SUMS CONTENTS
    for file in *; do
      [ ! -f "$file" ] || printf '%10d  %s\n' "$(stat -c %s "$file")" "$file"
    done >"$work/contents"
    printf 'Matrigrate %s, commit %s\nbytes and name of each file:\n\n%s\n' "$version" "$commit" "$(cat "$work/contents")" >CONTENTS
    find . -maxdepth 1 -type f ! -name SHA256SUMS -printf '%P\n' | LC_ALL=C sort | xargs -d '\n' sha256sum >"$work/sums"
    mv "$work/sums" SHA256SUMS
  )
  cat "$to/CONTENTS"
}

mkdir -p "$to"
if [ ${#steps[@]} -eq 0 ]; then
  [ -z "$(ls -A "$to")" ] || die "$to holds files already; nothing was written. Remove it, or name the steps to make again"
  read -r -a steps <<<"$steps_known"
fi
for step in "${steps[@]}"; do
  say "$step"
  "step_$step"
done
say "done: $to"
