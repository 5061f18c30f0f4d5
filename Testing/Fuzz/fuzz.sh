#!/bin/sh
# Builds the fuzzers and lets each read COUNT files that no program would write; stops at the first
# that is anything but read or refused, and says how to repeat it.
# Usage: Testing/Fuzz/fuzz.sh [COUNT [SEED [FILES...]]]    10000 files, seed 1, by default; FILES are
# mutated too.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
build="${GALAXY_BUILD_DIR:-$root/build-fuzz}"
count=${1:-10000}
seed=${2:-1}
[ $# -le 2 ] || { shift 2; files="$*"; }

cmake -S "$root" -B "$build" -G Ninja -DGALAXY_BUILD_PLUGIN=OFF
fuzzers=$(cd "$root/Testing/Fuzz" && ls Fuzz*.cxx | sed 's/\.cxx$//')
cmake --build "$build" -j 2 --target $fuzzers
for fuzzer in $fuzzers; do
  "$build/tests/$fuzzer" "$count" "$seed" ${files:-none}
done
