#!/bin/sh
# Configures and builds the plugin (and the tests with --tests) in build/, once; later calls only
# build what changed. Prints the plugin's path as the last line.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
build="${GALAXY_BUILD_DIR:-$root/build}"

testing=OFF
target="GalaxyReconstruction"
if [ "${1:-}" = "--tests" ]; then
  testing=ON
  target="all"
fi
if [ ! -f "$build/build.ninja" ] || ! grep -q "^BUILD_TESTING:BOOL=$testing" "$build/CMakeCache.txt"; then
  echo "Configuring in $build"
  cmake -S "$root" -B "$build" -G Ninja -DBUILD_TESTING="$testing" >"$build.log" 2>&1 ||
    { cat "$build.log" >&2; exit 1; }
  rm -f "$build.log"
fi
cmake --build "$build" --target "$target"
find "$build/lib" -name GalaxyReconstruction.so
