# Measures the light: how it grows with radius in the image plane, against the FITS image itself.
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import numpy as np
from astropy.io import fits
from astropy.wcs import WCS
from cookbook import M83_FOLDER, SCALE, SIZE, gp, image

RA, DEC, RINGS = 204.25383, -29.86576, os.path.join(M83_FOLDER, "m83.rings")
FULL, KPC = 9.0, 4900 * np.pi / 180  # the value of intensity 1; kpc that a degree spans
with open("light.galaxy", "w", encoding="utf-8") as file:
    file.write(f"""
galaxy = {{ name = "M83", ra = {RA}, dec = {DEC}, distance = 4.9, rings = "{RINGS}" }}
image = {{ red = {{ file = "{image('r')}" }} }}
component = [{{ name = "stars", layers = [{{ image = "red", clip = [0.0, {FULL}] }}] }}]
""")
half = 12.0  # kpc
radiance = gp.render(gp.build_galaxy("light.galaxy", SCALE), gp.sky_camera(half), SIZE)[..., 0]
kpc = 2 * half / SIZE
y, x = (np.indices(radiance.shape) + 0.5) * kpc - half
with fits.open(image("r")) as file:
    values, wcs = np.clip(file[0].data.astype(float), 0, FULL), WCS(file[0].header)
column, row = wcs.wcs_world2pix(RA, DEC, 0)
side = KPC * abs(wcs.wcs.cdelt[0])
v, u = (np.indices(values.shape) - np.reshape([row, column], (2, 1, 1))) * side
rows = [(r, radiance[np.hypot(x, y) < r].sum() * kpc**2,
         values[np.hypot(u, v) < r].sum() * side**2 / FULL) for r in (1, 2, 4, 6, 8, 10)]
np.savetxt("light.csv", rows, "%g", ",", header="radius (kpc),model,image (intensity kpc^2)")
for r, model, measured in rows:
    print(f"within {r:2g} kpc: model {model:8.3f}, image {measured:8.3f}, {model / measured:.3f}")
