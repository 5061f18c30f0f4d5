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


def check(name, folder, output):
    script = os.path.join(gt.ROOT, "Examples", f"real_{name}.py")
    subprocess.run(["pvpython", script, folder, output], check=True)
    seen = {
        view: light(os.path.join(output, f"real-{name}-{view}.png"))
        for view in ("from-earth", "face-on", "edge-on")
    }
    size = seen["face-on"].shape[0]
    for view, picture in seen.items():
        assert picture.mean() > 0.01, f"{name} {view} is dark"
    # Edge-on, a thin disc: nearly all light within a tenth of the height about the middle.
    edge = seen["edge-on"][size // 16 : -size // 16]  # without the writing
    lane = edge[len(edge) // 2 - size // 20 : len(edge) // 2 + size // 20]
    share = lane.sum() / edge.sum()
    print(f"{name}: share of the edge-on light in the disc: {share:.2f}")
    assert share > 0.8, f"{name} is not a thin disc edge-on"
    return seen


def main():
    data = os.environ.get("GALAXY_REAL_DATA", os.path.join(gt.ROOT, "..", "shared", "data"))
    if not os.path.isdir(os.path.join(data, "M51")):
        gt.skip(f"no real images in {data}")
    output = gt.output_folder()
    check("m83", os.path.join(data, "M83"), output)
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
