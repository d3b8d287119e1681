#!/usr/bin/env bash
# Installs what is missing, builds cover and runs its whole test suite.
set -euo pipefail
cd "$(dirname "$0")/.."
bash cmake/install_dependencies.sh
cmake --preset release
cmake --build --preset release
ctest --preset release -j "$(nproc)"
