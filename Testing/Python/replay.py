"""Runs what ParaView wrote down, states and traces, in a pvpython of its own."""
import os
import subprocess
import tempfile

import numpy as np
from paraview import servermanager, simple
from PIL import Image
from vtkmodules.util.numpy_support import vtk_to_numpy

import galaxy_testing as gt

SIZE = 160
BEGIN = """
import galaxy_testing, replay
galaxy_testing.load_plugin()
"""
END = """
replay.keep({folder!r})
"""


def shot(view, path):
    """The view as 8-bit numbers; the picture stays at `path`."""
    simple.SaveScreenshot(path, view, ImageResolution=[SIZE, SIZE])
    with Image.open(path) as image:
        return np.asarray(image.convert("RGB"))


def light(proxy):
    """Radiance and transmittance of a SplatImage."""
    proxy.UpdatePipeline()
    data = servermanager.Fetch(proxy).GetPointData()
    return np.stack([vtk_to_numpy(data.GetArray(name)) for name in ("Radiance", "Transmittance")])


def keep(folder):
    """Writes what is seen in the view, and the light of every SplatImage, for the process that asked."""
    view = next(iter(simple.GetViews()))
    np.save(os.path.join(folder, "view.npy"), shot(view, os.path.join(folder, "view.png")))
    for (name, _), source in simple.GetSources().items():
        if source.GetXMLName() == "SplatImage":
            np.save(os.path.join(folder, name + ".npy"), light(source))


def run(script):
    """What `keep` found after the script, by name: `view`, and each SplatImage's."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "script.py")
        with open(path, "w", encoding="utf-8") as file:
            file.write(BEGIN + script + END.format(folder=folder))
        done = subprocess.run([os.environ["PVPYTHON"], path], capture_output=True, text=True, timeout=200)
        if done.returncode or "rror" in done.stdout + done.stderr:
            raise AssertionError(done.stdout + done.stderr)
        return {
            name[:-4]: np.load(os.path.join(folder, name))
            for name in os.listdir(folder)
            if name.endswith(".npy")
        }


def dark_view():
    view = simple.CreateView("RenderView", ViewSize=[SIZE, SIZE])
    view.UseColorPaletteForBackground = 0
    view.Background = [0.0, 0.0, 0.1]
    view.OrientationAxesVisibility = 0
    return view


def look_at(view):
    view.CameraPosition = [0.0, -40.0, 40.0]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 1.0, 1.0]


def output(name):
    return os.path.join(gt.output_folder(), name)
