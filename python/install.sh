#!/usr/bin/env bash
# Builds the program and the compiled module of the Python package, and installs the package with matrigrate.Simulation
# into a virtual environment, from Debian's packages alone.
#   python/install.sh [FOLDER]     (default: ~/matrigrate-python)
set -euo pipefail
folder=$(realpath -m "${1:-$HOME/matrigrate-python}")
cd "$(dirname "$0")/.."
. tools/setup.sh

install_packages "$packages_to_build$packages_for_simulation$packages_for_python"
options=(-DPython3_EXECUTABLE=/usr/bin/python3)
[ -e build/release/CMakeCache.txt ] || options+=(-DMATRIGRATE_TESTS=OFF -DMATRIGRATE_BENCHMARKS=OFF)
say "building the program and the module"
cmake --preset release "${options[@]}" >/dev/null || die "the build could not be configured"
cmake --build --preset release --target matrigrate --target matrigrate_python -j "$(job_count)" || die "the build failed"
[ -e "$folder/bin/pip" ] || /usr/bin/python3 -m venv --system-site-packages "$folder" || die "$folder: no virtual environment could be made"
MATRIGRATE_CORE=$(echo "$PWD"/build/release/python/_core*.so) \
  "$folder/bin/pip" install --quiet --no-build-isolation --no-deps --force-reinstall . || die "pip could not install the package"
"$folder/bin/python" -c "import matrigrate; matrigrate.simulation.core()" || die "the package does not find its module"
say "done; use $folder/bin/python, with the program: export MATRIGRATE=$PWD/build/release/bin/matrigrate"
