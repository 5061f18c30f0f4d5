"""Panoramas of SplatImage: M83 from inside, where no seam may be seen."""
import unittest

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import galaxy_pictures as gp
import galaxy_testing as gt

gt.load_plugin()
WIDTH, HEIGHT = 256, 128


def sky(source, eye, at, up, size=(WIDTH, HEIGHT), **properties):
    """Radiance, rows from the bottom up."""
    properties.setdefault("Projection", "Equirectangular")
    picture = simple.SplatImage(
        Input=source, ImageSize=list(size), CameraPosition=list(eye), CameraFocalPoint=list(at),
        CameraViewUp=list(up), **properties)
    picture.UpdatePipeline()
    values = servermanager.Fetch(picture).GetPointData().GetArray("Radiance")
    radiance = vtk_to_numpy(values).reshape(size[1], size[0], 3).astype(float)
    simple.Delete(picture)
    return radiance


def shown(radiance):
    """As displayed, from 0 to 1."""
    return np.asarray(gp.tone_map(radiance, 0.4), dtype=float) / 255


class Panorama(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = simple.GalaxyModel(
            Input=simple.GalaxyReader(FileName=gt.M83), ParticleScale=0.05)
        cls.model.UpdatePipeline()
        cls.a, cls.b, cls.n = gp.disk_axes(cls.model)
        cls.eye = 4 * cls.a + 0.4 * cls.n

    def turned(self, degrees):
        """All the sky with straight ahead turned to the left about the disc's axis."""
        angle = np.radians(degrees)
        ahead = -np.cos(angle) * self.a - np.sin(angle) * self.b
        return sky(self.model, self.eye, self.eye + ahead, self.n)

    def test_turning_the_eye_turns_the_picture_and_no_more(self):
        # Every seam lies elsewhere then: what is left of them would show as a difference.
        step = 45 / 360 * WIDTH
        one, other = self.turned(0), self.turned(45)
        shift = min((np.abs(shown(np.roll(one, s, axis=1)) - shown(other)).mean(), s)
                    for s in (int(step), -int(step)))
        difference = np.abs(shown(np.roll(one, shift[1], axis=1)) - shown(other))
        print(f"turned by 45 degrees: mean {difference.mean():.4f}, largest {difference.max():.3f}")
        self.assertLess(difference.mean(), 0.004)
        self.assertLess(np.quantile(difference, 0.999), 0.06)
        unturned = np.abs(shown(one) - shown(other)).mean()
        self.assertGreater(unturned, 10 * difference.mean())

    def test_the_left_edge_goes_on_at_the_right(self):
        picture = shown(self.turned(10))
        jump = np.abs(picture[:, 0] - picture[:, -1]).mean()
        steps = np.abs(np.diff(picture, axis=1)).mean(axis=(0, 2))
        self.assertLess(jump, 1.5 * steps.max())

    def test_the_middle_of_a_panorama_is_what_a_camera_sees(self):
        at = self.eye - self.a
        size = (64, 64)  # of 12 degrees: there a camera's plane is the sky
        camera = sky(self.model, self.eye, at, self.n, size, Projection="Camera",
                     CameraViewAngle=12)
        dome = sky(self.model, self.eye, at, self.n, size, Projection="Dome", DomeAngle=12)
        inside = np.hypot(*(np.indices(size) - 31.5)) < 30
        np.testing.assert_allclose(dome[inside].mean(), camera[inside].mean(), rtol=0.02)
        difference = np.abs(shown(dome) - shown(camera))[inside]
        self.assertLess(difference.mean(), 0.03)

    def test_where_things_are_on_a_dome(self):
        star = gt.particles([[3, 0, -3]], [0.05], Emission=np.ones((1, 3), np.float32))
        dome = sky(star, [0, 0, 0], [0, 0, -1], [0, 1, 0], (100, 100), Projection="Dome")
        row, column = np.unravel_index(dome[:, :, 0].argmax(), (100, 100))
        self.assertAlmostEqual(column + 0.5, 50 + 25, delta=1)  # 45 of 90 degrees to the right
        self.assertAlmostEqual(row + 0.5, 50, delta=1)

    def test_the_picture_says_what_it_is(self):
        star = gt.particles([[3, 0, -3]], [0.05], Emission=np.ones((1, 3), np.float32))
        picture = simple.SplatImage(
            Input=star, ImageSize=[20, 20], Projection="Dome", DomeAngle=200)
        fields = servermanager.Fetch(picture).GetFieldData()
        self.assertEqual(fields.GetAbstractArray("Projection").GetValue(0), "Dome")
        self.assertEqual(fields.GetArray("DomeAngle").GetTuple1(0), 200)


if __name__ == "__main__":
    unittest.main()
