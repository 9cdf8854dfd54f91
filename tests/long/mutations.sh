#!/usr/bin/env bash
# Are the tests strong enough? Puts one error after the other into a copy of the tree, and runs the unit tests of its
# folder: each error must be caught.
#   tests/long/mutations.sh [laws|files] [FOLDER]
# laws: in the laws of the model. files: in fields, and in what is stored, run and studied. Without either: both lists.
# FOLDER keeps copy and build for the next time (default: a temporary one).
# Exit code 1 if an error is not caught; 2 if the tests fail without an error, or a place is not there any more.
set -euo pipefail
cd "$(dirname "$0")/../.."
list=both
case ${1:-} in laws | files) list=$1 && shift ;; esac
if [ $# -gt 0 ]; then
  mkdir -p "$1"
  work=$(realpath "$1")
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi

# file | what stands there | what is put in its place | test program | what is wrong then
laws='
src/model/ecm/law/material.hpp|K * (rho - 1.0)|K * (rho * rho - 1.0)|ecm|equation of state
src/model/ecm/law/material.hpp|turn * (S.yy - S.xx)|turn * (S.xx - S.yy)|ecm|Jaumann rate
src/model/ecm/law/material.hpp|(1.0 - f) * max|f * max|ecm|pressure of the fluid
src/model/ecm/law/viscosity.hpp|t_z * V * V * 2.0 * mu|t_z * V * V * mu|ecm|pair drag, Eq. 2
src/model/ecm/law/fibres.hpp|std::exp((strain - p.onset)|std::exp((strain)|ecm|stiffening of fibres, Eq. 5
src/model/ecm/degradation.cpp|f - rate * dt|f * (1.0 - rate * dt)|ecm|degradation
src/model/sph/kernel.hpp|(2.0 * q + 1.0)|(2.0 * q + 1.01)|sph|kernel
src/model/cell/actomyosin.cpp|std::min(f_mat[i], f_mat[j])|std::max(f_mat[i], f_mat[j])|cell|actomyosin, Eq. 6
src/model/cell/area.cpp|std::max(0.0, initial_area(p) - area(c))|initial_area(p) - area(c)|cell|area
src/parameters/parameters.hpp|-zeta_diss*F/f_mat|-zeta_diss*F*f_mat|protrusion|disassembly, Eq. 7
src/parameters/parameters.hpp|sum(steps, s_mat)|steps|protrusion|force of a step of maturation
src/parameters/parameters.hpp|? 1/A : 1|? 2 - A : 1|protrusion|area limit, Eq. 10
'
files='
src/run/store/trajectory_hash.cpp|update(state.get(), cell.nucleus.x)|update(state.get(), cell.cortex.x)|store|the hash of a trajectory does not see nuclei
src/model/state/members.hpp|visit(StateMember{"falling", "nN"}, s.falling);||store|a member is left out of the list of members
src/run/store/checkpoint.cpp|else if (!value.empty())|else if (!value.empty() && !member.may_be_empty)|store|fields of the matrix are left out of the checkpoint
src/model/state/image.cpp|put(value.value_or(0.0));|put(0.0);|store|the polarization is left out of the image
src/run/store/saved_frames.cpp|saved.size() < times.size()|saved.empty()|store|frames missing in the log are not taken from the field file
src/run/store/run_memory.cpp|text_hash(text) != hash|hash.empty()|store|a table that was edited is taken
src/run/observe/tracks.cpp|= times[1] - times[0];|= times.back() - times[0];|observe|the interval of even times is the whole time
src/run/cadence.hpp|(t + m_slack) / m_interval|t / m_interval|run|an event is due twice where times are rounded down
src/run/resume.cpp|expected != configuration_hash(found.p)|expected.empty()|run|a checkpoint of another scenario is taken
src/run/run_record.cpp|q.run.threads = threads_in_texts;||run|the configuration hash depends on the number of threads
src/study/study_plan/study.cpp|without_folder(value) + value.substr(hash)|value|study_plan|seeds depend on the folder of a file
src/study/study_plan/targets.cpp|std::sqrt(squares / weights)|std::sqrt(squares)|study_plan|the distance of a run is no mean over targets
src/study/study_results/comparison.cpp|how.test != TestKind::welch|how.test == TestKind::welch|study_results|the interval of a difference pools variances with the wrong test
src/fields/grids.cpp|kept.version == version|kept.version.has_value() == version.has_value()|fields|a file that has changed is not read again
src/fields/grids.cpp|relative_slack = 1e-6|relative_slack = 1e-1|fields|nodes off the grid are moved onto it
src/fields/tiff.cpp|orientation == ORIENTATION_TOPRIGHT|orientation == ORIENTATION_LEFTTOP|fields|a picture stored from right to left is mirrored
'
[ "$list" != laws ] || files=
[ "$list" != files ] || laws=
mkdir -p "$work/tree"
while IFS= read -r -d '' file; do # a file that is copied becomes new, and is compiled again
  cmp -s "$file" "$work/tree/$file" || cp --parents "$file" "$work/tree"
done < <(git ls-files -z)
(cd "$work/tree" && cmake --preset release -DMATRIGRATE_TESTS=ON -DMATRIGRATE_BENCHMARKS=OFF) >/dev/null
built=$work/tree/build/release
build() { cmake --build "$built" --target "test_$1" >"$work/log" 2>&1 || { tail -n 30 "$work/log"; exit 2; }; }
passes() { timeout 120 "$built/bin/test_$1" >"$work/log" 2>&1; } # some errors make a loop endless

for program in $(cut -d '|' -f 4 <<<"$laws$files" | sort -u); do # each error is the only reason to fail
  build "$program"
  passes "$program" || { tail -n 30 "$work/log"; exit 2; }
done
missed=0
while IFS='|' read -r file old new program error; do
  [ -n "$file" ] || continue
  original=$(cat "$work/tree/$file"; printf x)
  text=${original%x}
  if [ "${text/"$old"/}" = "$text" ]; then
    echo "there is no \"$old\" in $file any more" >&2
    exit 2
  fi
  printf '%s' "${text/"$old"/"$new"}" >"$work/tree/$file"
  build "$program"
  if passes "$program"; then
    echo "NOT caught: $error ($file: $new)"
    missed=1
  else
    echo "caught: $error, by $(grep -c '^\[  FAILED  \] [A-Z].*ms)$' "$work/log" || true) tests that ended"
  fi
  printf '%s' "$text" >"$work/tree/$file"
done <<<"$laws$files"
exit $missed
