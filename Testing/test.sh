#!/bin/sh
# Installs what the tests need, builds, and runs every test; ends with ctest's closing lines.
# Usage: Testing/test.sh [arguments for ctest, such as -R Seeds]
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
build="${GALAXY_BUILD_DIR:-$root/build-tests}"

"$root/Plugin/install-dependencies.sh" --tests
GALAXY_BUILD_DIR="$build" "$root/Plugin/build.sh" --tests
ctest --test-dir "$build" --output-on-failure -j 2 "$@"
