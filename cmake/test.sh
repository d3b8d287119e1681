#!/usr/bin/env bash
# Installs what is missing, builds cover and runs its whole test suite.
set -euo pipefail
cd "$(dirname "$0")/.."
bash cmake/install_dependencies.sh
cmake --preset release
cmake --build --preset release
# The solvers of others that are installed (tests/solvers/install.sh); without them this takes a second.
ctest --test-dir build/release -L solvers --output-on-failure
ctest --preset release -j "$(nproc)"
