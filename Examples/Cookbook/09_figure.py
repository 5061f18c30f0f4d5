# A figure in linear light, without a display: edge-on surface brightness, and how it falls with height.
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import matplotlib
import numpy as np
from cookbook import M83, SCALE, SIZE, gp

matplotlib.use("Agg")
from matplotlib import pyplot

HALF = 8.0  # kpc
model = gp.build_galaxy(M83, SCALE)
camera = gp.orbit_camera(gp.disk_axes(model), 90, 0, HALF)
figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
z = HALF - (np.arange(SIZE) + 0.5) * 2 * HALF / SIZE
for label, hidden in (("with dust", ("gas",)), ("without dust", ("gas", "dust"))):
    light = gp.render(model, camera, SIZE, hidden)
    right.semilogy(z, light[:, 3 * SIZE // 8 : 5 * SIZE // 8, 1].mean(axis=1), label=label)
    if label == "with dust":
        np.save("edge_on.npy", light)  # rows from the top, radiance in red, green and blue
        magnitudes = -2.5 * np.log10(np.maximum(light[..., 1], 1e-6))
        shown = left.imshow(magnitudes, "gray", extent=[-HALF, HALF] * 2, vmin=-1, vmax=9)
figure.colorbar(shown, ax=left, label="green, magnitudes below intensity 1").ax.invert_yaxis()
left.set(xlabel="kpc", ylabel="z (kpc)", title="M83 edge-on, mock data")
right.set(xlabel="z (kpc)", ylabel="radiance, |x| < 2 kpc", xlim=(-3, 3), ylim=(1e-3, None))
right.legend()
figure.savefig("figure.png", dpi=120)
print("wrote figure.png, edge_on.npy")
