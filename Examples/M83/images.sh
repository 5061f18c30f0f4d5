#!/bin/sh
# Makes the mock images of M83 in images/ beside this file, where they are absent or older than
# what makes them.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
done="$here/images/complete"
if [ -f "$done" ] && [ -z "$(find "$here" -name '*.py' -newer "$done")" ]; then
  echo "Mock images of M83: already in $here/images"
  exit 0
fi
echo "Making the mock images of M83 in $here/images"
/usr/bin/python3 "$here/make_images.py" "$here/images"
touch "$done"
