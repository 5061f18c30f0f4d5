"""Where a display puts particles, what a view makes of those at no place, and other
representations of them."""
import unittest

import numpy as np
from paraview import simple

import galaxy_testing as gt

gt.load_plugin()

from view_testing import H, SIZE, ViewTest


class Placed(ViewTest):
    def picture(self, source, **properties):
        self.show(source, **properties)
        self.keep_camera()
        picture = self.shot()
        simple.Hide(source, self.view)
        return picture

    def test_position_scale_orientation_and_origin(self):
        at = np.array([0.3, 0.1, 0.2])
        source = self.emitter(at, color=(0.5, 0.3, 0.1))
        absorbed = self.absorber(1.0, at)
        x, y, z = at
        cases = (
            ({"Position": [0.5, -0.25, 0.5]}, at + [0.5, -0.25, 0.5], 1),
            ({"Scale": [2, 2, 2]}, 2 * at, 2),
            ({"Orientation": [0, 0, 90]}, [-y, x, z], 1),
            ({"Orientation": [90, 0, 0]}, [x, -z, y], 1),
            ({"Origin": [1, 0, 0], "Scale": [0.5, 0.5, 0.5]}, [1 + (x - 1) / 2, y / 2, z / 2], 0.5),
            ({"UserTransform": [1, 0, 0, 0.4, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]},
             at + [0.4, 0, 0], 1),
            ({"Scale": [-1, 1, 1]}, [-x, y, z], 1),
        )
        plain = self.picture(source)
        for properties, place, scale in cases:
            light = scale**2 * np.array([[0.5, 0.3, 0.1]], np.float32)
            like = self.picture(gt.particles([place], [scale * H], Emission=light))
            self.assertGreater(np.abs(like - plain).max(), 0.05, properties)
            shown = self.picture(self.emitter(at, color=(0.5, 0.3, 0.1)), **properties)
            np.testing.assert_allclose(shown, like, atol=1.5 / 255, err_msg=str(properties))
        self.view.Background = [0.8, 0.8, 0.8]
        dark = self.picture(absorbed)
        self.assertLess(dark.min(), 0.4)
        scaled = self.picture(absorbed, Scale=[2, 2, 2])
        self.assertAlmostEqual(scaled.min(), dark.min(), delta=0.02)
        self.assertGreater((scaled < 0.7).sum(), 3 * (dark < 0.7).sum())

    def test_displays_in_one_view_have_places_of_their_own(self):
        first, second = self.emitter(color=(1, 0, 0)), self.emitter(color=(0, 1, 0))
        self.show(first, Position=[-0.8, 0, 0])
        self.show(second, Position=[0.8, 0, 0])
        self.keep_camera()
        row = self.shot()[SIZE // 2]
        at = [int((x + 2) / 4 * SIZE) for x in (-0.8, 0.8)]
        np.testing.assert_allclose(row[at], [[1, 0, 0], [0, 1, 0]], atol=0.02)
        simple.GetDisplayProperties(second, self.view).Position = [-0.8, 0, 0]
        np.testing.assert_allclose(self.shot()[SIZE // 2][at], [[1, 1, 0], [0, 0, 0]], atol=0.02)

    def reset(self):
        """The camera after Reset Camera; what the view's proxy has is older."""
        simple.Render(self.view)
        self.view.ResetCamera()
        return self.view.GetActiveCamera()

    def test_a_camera_that_is_reset_sees_them(self):
        self.show(self.emitter(), Position=[100, 0, 0], Scale=[3, 3, 3])
        np.testing.assert_allclose(self.reset().GetFocalPoint(), [100, 0, 0], atol=1e-4)
        self.assertGreater(self.shot().max(), 0.5)

    def test_axes_scaled_otherwise_are_refused(self):
        display = self.show(self.emitter(), Scale=[1, 1, 2])
        with gt.Messages() as messages:
            simple.Render(self.view)
        self.assertIn("Scale must be the same along all axes", messages.text)
        display.Scale = [1, 1, 1]
        self.keep_camera()
        self.assertGreater(self.shot().max(), 0.5)

    def test_particles_at_no_place_do_not_move_the_camera(self):
        light = np.ones((3, 3), np.float32)
        good = self.picture(gt.particles([[0.5, 0, 0], [-0.5, 0, 0]], [H, H], Emission=light[:2]))
        for odd in (np.nan, np.inf, -np.inf, 1e35):
            for first in (True, False):
                places = [[0.5, 0, 0], [-0.5, 0, 0]]
                places.insert(0 if first else 2, [odd, 0, 0])
                source = gt.particles(places, [H, H, H], Emission=light)
                self.show(source)
                camera = self.reset()
                seen = [*camera.GetPosition(), camera.GetParallelScale(),
                        *camera.GetClippingRange()]
                self.assertTrue(np.isfinite(seen).all(), (odd, seen))
                np.testing.assert_allclose(camera.GetFocalPoint(), [0, 0, 0], atol=1e-6)
                self.assertLess(camera.GetParallelScale(), 2)
                camera.SetParallelScale(2)
                camera.SetPosition(0, 0, 5)
                np.testing.assert_array_equal(self.shot(), good)
                simple.Hide(source, self.view)
        self.show(gt.particles([[np.nan, 0, 0]], [H], Emission=light[:1]))
        self.assertTrue(np.isfinite(self.reset().GetPosition()).all())

    def test_composite_data_and_grids_are_shown(self):
        parts = [self.emitter((x, 0, 0)) for x in (-0.8, 0.8)]
        for k, part in enumerate(parts):
            part.UpdatePipeline()
            self.show(part)
        self.keep_camera()
        like = self.shot()
        self.assertGreater(like.max(), 0.9)
        for part in parts:
            simple.Hide(part, self.view)
        group = simple.GroupDatasets(Input=parts)
        np.testing.assert_allclose(self.picture(group), like, atol=1 / 255)
        grid = simple.AppendDatasets(Input=parts)
        grid.UpdatePipeline()
        self.assertEqual(grid.GetDataInformation().GetDataSetTypeAsString(), "vtkUnstructuredGrid")
        np.testing.assert_allclose(self.picture(grid), like, atol=1 / 255)


class Vertices(ViewTest):
    def setUp(self):
        super().setUp()
        self.spheroid = simple.Spheroid(NumberOfParticles=2000, Profile="Gaussian",
                                        Sigma=[0.5, 0.5, 0.5])
        self.spheroid.UpdatePipeline()
        self.z = gt.points_of(self.spheroid)[:, 2]

    def test_every_particle_has_a_cell(self):
        galaxy = simple.GalaxyReader(FileName=gt.M83)
        seeds = simple.DiskSeeds(Input=galaxy, ParticleScale=0.005)
        bare = gt.particles([[0, 0, 0], [1, 0, 0]], [1, 1])
        for proxy in (self.spheroid, seeds, simple.DiskThickness(Input=seeds),
                      simple.DustFilaments(Input=seeds, Steps=3),
                      simple.GalaxyModel(Input=galaxy, ParticleScale=0.001),
                      simple.SmoothingLength(Input=bare)):
            proxy.UpdatePipeline()
            information = proxy.GetDataInformation()
            self.assertGreater(information.GetNumberOfPoints(), 0)
            self.assertEqual(information.GetNumberOfCells(), information.GetNumberOfPoints())

    def test_threshold_and_clip_keep_those_within(self):
        light = gt.light_of(self.spheroid)
        kept = simple.Threshold(Input=self.spheroid, Scalars=["POINTS", "SmoothingLength"],
                                LowerThreshold=0, UpperThreshold=1e9)
        kept.UpdatePipeline()
        self.assertEqual(gt.count_of(kept), len(light))
        h = gt.array(self.spheroid, "SmoothingLength")
        middle = float(np.median(h))
        kept.UpperThreshold = middle
        kept.UpdatePipeline()
        self.assertEqual(gt.count_of(kept), (h <= middle).sum())
        clip = simple.Clip(Input=self.spheroid)
        clip.ClipType.Origin, clip.ClipType.Normal = [0, 0, 0], [0, 0, 1]
        clip.UpdatePipeline()
        self.assertEqual(gt.count_of(clip), (self.z <= 0).sum())
        self.show(clip, Exposure=5)
        self.keep_camera()
        self.assertGreater(self.shot().max(), 0.1)

    def test_points_and_surface_show_them(self):
        display = simple.Show(self.spheroid, self.view)
        self.assertEqual(display.Representation, "Splats")
        for representation in ("Points", "Surface", "Point Gaussian"):
            display.Representation = representation
            self.keep_camera()
            self.assertGreater((self.shot().max(axis=2) > 0.1).sum(), 500, representation)


if __name__ == "__main__":
    unittest.main()
