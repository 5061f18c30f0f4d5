#!/bin/sh
# Reconstructs M83 from the embedded mock data and draws the six views of the paper's figure.
# Usage: Examples/demo.sh [--gui] [OUTPUT_FOLDER]
# With --gui the same scene opens in ParaView's window instead.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
gui=no
case "${1:-}" in
  --gui)
    gui=yes
    [ -n "${DISPLAY:-}" ] || { echo "--gui needs a display, but DISPLAY is not set; leave --gui out for pictures as files." >&2; exit 1; }
    shift
    ;;
  -*)
    sed -n '2,4s/^# //p' "$0"
    exit 0
    ;;
esac
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
