"""ParaView's own window: starts `paraview` with the M83 scene and photographs it."""
import os
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np
from PIL import Image

import galaxy_testing as gt

PATIENCE = 120  # seconds until the galaxy must be seen
ENOUGH = 1000  # pixels


def photograph(path):
    subprocess.run(["import", "-window", "root", path], check=True, timeout=60)
    with Image.open(path) as image:
        return np.asarray(image.convert("RGB"), dtype=float) / 255


def galaxy_pixels(picture):
    """How many pixels are warm starlight, and none where the view is not dark."""
    red, green, blue = (picture[..., c] for c in range(3))
    warm = (red > 0.35) & (red > green) & (green > blue + 0.03) & (red < blue + 0.6)
    view = picture[200:700, 320:1130]
    sky = (view.max(axis=2) < 0.15).mean()
    return int(warm[200:700, 320:1130].sum()) if sky > 0.3 else 0


def main():
    for tool in ("paraview", "import"):
        if not shutil.which(tool):
            gt.skip(f"{tool} is not installed")
    home = tempfile.mkdtemp()
    shot = os.path.join(gt.output_folder(), "window.png")
    log = open(os.path.join(gt.output_folder(), "window.log"), "w", encoding="utf-8")
    window = subprocess.Popen(
        ["paraview", "--dr", f"--script={os.path.join(gt.ROOT, 'Examples', 'm83_window.py')}"],
        env=dict(os.environ, HOME=home, GALAXY_PARTICLE_SCALE="0.1",
                 GALAXY_EXAMPLES=os.path.join(gt.ROOT, "Examples")), stdout=log, stderr=log,
    )
    try:
        start, lit = time.time(), 0
        while time.time() - start < PATIENCE and lit < ENOUGH and window.poll() is None:
            time.sleep(3)
            lit = galaxy_pixels(photograph(shot))
        print(f"{lit} lit pixels after {time.time() - start:.0f} s; {shot}")
        if window.poll() is not None:
            sys.exit(f"paraview ended by itself with {window.returncode}; see window.log")
        if lit < ENOUGH:
            sys.exit("the galaxy is not seen in the window")
    finally:
        window.kill()
        window.wait()
        shutil.rmtree(home, ignore_errors=True)


if __name__ == "__main__":
    main()
