#!/usr/bin/env bash
# Installs what is missing, builds cover and runs its whole test suite.
set -euo pipefail
cd "$(dirname "$0")/.."
bash cmake/install_dependencies.sh
# A first build compiles whole folders at once; a build folder that is there stays as it was set up.
[ -f build/release/CMakeCache.txt ] || whole=-DCOVER_UNITY_BUILD=ON
cmake --preset release ${whole:-}
cmake --build --preset release 2>&1 | tee build/release/build.log
# Whoever changes cover mends warnings; whoever only tries it with another compiler is not stopped by them.
if [ -n "${CI:-}" ] && grep -n 'warning:' build/release/build.log; then
  echo "cmake/test.sh: the build has warnings" >&2
  exit 1
fi
# The solvers of others that are installed (tests/solvers/install.sh); without them this takes a second.
ctest --test-dir build/release -L solvers --output-on-failure
ctest --preset release -j "$(nproc)"
