#!/bin/sh
# Installs, with apt, what building, running and testing needs and is not there yet.
# Usage: Plugin/install-dependencies.sh [--tests]
# Says what it does; does nothing, and needs no network, where all is installed.
set -eu

packages="build-essential cmake ninja-build pkg-config
  paraview paraview-dev python3-paraview libopenmpi-dev libglew-dev libeigen3-dev libfreetype-dev
  libcfitsio-dev zlib1g-dev wcslib-dev liberfa-dev libtomlplusplus-dev librandom123-dev libboost-math-dev
  libhdf5-dev libnanoflann-dev libhwy-dev libopenexr-dev
  xvfb xauth python3 python3-numpy python3-astropy python3-pil fonts-dejavu-core libqt5svg5
  qtbase5-dev libqt5opengl5-dev libqt5svg5-dev qttools5-dev qttools5-dev-tools qtxmlpatterns5-dev-tools"
if [ "${1:-}" = "--tests" ]; then
  packages="$packages libgtest-dev libbenchmark-dev clang-format imagemagick xdotool openmpi-bin
    python3-h5py python3-yt python3-matplotlib splash openexr ffmpeg"
fi

missing=""
for package in $packages; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing="$missing $package"
done
if [ -z "$missing" ]; then
  echo "Dependencies: all installed."
  exit 0
fi

as_root=""
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Installing$missing needs root or sudo; use either, or install them by hand." >&2; exit 1; }
  as_root="sudo"
fi
echo "Dependencies: installing$missing"
$as_root apt-get update -q
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
