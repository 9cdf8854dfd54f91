#!/usr/bin/env bash
# Which lines of src/ do the tests run? Builds the unit tests and those of the program with gcc's counters (preset
# coverage), runs them, and prints for each folder of src/ how many of its lines ran, then each source of which less than
# 80 % did. tests/physics, which runs whole simulations, is not counted. Needs Debian's gcovr.
#   tools/coverage.sh [--counted]      --counted: only prints what the last tests came to
# build/coverage/lines/index.html shows the lines of each source.
set -euo pipefail
cd "$(dirname "$0")/.."
build=build/coverage
failed=0
tests=$(find tests/unit -mindepth 1 -maxdepth 1 -type d -printf "test_%f\n" | sort)
if [ "${1:-}" != --counted ]; then
  cmake --preset coverage -DMATRIGRATE_TESTS=ON >/dev/null
  # shellcheck disable=SC2086
  cmake --build --preset coverage --target $tests test_apps
  find $build -name '*.gcda' -delete # what the build itself has run
  ctest --test-dir $build -L '^(unit|end-to-end)$' -E '^readers' -j "$(nproc)" --output-on-failure || failed=1 # counted all the same
fi
mkdir -p $build/lines
gcovr --root . --filter src/ $build -j "$(nproc)" --json-summary $build/lines.json --html-details $build/lines/index.html
python3 - $build/lines.json <<'END'
import collections, json, sys

folders, sources = collections.defaultdict(lambda: [0, 0]), []
for file in json.load(open(sys.argv[1]))["files"]:
    ran, all_lines = file["line_covered"], file["line_total"]
    folder = folders[file["filename"].split("/")[1]]
    folder[0] += ran
    folder[1] += all_lines
    if ran < 0.8 * all_lines:
        sources.append(f"{file['filename']}: {ran} of {all_lines}")
folders["all"] = [sum(numbers) for numbers in zip(*folders.values())]
print("| folder | lines | ran |\n|---|---|---|")
for name, (ran, all_lines) in folders.items():
    print(f"| `{name}` | {all_lines} | {100 * ran / all_lines:.1f} % |")
print("\nLess than 80 %:", *(sources or ["none"]), sep="\n")
END
exit $failed
