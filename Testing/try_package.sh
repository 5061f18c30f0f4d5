#!/bin/sh
# Tries the Debian package in a fresh Debian: apt finds its dependencies, pvpython finds the plugin by
# its name and draws, and after removal nothing of it is left. Needs root, a network and debootstrap.
# Usage: Testing/try_package.sh PACKAGE.deb NEW_FOLDER
set -eu
package="$1"
root="$2"
[ ! -e "$root" ] || { echo "$root is there already" >&2; exit 1; }

in_root() { env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C DEBIAN_FRONTEND=noninteractive HOME=/root \
  chroot "$root" "$@"; }
install_in_root() { in_root apt-get install -y -q --no-install-recommends "$@"; }
traces() { find "$root/usr" "$root/etc" \( -iname "*galaxyreconstruction*" -o -name paraview.conf \); }

debootstrap --variant=minbase bookworm "$root" http://deb.debian.org/debian
mount --bind /proc "$root/proc"
mount --bind /dev "$root/dev"
trap 'umount "$root/proc" "$root/dev"' EXIT
install_in_root python3-paraview xvfb xauth

cp "$package" "$root/root/package.deb"
install_in_root /root/package.deb
cat >"$root/root/try.py" <<'SCRIPT'
from paraview.simple import *
LoadDistributedPlugin("GalaxyReconstruction", ns=globals())
view = CreateView("RenderView", ViewSize=[200, 200])
display = Show(Spheroid(NumberOfParticles=20000), view)
assert str(display.Representation).strip("'") == "Splats"
SaveScreenshot("/root/try.png", view, ImageResolution=[200, 200])
SCRIPT
in_root xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvpython /root/try.py
[ -s "$root/root/try.png" ]

in_root apt-get remove -y -q paraview-galaxyreconstruction
left=$(traces)
[ -z "$left" ] || { echo "left behind: $left" >&2; exit 1; }
echo "The package comes, works and goes."
