#!/bin/sh
# Installs what the tests need, builds, and runs every test; ends with ctest's closing lines.
# Usage: Testing/test.sh [arguments for ctest, such as -R Seeds]
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
build="${GALAXY_BUILD_DIR:-$root/build-tests}"

"$root/Plugin/install-dependencies.sh" --tests
GALAXY_BUILD_DIR="$build" "$root/Plugin/build.sh" --tests
# Two tests at a time share the cores: a thread that waits is not to take one from the other.
export OMP_WAIT_POLICY="${OMP_WAIT_POLICY:-passive}"
ctest --test-dir "$build" --output-on-failure -j 2 "$@"
