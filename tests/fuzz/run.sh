#!/usr/bin/env bash
# run.sh [SECONDS [TARGET...]]: builds the fuzzers (preset fuzz: Debian's clang 14, address and
# undefined-behaviour sanitizers, libstdc++'s assertions, no NDEBUG) and runs each for so long, one
# after the other, from the seeds beside this script. Default: 60 seconds, all targets.
#
#   tests/fuzz/run.sh                        every target, a minute each
#   tests/fuzz/run.sh 1200 vtu vtk vtp vti   the readers of VTK's files, 20 minutes each
#
# The first build takes a quarter of an hour on two cores; ccache keeps it.
#
# What is found goes to build/fuzz/found/TARGET: crash-*, oom-* and timeout-* are faults. Small ones
# belong into tests/fuzz/seeds, where every build replays them.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-60}
shift || true
cmake --preset fuzz -DCOVER_UNITY_BUILD=ON >/dev/null
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
  mapfile -t targets < <(cmake --build --preset fuzz --target help | sed -n 's/^fuzz_\([a-z_0-9]*\): phony.*/\1/p')
fi
cmake --build --preset fuzz --target "${targets[@]/#/fuzz_}"
faults=0
for target in "${targets[@]}"; do
  case $target in
    vtu|vtk|vtp|vti) seeds=stored_$target ;;
    tiff) seeds=tif ;;
    *) seeds=$target ;;
  esac
  found=build/fuzz/found/$target
  mkdir -p "$found/corpus"
  echo "== $target"
  # With sanitizers meshing takes 25 times as long; what takes long without them is a fault there.
  case $target in
    hostile|mesh) longest=200 ;;
    *) longest=25 ;;
  esac
  # Seeds that are longer would be cut off, and HDF5 has no file as short as the others.
  case $target in
    stored_vtkhdf) most=32768 ;;
    *) most=4096 ;;
  esac
  build/fuzz/tests/fuzz/fuzz_"$target" -max_total_time="$seconds" -max_len="$most" -timeout="$longest" \
    -rss_limit_mb=2048 -malloc_limit_mb=512 -print_final_stats=1 -artifact_prefix="$found/" \
    "$found/corpus" "tests/fuzz/seeds/$seeds" >"$found/log" 2>&1 || { faults=$((faults + 1)); tail -20 "$found/log"; }
  grep -E 'number_of_executed_units|peak_rss_mb' "$found/log" || true
done
exit $((faults > 0))
