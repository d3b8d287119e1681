#!/usr/bin/env bash
# Installs what is missing, builds cover and runs its whole test suite.
set -euo pipefail
cd "$(dirname "$0")/.."
bash cmake/install_dependencies.sh
# A first build compiles whole folders at once; a build folder that is there stays as it was set up.
[ -f build/release/CMakeCache.txt ] || whole=-DCOVER_UNITY_BUILD=ON
# Whoever changes cover reads warnings; whoever only tries it on another compiler is not stopped by them.
[ -z "${CI:-}" ] || strict=-DCMAKE_COMPILE_WARNING_AS_ERROR=ON
cmake --preset release ${whole:-} ${strict:-}
cmake --build --preset release
# The solvers of others that are installed (tests/solvers/install.sh); without them this takes a second.
ctest --test-dir build/release -L solvers --output-on-failure
ctest --preset release -j "$(nproc)"
