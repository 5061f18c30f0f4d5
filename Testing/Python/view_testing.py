"""What the tests of the representation Splats in a view share."""
import os
import unittest

import numpy as np
from paraview import simple
from PIL import Image
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

import galaxy_testing as gt

SIZE = 240
H = 0.9
MANY = 1000000  # particles that take longer than PreviewTime = 0.01 on any machine
G0 = 1 / (np.pi * (H / 3) ** 2 * (1 - np.exp(-9)))  # of a particle of h = H, in its middle


class ViewTest(unittest.TestCase):
    """A dark view of 4 x 4 kpc from z = 5, in parallel projection."""

    def setUp(self):
        self.view = simple.CreateView("RenderView")
        self.addCleanup(simple.Delete, self.view)
        self.view.ViewSize = [SIZE, SIZE]
        self.view.OrientationAxesVisibility = 0
        self.view.UseColorPaletteForBackground = 0
        self.view.Background = [0.0, 0.0, 0.0]
        self.view.CameraParallelProjection = 1
        self.view.CameraParallelScale = 2.0
        self.view.CameraPosition = [0, 0, 5]
        self.view.CameraFocalPoint = [0, 0, 0]
        self.view.CameraViewUp = [0, 1, 0]

    def shot(self, size=SIZE, layout=None, mode="RGB", **options):
        """A screenshot of the view, or of the layout, of this width and height."""
        size = [size, size] if isinstance(size, int) else list(size)
        path = os.path.join(gt.output_folder(), f"view-{os.getpid()}.png")
        simple.SaveScreenshot(path, layout or self.view, ImageResolution=size, **options)
        with Image.open(path) as image:
            return np.asarray(image.convert(mode), dtype=float) / 255

    def pixels(self):
        """What the window shows, without rendering it again."""
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.view.GetRenderWindow())
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        image = grab.GetOutput()
        width, height, _ = image.GetDimensions()
        values = vtk_to_numpy(image.GetPointData().GetScalars())
        return values.reshape(height, width, -1)[::-1, :, :3] / 255

    def show(self, source, **properties):
        display = simple.Show(source, self.view)
        display.Representation = "Splats"
        display.Stretch = 0
        display.Exposure = 1 / G0
        for name, value in properties.items():
            setattr(display, name, value)
        return display

    def show_flat(self, source, color):
        """Geometry in this very colour, however it is lit."""
        display = simple.Show(source, self.view)
        display.AmbientColor = display.DiffuseColor = color
        display.Ambient, display.Diffuse = 1.0, 0.0
        self.keep_camera()
        return display

    def show_many(self, count):
        """The display of so many stars, and what is seen of them: 20 in all over 4 square kpc."""
        rng = np.random.default_rng(1)
        places = rng.uniform(-1, 1, (count, 3)).astype(np.float32)
        light = np.full((count, 3), 20 / count, dtype=np.float32)
        source = gt.particles(places, np.full(count, 0.05), Emission=light)
        display = self.show(source, PreviewTime=0.01)
        display.Exposure = 0.5 / 5
        simple.Render(self.view)
        return display, self.shot()

    def keep_camera(self):
        self.view.CameraParallelScale = 2.0
        self.view.CameraPosition = [0, 0, 5]
        self.view.CameraFocalPoint = [0, 0, 0]

    def emitter(self, position=(0, 0, 0), color=(1, 1, 1)):
        return gt.particles([position], [H], Emission=np.array([color], dtype=np.float32))

    def absorber(self, optical_depth, position=(0, 0, 0)):
        absorption = np.array([optical_depth], dtype=np.float32) / G0
        return gt.particles([position], [H], Absorption=absorption)
