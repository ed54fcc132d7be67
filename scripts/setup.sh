#!/usr/bin/env bash
# Sets up a fresh Debian 12 or Ubuntu machine, builds mapwright and runs the main job on the bundled
# sample. Asks for nothing; installs only what is missing.
# Usage: scripts/setup.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install_packages.sh
cmake --preset release -D MAPWRIGHT_BUILD_TESTS=OFF -D MAPWRIGHT_BUILD_BENCHMARKS=OFF
cmake --build build/release --parallel "$(nproc)"
scripts/run_sample.sh
