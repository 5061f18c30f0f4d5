"""The representation Splats in a render view, beside other things. Needs a display."""
import re
import time
import unittest

import numpy as np
from paraview import simple

import galaxy_testing as gt
from view_testing import G0, H, MANY, SIZE, ViewTest

gt.load_plugin()


class View(ViewTest):
    def test_pixel_equals_splat_image(self):
        source = self.emitter((0.3, -0.2, 0), (0.9, 0.6, 0.3))
        self.show(source)
        self.keep_camera()
        radiance, _ = gt.splat(
            source, SIZE, CameraParallelProjection=1, CameraParallelScale=2.0,
            CameraPosition=[0, 0, 5],
        )
        np.testing.assert_allclose(self.shot(), radiance[::-1] / G0, atol=1.01 / 255)

    def test_absorption_by_channel_over_the_background(self):
        self.view.Background = [1.0, 1.0, 1.0]
        self.show(self.absorber((0.5, 1.0, 2.0)))
        self.keep_camera()
        middle = self.shot()[SIZE // 2, SIZE // 2]
        np.testing.assert_allclose(middle, np.exp([-0.5, -1.0, -2.0]), atol=0.012)

    def scene(self, z_sphere):
        """An emitter at the origin and an opaque ball before or behind it."""
        self.show(self.emitter(color=(1, 0, 0)))
        ball = simple.Sphere(Center=[0, 0, z_sphere], Radius=0.3, ThetaResolution=64,
                             PhiResolution=64)
        self.show_flat(ball, [0, 0, 1])
        return ball

    def test_opaque_geometry_hides_what_is_behind_it(self):
        for peeling in (0, 1):
            self.view.DepthPeeling = peeling
            ball = self.scene(1.0)
            middle = self.shot()[SIZE // 2, SIZE // 2]
            self.assertLess(middle[0], 0.05)
            ball.Center = [0, 0, -1.0]
            middle = self.shot()[SIZE // 2, SIZE // 2]
            self.assertGreater(middle[0], 0.9)
            simple.Hide(ball, self.view)

    def test_antialiasing_changes_nothing_smooth(self):
        self.show(self.emitter())
        self.keep_camera()
        plain = self.shot()
        for fxaa, samples in ((0, 0), (1, 0), (0, 8)):
            self.view.UseFXAA, self.view.MultiSamples = fxaa, samples
            self.assertLess(np.abs(self.shot() - plain).max(), 0.02)

    def test_stereo_is_that_of_geometry(self):
        """A particle and a ball in the same place, by each eye seen in the same place."""
        for parallel in (1, 0):
            self.view.CameraParallelProjection = parallel
            for z in (-6, 2):
                source = gt.particles([[0, 0, z]], [0.3], Emission=np.ones((1, 3), np.float32))
                ball = simple.Sphere(Center=[0, 0, z], Radius=0.1, ThetaResolution=32,
                                     PhiResolution=32)
                self.show(source, Exposure=10)
                splat = self.by_each_eye(source)
                self.show_flat(ball, [1, 1, 1])
                geometry = self.by_each_eye(ball)
                np.testing.assert_allclose(splat, geometry, atol=0.4)
                self.assertGreater(abs(geometry[0] - geometry[1]), 2)

    def by_each_eye(self, thing):
        """The column in which it is seen; it is hidden then."""
        self.keep_camera()
        simple.SetActiveView(self.view)
        for _ in range(2):  # VTK's first picture in stereo has one eye in the middle
            picture = self.shot(StereoMode="Red-Blue")
        simple.Hide(thing, self.view)
        columns = picture.sum(axis=0)
        return [(columns[:, c] * np.arange(SIZE)).sum() / columns[:, c].sum() for c in (0, 2)]

    def test_beside_translucent_geometry_and_lines(self):
        for peeling in (1, 0):
            self.view.DepthPeeling = peeling
            self.beside_translucent_geometry_and_lines()

    def beside_translucent_geometry_and_lines(self):
        self.show(self.emitter(color=(1, 0, 0)))
        box = simple.Box(XLength=1, YLength=1, ZLength=0.1, Center=[1.0, 0, 0])
        self.show_flat(box, [0, 1, 0]).Opacity = 0.5
        line = simple.Line(Point1=[-1.5, 1.5, 0], Point2=[1.5, 1.5, 0])
        lines = simple.Show(line, self.view)
        lines.LineWidth = 5
        lines.AmbientColor = lines.DiffuseColor = [1, 1, 0]
        self.keep_camera()
        picture = self.shot()
        self.assertGreater(picture[SIZE // 2, SIZE // 2, 0], 0.9)  # the particle
        at = int((1.3 + 2) / 4 * SIZE)
        # Two faces of the box, each covering half.
        np.testing.assert_allclose(picture[SIZE // 2, at, 1], 0.75, atol=0.03)
        row = int((2 - 1.5) / 4 * SIZE)
        self.assertGreater(picture[row - 2 : row + 3, SIZE // 2, :2].max(), 0.8)  # the line
        for shown in (box, line):
            simple.Delete(shown)

    def test_large_screenshot_equals_small_one(self):
        self.show(gt.particles(
            [[0.5, 0.2, 0], [-0.8, -0.5, 0.5]], [H, H / 2],
            Emission=np.array([[1, 0.5, 0.2], [0.2, 0.2, 0.5]], dtype=np.float32),
        ))
        self.keep_camera()
        small = self.shot()
        large = self.shot(4 * SIZE)
        averaged = large.reshape(SIZE, 4, SIZE, 4, 3).mean(axis=(1, 3))
        self.assertLess(np.abs(averaged - small).max(), 0.03)

    def test_exposure_brightness_and_visibility(self):
        display = self.show(self.emitter(), Exposure=0.25 / G0)
        self.keep_camera()
        middle = (SIZE // 2, SIZE // 2)
        np.testing.assert_allclose(self.shot()[middle], 0.25, atol=0.01)
        display.Exposure = 0.5 / G0
        np.testing.assert_allclose(self.shot()[middle], 0.5, atol=0.01)
        display.Stretch = 10
        stretched = np.arcsinh(10 * 0.5) / np.arcsinh(10)
        np.testing.assert_allclose(self.shot()[middle], stretched, atol=0.015)
        display.UpdatePropertyInformation()
        self.assertIn("emission", str(display.ActiveEffects))
        display.Visibility = 0
        self.assertLess(self.shot().max(), 0.01)

    def test_exposure_stretch_and_gamma_need_no_new_picture(self):
        display, _ = self.show_many(20000)

        def statistics():
            display.UpdatePropertyInformation()
            return str(display.RenderStatistics)  # with the seconds it took

        before = statistics()
        brightness = self.shot().mean()
        for name, value in (("Exposure", 2 * display.Exposure), ("Stretch", 10), ("Gamma", 0.7)):
            setattr(display, name, value)
            other = self.shot().mean()
            self.assertGreater(abs(other - brightness), 5e-4, name)
            self.assertEqual(statistics(), before, name)
            brightness = other
        display.Accuracy = "Sorted"
        self.shot()
        self.assertNotEqual(statistics(), before)

    def test_a_components_light_changes_without_drawing(self):
        model = simple.GalaxyModel(Input=simple.GalaxyReader(FileName=gt.M83), ParticleScale=0.02)
        display = self.show(model, Exposure=0.5)
        self.view.CameraParallelScale = 9.0
        self.view.CameraPosition, self.view.CameraFocalPoint = [0, -25, 25], [0, 0, 0]

        def change(draws, **settings):
            for name, value in settings.items():
                setattr(display, name, value)
            shown = self.shot()
            display.UpdatePropertyInformation()
            self.assertEqual("composite" in display.RenderStatistics, draws, settings)
            return shown

        change(True)
        change(True, ComponentBrightness=["stars", "2"])
        bright = change(False, ComponentBrightness=["stars", "3"])
        change(True, ComponentBrightness=["stars", "3"], ComponentVisibility=["gas", "0"])
        change(False, ComponentBrightness=["stars", "0.5"])
        change(True, ComponentBrightness=["stars", "0.5", "dust", "2"])  # dims the others
        change(True, ComponentColor=["bulge", "1", "0", "0"])  # has had colours of its particles
        change(True, ComponentColor=["bulge", "0", "1", "0"])
        green = change(False, ComponentColor=["bulge", "0", "1", "0.5"])
        # What is shown without drawing is what drawing shows.
        self.view.CameraPosition = [0, -25, 20]
        self.shot()
        self.view.CameraPosition = [0, -25, 25]
        np.testing.assert_allclose(change(True), green, atol=2 / 255)
        settings = {"ComponentVisibility": [], "ComponentColor": []}
        again = change(True, ComponentBrightness=["stars", "3"], **settings)
        np.testing.assert_allclose(again, bright, atol=2 / 255)

    def test_black_and_white_points(self):
        display = self.show(self.emitter(), Exposure=0.5 / G0)
        self.keep_camera()
        display.BlackPoint, display.WhitePoint = [0.25, 0, -0.5], [0.75, 2, 1.5]
        middle = self.shot()[SIZE // 2, SIZE // 2]
        np.testing.assert_allclose(middle, [0.5, 0.25, 0.5], atol=0.01)
        display.WhitePoint = [0.25, 1, 1]
        with gt.Messages() as messages:
            simple.Render(self.view)
        self.assertIn("WhitePoint must be above BlackPoint", messages.text)

    def test_scale_bar_and_compass(self):
        display = self.show(self.emitter(), ScaleBar=1, Compass=1, AnnotationColor=[0, 1, 0])
        display.Exposure = 0
        self.view.CameraFocalPoint, self.view.CameraPosition = [0, 0, 0], [0, 0, 5]
        self.view.CameraViewUp = [1, 0, 0]  # North to the left, East up
        for parallel in (1, 0):
            self.view.CameraParallelProjection = parallel
            width = 4.0 if parallel else 10 * np.tan(np.radians(15))
            for size in (SIZE, 3 * SIZE):  # the larger one is made of tiles
                green = self.shot(size)[..., 1] > 0.5
                lower = green[size // 2 :, :]
                bar = np.flatnonzero(lower[int(0.45 * size) - 2 : int(0.45 * size) + 2].any(axis=0))
                length = (bar[-1] - bar[0]) / size * width
                self.assertAlmostEqual(length, 0.5, delta=0.02)
                rows, columns = np.nonzero(green[: size // 2])
                self.assertGreater(columns.min(), size // 2)  # the compass is at the upper right
                self.assertGreater(len(rows), 40)
        display.ScaleBar = display.Compass = 0
        self.assertEqual(self.shot().max(), 0)

    def test_a_preview_while_the_view_moves(self):
        display, whole = self.show_many(MANY)
        self.assertNotIn("stand for all", display.RenderStatistics)
        self.view.LODThreshold = 0  # also what is small is "large" then
        view = self.view.GetClientSideObject()
        view.Update()
        self.view.CameraPosition = [0, 0, 6]
        view.InteractiveRender()
        display.UpdatePropertyInformation()
        self.assertIn("stand for all", display.GetPropertyValue("RenderStatistics"))
        self.view.CameraPosition = [0, 0, 5]
        after = self.shot()
        display.UpdatePropertyInformation()
        self.assertNotIn("stand for all", display.GetPropertyValue("RenderStatistics"))
        np.testing.assert_allclose(after, whole, atol=1 / 254)

    def test_a_view_that_rests_is_refined(self):
        display, whole = self.show_many(MANY)
        self.view.LODThreshold = 0
        view = self.view.GetClientSideObject()
        view.Update()

        def move(to):  # in parallel projection seen alike
            self.view.CameraPosition = [0, 0, 6]
            self.view.InteractiveRender()
            self.view.CameraPosition = [0, 0, to]
            self.view.InteractiveRender()

        def sampled():
            display.UpdatePropertyInformation()
            statistics = display.GetPropertyValue("RenderStatistics")
            found = re.search(r"a random (\d+) stand for all", statistics)
            return int(found[1]) if found else None

        self.assertFalse(self.view.SMProxy.StreamingUpdate(True))  # there is nothing to refine
        move(7)
        self.view.StillRender()  # as when the mouse is released: the preview that is there
        counts = [sampled()]
        errors = [np.abs(self.pixels() - whole).mean()]
        while self.view.SMProxy.StreamingUpdate(True):
            counts.append(sampled())
            errors.append(np.abs(self.pixels() - whole).mean())
        self.assertGreaterEqual(len(counts), 2, counts)
        self.assertIsNone(counts[-1])  # all of them
        self.assertNotIn(None, counts[:-1])
        self.assertEqual(counts[:-1], sorted(counts[:-1]))
        self.assertLess(errors[-1], 1 / 254)
        self.assertEqual(errors, sorted(errors, reverse=True))
        # What is saved before that is whole.
        move(8)
        self.view.StillRender()
        np.testing.assert_allclose(self.shot(), whole, atol=1 / 254)
        # And so is what has been drawn, when the view comes back to it.
        move(8)
        self.assertIsNone(sampled())
        # Whatever else changes is seen at once too, and saved whole.
        self.view.CameraPosition = [0, 0, 9]
        self.view.StillRender()
        self.assertIsNotNone(sampled())
        self.view.CameraPosition = [0, 0, 10]
        np.testing.assert_allclose(self.shot(), whole, atol=1 / 254)
        self.assertIsNone(sampled())

    def test_drawing_tells_how_far_it_is_and_can_be_aborted(self):
        display, whole = self.show_many(MANY)
        splats = display.GetClientSideObject().GetActiveRepresentation()
        told = []

        def listen(caller, _):
            told.append(caller.GetProgress())
            if told[-1] > abort_at:
                caller.SetAbortExecute(1)

        splats.AddObserver("ProgressEvent", listen)
        abort_at = 1
        self.view.CameraPosition = [0, 0, 6]
        simple.Render(self.view)
        self.assertGreater(len(told), 20)
        self.assertEqual(told, sorted(told))
        self.assertLess(told[0], 0.01)
        self.assertGreater(told[-1], 0.9)
        for abort_at in (-1, 0.05, 0.3, 0.8):  # at once, in counting, in dealing, in drawing
            told.clear()
            self.view.CameraPosition = [0, 0, 5 + abort_at]
            simple.Render(self.view)
            self.assertEqual(sum(fraction > abort_at for fraction in told), 1)  # not asked again
            display.UpdatePropertyInformation()
            self.assertRegex(display.RenderStatistics, "^aborted; .* stand for all")
            # Right on average.
            self.assertAlmostEqual(self.pixels().mean(), whole.mean(), delta=0.05 * whole.mean())
        abort_at = 1
        np.testing.assert_allclose(self.shot(), whole, atol=1 / 254)
        display.UpdatePropertyInformation()
        self.assertNotIn("aborted", display.RenderStatistics)

    def test_refining_waits_while_the_view_is_used(self):
        display, whole = self.show_many(MANY)
        self.view.LODThreshold = 0
        self.view.GetClientSideObject().Update()
        self.view.SMProxy.StreamingUpdate(True)
        self.view.CameraPosition = [0, 0, 6]
        self.view.InteractiveRender()
        self.view.CameraPosition = [0, 0, 7]  # seen alike, but not what has been drawn
        self.view.InteractiveRender()
        self.view.StillRender()
        preview = self.pixels()
        window = self.view.GetRenderWindow()
        asked = window.AddObserver("AbortCheckEvent", lambda caller, _: caller.SetAbortRender(1))
        time.sleep(0.25)  # a window asks no more than five times a second
        self.assertTrue(self.view.SMProxy.StreamingUpdate(True))
        np.testing.assert_array_equal(self.pixels(), preview)
        window.RemoveObserver(asked)
        while self.view.SMProxy.StreamingUpdate(True):
            pass
        np.testing.assert_allclose(self.pixels(), whole, atol=1 / 254)

    def test_preview_is_bounded_on_average_and_bounded_is_sorted(self):
        rng = np.random.default_rng(2)
        places = rng.uniform(-1, 1, (20000, 3)).astype(np.float32)
        light = np.full((len(places), 3), 1e-3, dtype=np.float32)
        light[::3] = 0
        dust = np.zeros_like(light)
        dust[::3] = [2e-4, 3e-4, 4e-4]
        source = gt.particles(places, np.full(len(places), 0.3), Emission=light, Absorption=dust)
        display = self.show(source, Exposure=0.2)
        pictures = {}
        for accuracy in ("Sorted", "Bounded", "Preview"):
            display.Accuracy = accuracy
            display.PreviewTime = 0.01
            pictures[accuracy] = self.shot()
        self.assertGreater(pictures["Sorted"].max(), 0.2)
        np.testing.assert_allclose(pictures["Bounded"], pictures["Sorted"], atol=1 / 512 + 1 / 255)
        self.assertAlmostEqual(pictures["Preview"].mean() / pictures["Sorted"].mean(), 1, delta=0.2)


if __name__ == "__main__":
    unittest.main()
