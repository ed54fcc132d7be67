#!/usr/bin/env bash
# Builds everything and runs all tests. Installs missing packages first; asks for nothing.
# Usage: scripts/test.sh [CTEST-OPTION...]    for example: scripts/test.sh -R Picture
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
jobs=$(nproc)

scripts/install_packages.sh
cmake --preset dev
cmake --build build/dev --parallel "$jobs"
ctest --preset dev --parallel "$jobs" "$@"
