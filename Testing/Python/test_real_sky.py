"""The examples on real images, where those are present; skipped, saying so, where not.

The folder is GALAXY_REAL_DATA, or shared/data beside the checkout.
"""
import os
import subprocess
import sys

import numpy as np
from PIL import Image

import galaxy_testing as gt


def light(path):
    with Image.open(path) as image:
        return np.asarray(image.convert("L"), dtype=float) / 255


def check(name, folder, output, faintest=0.01):
    script = os.path.join(gt.ROOT, "Examples", f"real_{name}.py")
    subprocess.run(["pvpython", script, folder, output], check=True)
    seen = {
        view: light(os.path.join(output, f"real-{name}-{view}.png"))
        for view in ("from-earth", "face-on", "edge-on")
    }
    size = seen["face-on"].shape[0]
    for view, picture in seen.items():
        assert picture.mean() > faintest, f"{name} {view} is dark"
    # Edge-on, a thin disc: nearly all light within a tenth of the height about the middle.
    edge = seen["edge-on"][size // 16 : -size // 16]  # without the writing
    lane = edge[len(edge) // 2 - size // 20 : len(edge) // 2 + size // 20]
    share = lane.sum() / edge.sum()
    print(f"{name}: share of the edge-on light in the disc: {share:.2f}")
    assert share > 0.8, f"{name} is not a thin disc edge-on"
    return seen


def spread(picture):
    """The light's rms extent along its longer and its shorter axis, pixels, and the longer one's
    position angle, degrees from up through left."""
    size = picture.shape[0]
    edge = size // 16  # without the writing
    light = picture[edge:-edge, edge:-edge]
    y, x = np.indices(light.shape) - (len(light) - 1) / 2
    moments = np.cov(np.array([-x.ravel(), -y.ravel()]), aweights=light.ravel())
    values, axes = np.linalg.eigh(moments)
    angle = np.degrees(np.arctan2(axes[0, 1], axes[1, 1])) % 180
    return np.sqrt(values[1]), np.sqrt(values[0]), angle


def check_hydrogen(data, output):
    """NGC 2903: the rings' position angle is 202 to 211 degrees, their inclination 65.6."""
    seen = check("ngc2903", data, output, faintest=0.005)
    long, short, angle = spread(seen["from-earth"])
    print(f"ngc2903 from Earth: {long:.0f} x {short:.0f} pixels at {angle:.0f} degrees")
    assert abs(angle - 24) < 6, "not along the major axis"
    assert 0.35 < short / long < 0.6, "not as inclined as the rings"
    long, short, _ = spread(seen["face-on"])
    print(f"ngc2903 face-on: {long:.0f} x {short:.0f} pixels")
    assert short / long > 0.8, "not round face-on"
    for view in ("from-earth", "face-on"):
        size = len(seen[view])
        r = np.hypot(*(np.indices(seen[view].shape) - (size - 1) / 2)) / size
        middle, outside = seen[view][r < 0.1].mean(), seen[view][(r > 0.4) & (r < 0.43)].mean()
        print(f"ngc2903 {view}: middle {middle:.2f}, outside {outside:.3f}")
        assert middle > 5 * outside, "the middle is not bright"


def main():
    data = os.environ.get("GALAXY_REAL_DATA", os.path.join(gt.ROOT, "..", "shared", "data"))
    if not os.path.isdir(os.path.join(data, "M51")):
        gt.skip(f"no real images in {data}")
    output = gt.output_folder()
    check("m83", os.path.join(data, "M83"), output)
    check_hydrogen(os.path.join(data, "NGC2903"), output)
    edge = check("m51", os.path.join(data, "M51"), output)["edge-on"]
    # A dust lane: the middle plane is darker than the stars above and below it.
    size = edge.shape[0]
    columns = edge[:, size // 2 - size // 8 : size // 2 + size // 8].mean(axis=1)
    middle = columns[size // 2 - 1 : size // 2 + 1].mean()
    brightest = columns[size // 2 - size // 20 : size // 2 + size // 20].max()
    print(f"m51: middle plane {middle:.2f}, brightest beside it {brightest:.2f}")
    assert middle < 0.6 * brightest, "no dust lane in M51 edge-on"


if __name__ == "__main__":
    try:
        main()
    except AssertionError as failure:
        sys.exit(str(failure))
