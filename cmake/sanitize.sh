#!/usr/bin/env bash
# sanitize.sh [PRESET [REGEX [TARGET...]]]: builds the tests with a sanitizer (preset asan-ubsan or
# tsan), all of them or the targets named, runs those whose names match REGEX (all of them without
# one), and writes what became of each to build/PRESET/result.txt. An hour or two on two cores; tsan
# is best run in parts:
#
#   cmake/sanitize.sh                                    everything with asan and ubsan
#   cmake/sanitize.sh tsan 'ManyThreads|CoverMesh|Property'
#   cmake/sanitize.sh asan-ubsan 'Weld|NodeEdges' unit_region
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-asan-ubsan}
regex=${2:-.}
targets=("${@:3}")
cmake --preset "$preset" -DCOVER_UNITY_BUILD=ON >/dev/null
cmake --build --preset "$preset" ${targets[@]+--target "${targets[@]}"}
result=build/$preset/result.txt
status=0
# A sanitizer's dlopen does not look where the program says that its modules are.
LD_LIBRARY_PATH=$PWD/build/$preset/apps/cover TSAN_OPTIONS=ignore_noninstrumented_modules=1 ctest --test-dir "build/$preset" -R "$regex" -LE solvers \
  --output-on-failure --timeout 3600 >"$result" 2>&1 || status=$?
echo "$(git rev-parse --short HEAD), $preset, tests matching '$regex':" | tee -a "$result"
grep -E 'tests passed|\(Failed\)|\(Timeout\)|SEGFAULT' "$result" || true
exit "$status"
