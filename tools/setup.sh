# Shared by ./demo, ./test, python/install.sh, the recipes of containers and tools/site.sh: what the build, the tests and the site need from Debian, and how it is built.
# Sourced with the working directory at the project's root.

# name: reason
packages_to_build="
g++: the compiler
cmake: the build description
ninja-build: runs the build
git: names the commit in the provenance of results
ca-certificates: lets apt and git reach hosts over https
libeigen3-dev: vectors and small matrices
libfmt-dev: text
libtbb-dev: threads
libmuparser-dev: formulas of fields
libpng-dev: pictures as fields
libtiff-dev: the same
libtomlplusplus-dev: scenario files
libcli11-dev: the command line
nlohmann-json3-dev: JSON
librandom123-dev: counter-based random numbers
libxxhash-dev: fingerprints of trajectories
libhdf5-dev: checkpoints and fields
zlib1g-dev: compression of frames and of what reports hold
libboost-math-dev: distributions behind the p-values of studies
nodejs: builds the pages of reports
npm: gets what builds them
"
packages_for_simulation="
pybind11-dev: the compiled module of the Python package, for matrigrate.Simulation and read-outs of tracks
python3-dev: the same
"
packages_for_python="
python3-venv: the environment that it goes into
python3-pip: installs it
python3-setuptools: the same
python3-wheel: the same
python3-pandas: tables
python3-h5py: frames
python3-matplotlib: figures
python3-xxhash: whether tables are still those of their run
"
packages_for_wheel="
patchelf: gives the libraries that go into a wheel their names
"
packages_to_test="
patchelf: makes a wheel with its libraries in its test
libgtest-dev: the tests
libbenchmark-dev: the benchmarks
clang-format: the test of the formatting
chromium: opens the pages of reports in their tests
ffmpeg: encodes movies in their tests
python3-h5py: opens fields in their tests
python3-pip: installs the Python package in its tests
pybind11-dev: the compiled module of the Python package
python3-dev: the same
python3-pandas: tables in the tests of the Python package
python3-matplotlib: figures in the tests of the Python package
python3-xxhash: whether tables are still those of their run, in the tests of the Python package
python3-scipy: emulators in the tests of calibration
python3-jsonschema: checks scenarios against docs/scenario.schema.json
python3-tifffile: opens stacks of fields in their tests
dpkg-dev: makes the Debian package in its test
file: tells programs from scripts while that is made
r-base-core: installs the R package in its test
"
packages_for_site="
mkdocs: builds the documentation site
mkdocs-material: its theme
katex: its equations
python3-numpy: the Python package, whose docstrings are its reference
python3-pandas: the kept results
python3-matplotlib: their figures
"

say() { printf '%s: %s\n' "${0##*/}" "$*"; }
die() {
  say "$*" >&2
  exit 1
}

# install_packages LIST: installs what is missing of it, through apt, as root or through sudo; touches nothing otherwise.
install_packages() {
  local missing="" name reason
  command -v dpkg-query >/dev/null || die "this installs Debian packages, and needs Debian 12; \"Other systems\" in CONTRIBUTING.md says what a build needs elsewhere"
  while IFS=: read -r name reason; do
    [ -n "$name" ] || continue
    dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null | grep -qx installed && continue
    command -v "$name" >/dev/null && continue # a command of that name from elsewhere, as npm often is
    missing="$missing $name"
    say "missing: $name ($(echo "$reason" | sed 's/^ //'))"
  done <<<"$1"
  [ -n "$missing" ] || return 0

  local as_root=""
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || die "the packages above must be installed by root: apt-get install$missing"
    as_root="sudo"
  fi
  say "installing through apt:$missing"
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get update -q
  # shellcheck disable=SC2086 # a list of words
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing ||
    die "apt could not install the packages; is this Debian 12, and can it reach its package source?"
}

# job_count: as many compilers as there are cores, but no more than one for each 1.5 GB of free memory, where that and
# the limit of a container can be read.
job_count() {
  local cores memory_mb limit fit
  cores=$(nproc)
  memory_mb=$(awk '/MemAvailable/ {print int($2 / 1024)}' /proc/meminfo 2>/dev/null || true)
  [ -n "$memory_mb" ] || memory_mb=$((cores * 1500))
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || true)
  case $limit in
  "" | *[!0-9]*) ;;
  *) [ $((limit / 1048576)) -ge "$memory_mb" ] || memory_mb=$((limit / 1048576)) ;;
  esac
  fit=$((memory_mb / 1500))
  [ "$fit" -ge 1 ] || fit=1
  echo $((fit < cores ? fit : cores))
}
