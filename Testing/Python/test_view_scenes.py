"""The representation Splats beside everything else that ParaView shows in a view: volumes, rings,
axes, annotation, other passes, backgrounds, selections, layouts, screenshots. Needs a display."""
import os
import unittest

import numpy as np
from paraview import servermanager, simple
from PIL import Image
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAAPass

import galaxy_testing as gt
from view_testing import G0, H, SIZE, ViewTest

gt.load_plugin()
ROUNDING = 2 / 255  # of pictures over each other
HALF = SIZE // 2


def column_at(x):
    return int((x + 2) / 4 * SIZE)


class Scenes(ViewTest):
    def setUp(self):
        super().setUp()
        self.view.UseFXAA = 0

    def galaxy(self):
        """A star at z = -0.3, behind dust at z = 0.3."""
        light = np.array([[0.6, 0.4, 0.3], [0, 0, 0]], dtype=np.float32)
        depth = np.array([[0, 0, 0], [0.5, 1.0, 1.5]], dtype=np.float32) / G0
        return gt.particles([[0.1, 0, -0.3], [-0.1, 0, 0.3]], [H, H], Emission=light,
                            Absorption=depth)

    def show_galaxy(self):
        source = self.galaxy()
        display = self.show(source)
        self.keep_camera()
        return source, display

    def over(self, source, behind, size=SIZE):
        """What is seen of something that lies behind the particles."""
        light, transmittance = (
            picture[::-1] for picture in gt.splat(
                source, size, CameraParallelProjection=1, CameraParallelScale=2.0,
                CameraPosition=[0, 0, 5]))
        return np.clip(light / G0 + transmittance * behind, 0, 1)

    def alone(self, display):
        """What is seen without the particles."""
        display.Visibility = 0
        picture = self.shot()
        display.Visibility = 1
        return picture

    def volume(self, z):
        """A ball of cyan mist, and its display."""
        image = vtkImageData()
        image.SetDimensions(11, 11, 11)
        image.SetSpacing(0.2, 0.2, 0.2)
        image.SetOrigin(-1, -1, z - 1)
        x, y, s = np.meshgrid(*[np.linspace(-1, 1, 11)] * 3)
        density = np.clip(1 - np.sqrt(x**2 + y**2 + s**2), 0, 1).astype(np.float32)
        values = numpy_to_vtk(density.ravel(), deep=True)
        values.SetName("Mist")
        image.GetPointData().SetScalars(values)
        source = simple.TrivialProducer()
        source.GetClientSideObject().SetOutput(image)
        display = simple.Show(source, self.view)
        display.SetRepresentationType("Volume")
        simple.ColorBy(display, ("POINTS", "Mist"))
        display.SetScalarBarVisibility(self.view, False)
        simple.GetColorTransferFunction("Mist").RGBPoints = [0, 0, 1, 1, 1, 0, 1, 1]
        simple.GetOpacityTransferFunction("Mist").Points = [0, 0, 0.5, 0, 1, 0.3, 0.5, 0]
        display.ScalarOpacityUnitDistance = 0.3
        return source

    def plate(self, z):
        """A half transparent green one."""
        box = simple.Box(XLength=1, YLength=1, ZLength=0.1, Center=[0, 0, z])
        self.show_flat(box, [0, 1, 0]).Opacity = 0.5
        return box

    def test_volumes_and_translucent_surfaces_are_seen_behind_the_particles(self):
        """Wherever they are: they are drawn before the particles are."""
        source, display = self.show_galaxy()
        for thing in (self.volume, self.plate):
            for z in (-1.5, 0, 1.5):
                shown = thing(z)
                for peeling in (1, 0):
                    self.view.DepthPeeling = peeling
                    self.keep_camera()
                    behind = self.alone(display)
                    self.assertGreater(behind[HALF, HALF, 1], 0.5)
                    self.assertLess(behind[HALF, HALF, 1], 0.98)
                    np.testing.assert_allclose(
                        self.shot(), self.over(source, behind), atol=ROUNDING,
                        err_msg=f"{thing.__name__} at {z}, peeling {peeling}")
                simple.Delete(shown)

    def test_lines_and_surfaces_are_at_their_depth(self):
        """They come out of the galaxy's middle, from behind on the left to the front on the right,
        where z = 2 x."""
        source, _ = self.show_galaxy()
        light = gt.splat(source, SIZE, CameraParallelProjection=1, CameraParallelScale=2.0,
                         CameraPosition=[0, 0, 5])[0][::-1] / G0
        line = simple.Line(Point1=[-1, 0, -2], Point2=[1, 0, 2])
        strip = simple.Plane(Origin=[-1, -0.2, -2], Point1=[1, -0.2, 2], Point2=[-1, 0.2, -2])
        green = np.array([0.0, 1.0, 0.0])
        everywhere = self.over(source, green)
        for thing in (line, strip):
            self.show_flat(thing, list(green)).LineWidth = 3
            picture = self.shot()
            behind, within, before = (HALF, column_at(-0.3)), (HALF, HALF), (HALF, column_at(0.3))
            np.testing.assert_allclose(picture[behind], everywhere[behind], atol=ROUNDING)
            dimmed = everywhere[within] - light[within]  # it hides the star, but not the dust
            np.testing.assert_allclose(picture[within], dimmed, atol=ROUNDING)
            np.testing.assert_allclose(picture[before], green, atol=ROUNDING)
            self.assertGreater(light[within].min(), 0.03)
            simple.Hide(thing, self.view)

    def test_passes_of_the_view(self):
        """Each draws into a buffer of its own, where a ball hides what is behind it."""
        self.show_galaxy()
        ball = simple.Sphere(Center=[0.4, 0, 1], Radius=0.2, ThetaResolution=64, PhiResolution=64)
        self.show_flat(ball, [0, 0, 1])
        plain = self.shot()
        np.testing.assert_allclose(plain[HALF, column_at(0.4)], [0, 0, 1])
        y, x = np.mgrid[0:SIZE, 0:SIZE] / SIZE * 4 - 2
        distance = np.hypot(x - 0.4, y)
        apart = np.abs(distance - 0.2) > 0.06  # from the ball's edge

        def compare(what, where=apart):
            np.testing.assert_allclose(
                self.shot()[where], plain[where], atol=0.02, err_msg=what)

        self.view.UseFXAA = 1
        compare("FXAA")
        self.view.UseFXAA, self.view.MultiSamples = 0, 8
        compare("multisampling")
        self.view.MultiSamples = 0
        self.view.UseToneMapping, self.view.ToneMappingType = 1, 0  # to within 0 and 1
        compare("tone mapping")
        self.view.UseFXAA = 1
        compare("tone mapping and FXAA")
        self.view.UseToneMapping = 0
        self.view.UseAmbientOcclusion = 1
        compare("ambient occlusion", apart & (distance > 0.2))
        self.view.UseAmbientOcclusion = 0
        renderer = self.view.GetClientSideObject().GetRenderer()
        sampled = vtkSSAAPass()
        sampled.SetDelegatePass(vtkRenderStepsPass())
        before = renderer.GetPass()
        renderer.SetPass(sampled)
        compare("supersampling")
        renderer.SetPass(before)

    def haze(self, z=0.0, **arrays):
        """One particle before the whole view."""
        return gt.particles([[0, 0, z]], [9], **arrays)

    def covered(self):
        """A picture without particles, and where it lets nothing through."""
        pictures = []
        for value in (1, 0):
            self.view.Background = [value] * 3
            pictures.append(self.shot())
        return pictures[1], np.abs(pictures[0] - pictures[1]).max(axis=2) < 0.004

    def test_annotation_is_on_top(self):
        ball = simple.Elevation(Input=simple.Sphere(Center=[9, 0, 0]))
        colors = simple.Show(ball, self.view)
        simple.ColorBy(colors, ("POINTS", "Elevation"))
        colors.SetScalarBarVisibility(self.view, True)
        bar = simple.GetScalarBar(simple.GetColorTransferFunction("Elevation"), self.view)
        bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.6, 0.3], 0.4
        text = simple.Show(simple.Text(Text="text"), self.view)
        text.WindowLocation, text.Position, text.FontSize = "Any Location", [0.2, 0.45], 30
        text.Color = [0, 1, 0]
        self.view.OrientationAxesVisibility = 1
        self.keep_camera()
        picture, covered = self.covered()
        parts = {"orientation": np.s_[180:, :60], "text": np.s_[90:140, 40:130],
                 "bar": np.s_[60:180, 140:]}
        for name, part in parts.items():
            self.assertGreater(covered[part].sum(), 15, name)
        light = np.full((1, 3), 20, dtype=np.float32)
        self.show(self.haze(Emission=light, Absorption=light), Exposure=1)
        self.keep_camera()
        beside = self.shot()
        self.assertGreater(np.median(beside[~covered]), 0.2)
        np.testing.assert_allclose(beside[covered], picture[covered], atol=0.004)

    def test_axes_are_at_their_depth(self):
        """Those in the middle, and the grid's at z = -1: dust before them dims them."""
        self.view.AxesGrid.UseCustomBounds = 1
        self.view.AxesGrid.CustomBounds = [-1, 1, -1, 1, -1, 1]
        self.view.AxesGrid.AxesToLabel = 0
        self.view.AxesGrid.XTitle = self.view.AxesGrid.YTitle = self.view.AxesGrid.ZTitle = ""
        self.view.CenterOfRotation = [0, 0, 0]
        dust = np.full((1, 3), 60, dtype=np.float32)
        for axes, z in ((self.view.AxesGrid, -1), (self.view, 0)):
            name = "Visibility" if axes is self.view.AxesGrid else "CenterAxesVisibility"
            axes.SetPropertyWithName(name, 1)
            self.keep_camera()
            alone = self.shot()
            drawn = alone.max(axis=2) > 0.9
            self.assertGreater(drawn.sum(), 100)
            for beside in (-0.5, 0.5):
                source = self.haze(z + beside, Absorption=dust)
                self.show(source)
                self.keep_camera()
                _, transmittance = gt.splat(
                    source, SIZE, CameraParallelProjection=1, CameraParallelScale=2.0,
                    CameraPosition=[0, 0, 5])
                self.assertLess(transmittance.max(), 0.9)
                seen = alone * (transmittance[::-1] if beside > 0 else 1)
                np.testing.assert_allclose(self.shot()[drawn], seen[drawn], atol=ROUNDING)
                simple.Delete(source)
            axes.SetPropertyWithName(name, 0)

    def test_selections_see_through_the_particles(self):
        ball = simple.Sphere(Center=[0.3, 0, -2], Radius=0.5)
        self.show_flat(ball, [0, 0, 1])
        source, display = self.show_galaxy()
        simple.SetActiveSource(ball)
        simple.Render(self.view)
        before = self.shot()

        def count(select):
            with gt.Messages() as messages:
                select(Rectangle=[0, 0, SIZE - 1, SIZE - 1], View=self.view)
            self.assertEqual(messages.text, "")
            self.assertIsNone(source.SMProxy.GetSelectionInput(0))
            selection = ball.SMProxy.GetSelectionInput(0)
            self.assertIsNotNone(selection)
            self.assertGreater(np.abs(self.shot() - before).max(), 0.3)  # it is shown
            ids = servermanager._getPyProxy(selection).Input[0].IDs
            simple.ClearSelection(ball)
            return len(ids) // 2

        for select in (simple.SelectSurfacePoints, simple.SelectSurfaceCells):
            through = count(select)
            display.Visibility = 0
            self.assertEqual(through, count(select))
            self.assertGreater(through, 20)
            display.Visibility = 1
        np.testing.assert_array_equal(self.shot(), before)

    def test_the_camera_finds_the_particles(self):
        light = np.ones((2, 3), dtype=np.float32)
        source = gt.particles([[5.5, -3, 2], [4.5, -3, 2]], [H, H], Emission=light)
        display = self.show(source)
        for to_data in (False, True):
            self.keep_camera()
            simple.Render(self.view)
            if to_data:
                self.view.SMProxy.ZoomTo(display.SMProxy)
            else:
                simple.ResetCamera(self.view)
            camera = self.view.GetActiveCamera()
            np.testing.assert_allclose(camera.GetFocalPoint(), [5, -3, 2], atol=1e-5)
            half_diagonal = np.linalg.norm([0.5 + H, H, H])  # with their kernels
            self.assertAlmostEqual(camera.GetParallelScale(), half_diagonal, places=4)
            self.assertGreater(self.shot()[HALF].max(), 0.5)

    def test_the_first_picture_is_not_clipped(self):
        """What belongs to no data, as the axes' grid, is seen as far as the kernels reach."""
        self.view.AxesGrid.UseCustomBounds = self.view.AxesGrid.Visibility = 1
        self.view.AxesGrid.CustomBounds = [-1, 1, -1, 1, -0.8, 0.8]
        self.view.AxesGrid.AxesToLabel = 0
        self.show(self.emitter())
        self.keep_camera()
        self.assertGreater(self.shot()[column_at(-1) - 2 : column_at(-1) + 2, HALF].max(), 0.9)

    def test_backgrounds(self):
        source, display = self.show_galaxy()
        path = os.path.join(gt.output_folder(), f"background-{os.getpid()}.png")
        ramp = np.linspace(0, 250, 64).astype(np.uint8)
        colors = np.stack(np.broadcast_arrays(ramp[None], ramp[:, None], 100), axis=2)
        Image.fromarray(colors.astype(np.uint8)).save(path)
        self.view.BackgroundTexture = simple.CreateTexture(path)
        self.view.Background, self.view.Background2 = [0, 0, 0.4], [0.5, 0.2, 0]
        for mode in ("Single Color", "Gradient", "Texture", "Skybox"):
            self.view.BackgroundColorMode = mode
            self.keep_camera()
            behind = self.alone(display)
            self.assertGreater(behind.max(), 0.2, mode)
            np.testing.assert_allclose(
                self.shot(), self.over(source, behind), atol=3 / 255, err_msg=mode)

    def test_a_transparent_background(self):
        """Light and dust both are something before it."""
        source, _ = self.show_galaxy()
        ball = simple.Sphere(Center=[1.5, 1.5, 0], Radius=0.3)
        self.show_flat(ball, [0, 0, 1])
        black = self.shot()
        self.view.Background = [0.2, 0.4, 0.1]
        for size in (SIZE, 2 * SIZE):  # the larger one is made of tiles
            picture = self.shot(size, mode="RGBA", TransparentBackground=1)
            step = size // SIZE
            color, alpha = picture[..., :3], picture[..., 3:]
            self.assertEqual(alpha[-1, 0], 0)
            self.assertEqual(alpha[size // 8, size * 7 // 8], 1)
            over_black = (color * alpha).reshape(SIZE, step, SIZE, step, 3).mean(axis=(1, 3))
            edge = np.abs(np.hypot(*np.mgrid[-30 : SIZE - 30, 30 - SIZE : 30]) - 18) < 3
            np.testing.assert_allclose(over_black[~edge], black[~edge], atol=0.02)
        alpha = self.shot(mode="RGBA", TransparentBackground=1)[..., 3]
        self.assertTrue((alpha >= black.max(axis=2) - ROUNDING).all())
        light, transmittance = (self.over(source, behind)[HALF, HALF] for behind in (0, 1))
        self.assertGreater(alpha[HALF, HALF], 0.3)
        np.testing.assert_allclose(
            alpha[HALF, HALF], 1 - transmittance.max() + light.max(), atol=ROUNDING)

    def test_screenshots_of_odd_sizes(self):
        source, _ = self.show_galaxy()
        self.view.Background = [0.1, 0.2, 0.3]
        for size in ((333, 217), (SIZE - 1, 131), (777, 501)):
            picture = self.shot(size)
            height, width, _ = picture.shape  # ParaView makes some a pixel or two narrower
            self.assertLess(abs(width - size[0]) + abs(height - size[1]), 4)
            seen = self.over(source, self.view.Background, (width, height))
            np.testing.assert_allclose(picture, seen, atol=ROUNDING)

    def test_a_layout_of_two_views(self):
        layout = simple.CreateLayout("Two")
        self.addCleanup(simple.RemoveLayout, layout)
        first, second = self.view, simple.CreateView("RenderView")
        self.addCleanup(simple.Delete, second)
        simple.AssignViewToLayout(view=first, layout=layout, hint=0)
        layout.SplitHorizontal(0, 0.5)
        simple.AssignViewToLayout(view=second, layout=layout, hint=2)
        second.OrientationAxesVisibility = second.UseColorPaletteForBackground = 0
        second.Background = [0, 0, 0.4]
        source = self.galaxy()
        for view in (first, second):
            self.view = view
            self.show(source)
            self.keep_camera()
        second.CameraParallelProjection = 1
        second.CameraPosition = [0, 0, -5]
        layout.SetSize(2 * SIZE, SIZE)
        both = self.shot((2 * SIZE, SIZE), layout, SeparatorWidth=0)
        for view, x in ((first, 0), (second, 2 * SIZE - second.ViewSize[0])):
            self.view = view
            single = self.shot(view.ViewSize)
            np.testing.assert_array_equal(both[:, x : x + view.ViewSize[0]], single)
        self.assertGreater(np.abs(single - both[:, : single.shape[1]]).max(), 0.2)
        twice = self.shot((4 * SIZE, 2 * SIZE), layout, SeparatorWidth=0)
        np.testing.assert_allclose(
            twice.reshape(SIZE, 2, 2 * SIZE, 2, 3).mean(axis=(1, 3))[:, : SIZE - 1],
            both[:, : SIZE - 1], atol=0.03)


if __name__ == "__main__":
    unittest.main()
