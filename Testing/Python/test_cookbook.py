"""The recipes of Examples/Cookbook, each run as a reader runs it, small, and what it wrote is checked.

Usage: pvpython test_cookbook.py RECIPE, its name without .py
"""
import csv
import os
import runpy
import shutil
import sys

import numpy as np
from PIL import Image

import galaxy_testing as gt

SIZE = 200
FOLDER = os.path.join(gt.ROOT, "Examples", "Cookbook")


def panels(name, columns, rows=1):
    """The panels of a picture, row by row, without their titles, notes and scale bars."""
    with Image.open(name) as image:
        picture = np.asarray(image.convert("RGB"), dtype=float) / 255
    if picture.shape[:2] != (rows * SIZE, columns * SIZE):
        raise AssertionError(f"{name} is {picture.shape}")
    tiles = picture.reshape(rows, SIZE, columns, SIZE, 3).transpose(0, 2, 1, 3, 4)
    return [tile[SIZE // 8 : -SIZE // 8] for row in tiles for tile in row]


def height(panel):
    """Root mean square height of the light about its middle, in pixels."""
    light = panel.mean(axis=(1, 2))
    y = np.arange(len(light))
    middle = np.average(y, weights=light)
    return np.sqrt(np.average((y - middle) ** 2, weights=light))


def table(name):
    with open(name, encoding="utf-8") as file:
        return list(csv.reader(file))[1:]


def one_image():
    earth, side = panels("one_image.png", 2)
    assert earth.max() > 0.8 and height(side) < 0.4 * height(earth)
    red, _, blue = side.reshape(-1, 3).mean(axis=0)
    assert red > 1.3 * blue  # starlight


def six_views():
    far_face, _, far_edge, face, angled, edge = panels("six_views.png", 3, 2)
    assert height(edge) < 0.5 * height(angled) < 0.6 * height(face)
    assert height(far_edge) < 0.8 * height(far_face)
    red, _, blue = far_face.reshape(-1, 3).mean(axis=0)
    assert blue > 1.5 * red  # hydrogen


def dust_on_and_off():
    dusty, clear = panels("dust_on_and_off.png", 2)
    assert clear.mean() > 0.05 and dusty.mean() < 0.8 * clear.mean()
    ratio = [np.mean(dusty[..., c]) / np.mean(clear[..., c]) for c in (0, 2)]
    assert ratio[1] < ratio[0]  # dust reddens


def only_hydrogen():
    means = [panel.mean() for panel in panels("only_hydrogen.png", 3)]
    assert means == sorted(means) and means[2] > 2 * means[0] > 0
    for panel in panels("only_hydrogen.png", 3):
        assert np.all(panel[..., 2] >= panel[..., 0])


def light_against_fits():
    rows = np.array(table("light.csv"), dtype=float)
    assert len(rows) == 6 and np.all(np.diff(rows, axis=0) > 0)
    # Smoothing takes light across the edge of a small circle.
    np.testing.assert_allclose(rows[2:, 1], rows[2:, 2], rtol=0.02)
    np.testing.assert_allclose(rows[:2, 1], rows[:2, 2], rtol=0.2)


def export():
    with open("export.txt", encoding="utf-8") as file:
        counts = {line.split(":")[0]: int(line.split()[1]) for line in file}
    assert set(counts) == {"PartType0", "PartType2", "PartType3", "PartType4", "PartType5"}
    assert sum(counts.values()) == len(table("m83.csv")) > 10000


def bulge():
    def concentration(panel):
        y, x = np.indices(panel.shape[:2]) - np.reshape([n / 2 for n in panel.shape[:2]], (2, 1, 1))
        r, light = np.hypot(x, y), panel.mean(axis=2)
        return light[r < SIZE / 40].mean() / light[(r > SIZE / 10) & (r < SIZE / 7)].mean()

    gaussian, sersic, hernquist, plummer = map(concentration, panels("bulge.png", 4))
    assert min(sersic, hernquist) > 1.5 * plummer and plummer > 1.2 * gaussian > 1.2


def group():
    earth, north = panels("group.png", 2)
    assert earth.max() > 0.8
    lit = north.max(axis=(1, 2)) > 0.15
    assert np.count_nonzero(np.diff(lit.astype(int)) == 1) >= 3  # galaxies at several distances


def figure():
    light = np.load("edge_on.npy")
    assert light.shape == (SIZE, SIZE, 3)
    profile = light[:, SIZE // 2 - 10 : SIZE // 2 + 10, 1].mean(axis=1)
    middle = profile[SIZE // 2 - 1 : SIZE // 2 + 1].mean()
    assert 0 < middle < 0.7 * profile.max()  # the dust lane
    with Image.open("figure.png") as image:
        assert image.size == (1200, 504)


def accuracy():
    rows = {level: (float(seconds), float(error)) for level, seconds, error in table("accuracy.csv")}
    assert rows["Sorted"][1] == 0 < rows["Bounded"][1] <= 1 / 512 < rows["Preview"][1]
    assert all(seconds > 0 for seconds, _ in rows.values())


def main(recipe):
    folder = os.path.join(gt.output_folder(), recipe)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    os.chdir(folder)
    # A preview of few particles would be of all of them.
    scale = "0.1" if recipe.endswith("accuracy") else "0.03"
    os.environ.update(GALAXY_PARTICLE_SCALE=scale, GALAXY_PICTURE_SIZE=str(SIZE))
    runpy.run_path(os.path.join(FOLDER, recipe + ".py"), run_name="__main__")
    globals()[recipe.partition("_")[2]]()
    print("What it wrote is in " + folder)


if __name__ == "__main__":
    main(sys.argv[1])
