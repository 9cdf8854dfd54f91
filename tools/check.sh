#!/usr/bin/env bash
# One of the checks that ./test leaves out. Installs what is missing for it.
#   tools/check.sh dev|asan|tsan     builds with this preset and runs the tests of ./test
#   tools/check.sh tidy              clang-tidy on every source, in large units
#   tools/check.sh fuzz [SECONDS]    each fuzzer from its corpus, for 300 s unless told otherwise
#   tools/check.sh coverage          which lines the tests run
#   tools/check.sh alone             does each source compile alone, with g++ and with clang?
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/setup.sh
check=${1:-}
clang="
clang: the other compiler
"

built() {
  cmake --preset "$check" -DMATRIGRATE_TESTS=ON >/dev/null || die "the build could not be configured"
  cmake --build --preset "$check" -j "$(job_count)" || die "the build failed"
}

# tidied: clang-tidy on each unit of sources; it looks into all files of src, apps, tests and benchmarks (.clang-tidy). Each unit includes
# sources, and so repeats declarations, which is suspicious elsewhere.
tidied() {
  cmake --preset tidy -DMATRIGRATE_TESTS=ON >/dev/null || die "the build could not be configured"
  cmake --build --preset tidy --target matrigrate_build_info >/dev/null
  python3 -c 'import json; print(*sorted({one["file"] for one in json.load(open("build/tidy/compile_commands.json")) if "header_sets" not in one["file"] and "structure/headers" not in one["file"]}), sep="\0", end="")' |
    xargs -0 -n 1 -P "$(job_count)" clang-tidy --quiet --warnings-as-errors='*' --checks=-bugprone-suspicious-include,-readability-redundant-declaration -p build/tidy ||
    die "clang-tidy found something"
}

# fuzzed SECONDS: new inputs are kept below build/fuzz/found, inputs that fail in build/fuzz/failed-*.
fuzzed() {
  local target name
  export ASAN_OPTIONS=allocator_may_return_null=1:detect_leaks=0 # HDF5 leaks, and asks for memory of any size
  for target in build/fuzz/corpus/*/; do
    name=$(basename "$target")
    mkdir -p "build/fuzz/found/$name"
    say "fuzzing $name for $1 s"
    "build/fuzz/bin/fuzz_$name" -malloc_limit_mb=1000000000 -rss_limit_mb=4096 -max_total_time="$1" -print_final_stats=1 \
      -artifact_prefix="build/fuzz/failed-$name-" "build/fuzz/found/$name" "$target" || die "fuzz_$name found a fault"
  done
}

case $check in
dev | asan | tsan)
  [ "$check" = tsan ] || clang=
  install_packages "$packages_to_build$packages_to_test$clang"
  built
  export TSAN_OPTIONS=suppressions=$PWD/tools/tsan.supp LSAN_OPTIONS=suppressions=$PWD/tools/lsan.supp:print_suppressions=0
  export ASAN_OPTIONS=allocator_may_return_null=1 # HDF5 asks for memory of any size where a file says so
  ctest --preset "$check" -j "$(nproc)"
  ;;
tidy)
  install_packages "$packages_to_build$packages_to_test$clang
clang-tidy: the check
"
  tidied
  ;;
fuzz)
  install_packages "$packages_to_build$packages_to_test$clang"
  built
  fuzzed "${2:-300}"
  ;;
coverage)
  install_packages "$packages_to_build$packages_to_test
gcovr: counts the lines
"
  tools/coverage.sh
  ;;
alone)
  install_packages "$packages_to_build$packages_to_test$clang"
  tools/each_alone.py
  tools/each_alone.py --compiler clang++
  ;;
*)
  die "usage: tools/check.sh dev|asan|tsan|tidy|fuzz|coverage|alone"
  ;;
esac
