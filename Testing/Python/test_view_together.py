"""Several Splats representations in one view, and several views. Needs a display."""
import os
import unittest

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import galaxy_testing as gt
from view_testing import G0, H, SIZE, ViewTest

gt.load_plugin()
MIDDLE = (SIZE // 2, SIZE // 2)


class Together(ViewTest):
    def stars(self):
        """A red one before the origin and a blue one behind it."""
        light = np.array([[0.6, 0, 0], [0, 0, 0.6]], dtype=np.float32)
        return gt.particles([[0, 0, 1], [0, 0, -1]], [H, H], Emission=light)

    def test_dust_of_another_representation_dims_what_is_behind_it(self):
        for dust_first in (True, False):
            sources = [self.absorber((1, 1, 1)), self.stars()]
            for source in sources if dust_first else sources[::-1]:
                self.show(source)
            self.keep_camera()
            dimmed = self.shot()[MIDDLE]
            np.testing.assert_allclose(dimmed, [0.6, 0, 0.6 * np.exp(-1)], atol=0.01)
            simple.Hide(sources[0], self.view)
            np.testing.assert_allclose(self.shot()[MIDDLE], [0.6, 0, 0.6], atol=0.01)
            simple.Show(sources[0], self.view)
            np.testing.assert_allclose(self.shot()[MIDDLE], dimmed, atol=1e-3)
            for source in sources:
                simple.Delete(source)

    def test_each_has_its_own_exposure_and_components(self):
        left = self.show(self.emitter((-1, 0, 0), (0.8, 0, 0)))
        right = self.show(self.emitter((1, 0, 0), (0, 0.8, 0)))
        self.keep_camera()
        at_left, at_right = (SIZE // 2, SIZE // 4), (SIZE // 2, 3 * SIZE // 4)

        def seen():
            picture = self.shot()
            return picture[at_left][0], picture[at_right][1]

        np.testing.assert_allclose(seen(), [0.8, 0.8], atol=0.02)
        right.Exposure = 0.5 / G0
        np.testing.assert_allclose(seen(), [0.8, 0.4], atol=0.02)
        left.Exposure = 0.5 / G0
        np.testing.assert_allclose(seen(), [0.4, 0.4], atol=0.02)
        left.ComponentBrightness = ["", "2"]
        np.testing.assert_allclose(seen(), [0.8, 0.4], atol=0.02)
        simple.Hide(left.Input, self.view)
        np.testing.assert_allclose(seen(), [0, 0.4], atol=0.02)

    def test_galaxies_at_one_place_that_the_sky_has_apart_are_said_to_be(self):
        galaxy = ("[galaxy]\nname = '{}'\nra = {}\ndec = 20\ndistance = 5\n[[component]]\nname = 'a'\n"
                  "particles = 500\nprofile = 'Exponential'\n")

        def model(name, ra):
            path = gt.written(name + ".galaxy", galaxy.format(name, ra))
            return simple.GalaxyModel(Input=simple.GalaxyReader(FileName=path))

        one = self.show(model("One", 10))
        self.show(model("One", 10))
        with gt.Messages() as messages:
            self.shot()
        self.assertEqual(messages.text, "")
        self.show(model("Other", 11))
        with gt.Messages() as messages:
            self.shot()
            self.view.CameraPosition = [0, 0, 30]
            self.shot()
        self.assertEqual(messages.text.count("One, Other stand in one place"), 1, messages.text)
        self.assertIn(".galaxygroup", messages.text)
        one.UpdatePropertyInformation()
        self.assertIn("One, Other stand in one place", str(one.ActiveEffects))

    def test_a_mixture_of_arrays(self):
        """Stars by Intensity and Color behind dust by Absorption."""
        star = gt.particles(
            [[0, 0, -1]], [H], Intensity=np.array([0.8], dtype=np.float32),
            Color=np.array([[255, 0, 255]], dtype=np.uint8),
        )
        display = self.show(star)
        self.show(self.absorber((0.5, 1, 2)))
        self.keep_camera()
        expected = 0.8 * np.exp([-0.5, 0, -2]) * [1, 0, 1]
        np.testing.assert_allclose(self.shot()[MIDDLE], expected, atol=0.01)
        display.UpdatePropertyInformation()
        self.assertIn("1 absorber", str(display.ActiveEffects))

    def test_a_large_screenshot_in_tiles(self):
        """Each of its tiles sees one of them only, and the first of them not always."""
        self.show(self.emitter((-1.3, 1.3, 0), (0.9, 0.2, 0)))
        self.show(self.emitter((1.3, -1.3, 0.5), (0, 0.9, 0.2)))
        self.keep_camera()
        small = self.shot()
        averaged = self.shot(4 * SIZE).reshape(SIZE, 4, SIZE, 4, 3).mean(axis=(1, 3))
        self.assertGreater(small.max(), 0.8)
        self.assertLess(np.abs(averaged - small).max(), 0.03)

    def test_labels_of_a_group(self):
        path = os.path.join(gt.ROOT, "Examples", "M83Group", "m83group.galaxygroup")
        group = simple.GalaxyGroup(FileName=path, ParticleScale=0.002)
        display = self.show(group, Exposure=0)
        places = gt.array(group, "MemberPosition", "field")
        particles = gt.array(group, "Component")
        points = vtk_to_numpy(servermanager.Fetch(group).GetPoints().GetData())
        np.testing.assert_allclose(gt.array(group, "MemberMagnification", "field"), [1, 5, 5, 5, 5])
        last = points[particles == particles.max()]  # all of the last member
        self.assertLess(np.linalg.norm(last.mean(axis=0) - places[-1]), 2.0)
        self.view.CameraParallelScale = 400
        self.view.CameraFocalPoint = [*places[-1][:2], 0]
        self.view.CameraPosition = [*places[-1][:2], 1e4]
        self.assertEqual(self.shot().max(), 0)
        display.Labels = 1
        for size in (SIZE, 2 * SIZE):
            rows, columns = np.nonzero(self.shot(size).max(axis=2) > 0.5)
            below = (rows > size // 2) & (rows < 0.65 * size)
            self.assertGreater(below.sum(), 50)
            self.assertAlmostEqual(columns[below].mean(), size / 2, delta=0.06 * size)

    def test_two_views_with_cameras_of_their_own(self):
        source = self.stars()
        self.show(source)
        self.show(self.absorber((1, 1, 1)))
        self.keep_camera()
        other = simple.CreateView("RenderView")
        self.addCleanup(simple.Delete, other)
        first, self.view = self.view, other
        other.ViewSize = [SIZE, SIZE]
        other.UseColorPaletteForBackground, other.Background = 0, [0, 0, 0]
        self.show(source)
        other.CameraParallelProjection, other.CameraParallelScale = 1, 2.0
        other.CameraPosition, other.CameraFocalPoint = [0, 0, -5], [0, 0, 0]
        np.testing.assert_allclose(self.shot()[MIDDLE], [0.6, 0, 0.6], atol=0.01)
        self.view = first
        np.testing.assert_allclose(self.shot()[MIDDLE], [0.6, 0, 0.6 * np.exp(-1)], atol=0.01)


if __name__ == "__main__":
    unittest.main()
