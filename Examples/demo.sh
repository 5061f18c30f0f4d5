#!/bin/sh
# Reconstructs M83 from the embedded mock data and draws the six views of the paper's figure.
# Usage: Examples/demo.sh [--gui] [OUTPUT_FOLDER]
# With --gui the same scene opens in ParaView's window instead.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
gui=no
if [ "${1:-}" = "--gui" ]; then
  gui=yes
  shift
fi
output="${1:-$here/output}"

"$here/../Plugin/install-dependencies.sh"
echo "Building (only the first time takes minutes)"
"$here/../Plugin/build.sh"
GALAXY_PLUGIN=$("$here/../Plugin/build.sh" | tail -n 1)
GALAXY_EXAMPLES="$here"
export GALAXY_PLUGIN GALAXY_EXAMPLES

"$here/M83/images.sh"

if [ "$gui" = yes ]; then
  exec paraview --script="$here/m83_window.py"
fi
mkdir -p "$output"
exec pvpython "$here/m83.py" "$output"
