"""M83 against a stored picture, with controls that a lost component and a wrong order must fail.

With --write the stored picture is made anew; look at it before you keep it.
"""
import os
import sys
import unittest

import numpy as np
from paraview import simple
from PIL import Image

import galaxy_pictures as gp
import galaxy_testing as gt

gt.load_plugin()
BASELINE = os.path.join(gt.ROOT, "Testing", "Data", "m83-angled.png")
SIZE = 160
HALF_WIDTH = 9.0
TOLERANCE = 1.0  # in 8-bit steps; the controls below change the picture by far more


def camera(axes, behind=False):
    view = gp.orbit_camera(axes, 70, 30, HALF_WIDTH)
    del view["CameraViewAngle"]
    view.update(CameraParallelProjection=1, CameraParallelScale=HALF_WIDTH)
    if behind:
        view["CameraPosition"] = [-c for c in view["CameraPosition"]]
    return view


def difference(first, second):
    """The largest mean difference of any block of 8 x 8 pixels."""
    change = np.abs(np.asarray(first, dtype=float) - np.asarray(second, dtype=float))
    return change.reshape(SIZE // 8, 8, SIZE // 8, 8, 3).mean(axis=(1, 3, 4)).max()


class Picture(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        reader = simple.GalaxyReader(FileName=gt.M83)
        cls.model = simple.GalaxyModel(Input=reader, ParticleScale=0.05)
        cls.model.UpdatePipeline()
        cls.axes = gp.disk_axes(cls.model)

    def picture(self, behind=False, hidden=()):
        radiance = gp.render(self.model, camera(self.axes, behind), SIZE, hidden)
        return gp.tone_map(radiance, 0.5)

    def test_matches_the_stored_picture(self):
        if "--write" in sys.argv:
            self.picture().save(BASELINE)
        self.assertLess(difference(self.picture(), Image.open(BASELINE)), TOLERANCE)

    def test_every_component_counts(self):
        baseline = Image.open(BASELINE)
        for name in ("stars", "young stars", "gas", "dust", "bulge"):
            without = difference(self.picture(hidden=(name,)), baseline)
            print(f"without {name}: {without:.2f}")
            self.assertGreater(without, 3 * TOLERANCE, name)

    def test_the_order_counts(self):
        """Seen from behind and mirrored, the same particles come in the opposite order."""
        reversed_order = self.picture(behind=True).transpose(Image.FLIP_LEFT_RIGHT)
        found = difference(reversed_order, Image.open(BASELINE))
        print(f"reversed order: {found:.2f}")
        self.assertGreater(found, 3 * TOLERANCE)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
