#!/usr/bin/env bash
# Are the tests strong enough? Puts an error into one law of the model after the other, in a copy of the tree, and runs the
# unit tests of its folder: each error must be caught.
#   tests/long/mutations.sh [FOLDER]      FOLDER keeps copy and build for the next time (default: a temporary one)
# Exit code 1 if an error is not caught.
set -euo pipefail
cd "$(dirname "$0")/../.."
if [ $# -gt 0 ]; then
  mkdir -p "$1"
  work=$(realpath "$1")
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi

# file | what stands there | what is put in its place | test program | law
mutations='
src/ecm/law/material.hpp|K * (rho - 1.0)|K * (rho * rho - 1.0)|ecm|equation of state
src/ecm/law/material.hpp|turn * (S.yy - S.xx)|turn * (S.xx - S.yy)|ecm|Jaumann rate
src/ecm/law/fluid.hpp|(1.0 - f) * max|f * max|ecm|pressure of the fluid
src/ecm/law/viscosity.hpp|t_z * V * V * 2.0 * mu|t_z * V * V * mu|ecm|pair drag, Eq. 2
src/ecm/law/fibres.hpp|std::exp((strain - p.onset)|std::exp((strain)|ecm|stiffening of fibres, Eq. 5
src/ecm/degradation.cpp|f - rate * dt|f * (1.0 - rate * dt)|ecm|degradation
src/sph/kernel.hpp|(2.0 * q + 1.0)|(2.0 * q + 1.01)|sph|kernel
src/cell/actomyosin.cpp|std::min(f_mat_i, f_mat_j)|std::max(f_mat_i, f_mat_j)|cell|actomyosin, Eq. 6
src/cell/area.cpp|std::max(0.0, initial_area(p) - area(c))|initial_area(p) - area(c)|cell|area
src/protrusion/adhesion.cpp|-p.zeta_diss * F / f_mat|-p.zeta_diss * F * f_mat|protrusion|disassembly, Eq. 7
src/protrusion/maturation.cpp|(steps + p.adhesion.step_threshold)|steps|protrusion|maturation, Eq. 8
src/protrusion/growth.cpp|? 1.0 / area : 1.0|? 2.0 - area : 1.0|protrusion|area limit, Eq. 10
'
mkdir -p "$work/tree"
git ls-files -z | tar --null --files-from=- -c | tar -x -C "$work/tree"
cmake -S "$work/tree" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DMATRIGRATE_TESTS=ON \
  -DMATRIGRATE_BENCHMARKS=OFF >/dev/null
build() { cmake --build "$work/build" --target "test_$1" >"$work/log" 2>&1 || { tail -n 30 "$work/log"; exit 2; }; }

missed=0
while IFS='|' read -r file old new program law; do
  [ -n "$file" ] || continue
  original=$(cat "$work/tree/$file"; printf x)
  text=${original%x}
  if [ "${text/"$old"/}" = "$text" ]; then
    echo "there is no \"$old\" in $file any more" >&2
    exit 2
  fi
  printf '%s' "${text/"$old"/"$new"}" >"$work/tree/$file"
  build "$program"
  if timeout 120 "$work/build/bin/test_$program" >"$work/log" 2>&1; then # some errors make a loop endless
    echo "NOT caught: $law ($file: $new)"
    missed=1
  else
    echo "caught: $law, by $(grep -c '^\[  FAILED  \] [A-Z].*ms)$' "$work/log" || true) tests that ended"
  fi
  printf '%s' "$text" >"$work/tree/$file"
done <<<"$mutations"
exit $missed
