"""What the plugin's tests share."""
import contextlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCommand, vtkFileOutputWindow, vtkOutputWindow, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
M83 = os.path.join(ROOT, "Examples", "M83", "m83.galaxy")
SKIP = 77


def load_plugin():
    simple.LoadPlugin(os.environ["GALAXY_PLUGIN"], ns=vars(simple))


@contextlib.contextmanager
def server():
    """A server of one process with the plugin, to which this client is connected meanwhile."""
    process = subprocess.Popen(["pvserver", "--server-port=0"], stdout=subprocess.PIPE, text=True)
    try:
        line = ""
        while "Accepting" not in line and process.poll() is None:
            line = process.stdout.readline()
        simple.Connect("localhost", int(re.search(r":(\d+)", line).group(1)))
        simple.LoadPlugin(os.environ["GALAXY_PLUGIN"], remote=True, ns=vars(simple))
        yield
        simple.Disconnect()
    finally:
        process.kill()
        process.wait()
        process.stdout.close()


def output_folder():
    folder = os.environ.get("GALAXY_TEST_OUTPUT") or tempfile.mkdtemp()
    os.makedirs(folder, exist_ok=True)
    return folder


def skip(why):
    print("SKIPPED: " + why)
    sys.exit(SKIP)


def array(proxy, name, association="point"):
    """A data array of a proxy's output, fetched to here, as numpy."""
    data = servermanager.Fetch(proxy)
    attributes = {
        "point": data.GetPointData,
        "cell": data.GetCellData,
        "field": data.GetFieldData,
    }[association]()
    return vtk_to_numpy(attributes.GetArray(name))


def particles(position, smoothing_length, **arrays):
    """A TrivialProducer proxy of particles given as numpy arrays."""
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(position, dtype=np.float32), deep=True))
    data.SetPoints(points)
    arrays["SmoothingLength"] = np.asarray(smoothing_length, dtype=np.float32)
    for name, values in arrays.items():
        values = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        values.SetName(name)
        data.GetPointData().AddArray(values)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


INSTRUCTION = re.compile("must |; (add|check|choose|connect|correct|cut|did you mean|give|hide|"
                         "leave|move|name|put|raise|repair|save|set|unpack|use) ")


class Messages:
    """Collects what VTK says while it is active, in place of printing it, and fails where that does
    not say what to do."""

    def __enter__(self):
        self.path = os.path.join(output_folder(), f"messages-{os.getpid()}.txt")
        self.previous = vtkOutputWindow.GetInstance()
        window = vtkFileOutputWindow()
        window.SetFileName(self.path)
        window.SetFlush(True)
        vtkOutputWindow.SetInstance(window)
        return self

    def __exit__(self, failure, *_):
        vtkOutputWindow.SetInstance(self.previous)
        self.text = ""
        if os.path.exists(self.path):
            with open(self.path, encoding="utf-8", errors="replace") as file:
                self.text = file.read()
            os.remove(self.path)
        if self.text and failure is None and not INSTRUCTION.search(self.text):
            raise AssertionError("does not say what to do: " + self.text)


def splat(source, size=64, **camera):
    """Radiance and transmittance (rows from the bottom up) of a SplatImage of `source`, of this
    width and height."""
    width, height = (size, size) if isinstance(size, int) else size
    picture = simple.SplatImage(Input=source, ImageSize=[width, height], **camera)
    picture.UpdatePipeline()
    data = servermanager.Fetch(picture).GetPointData()
    result = tuple(
        vtk_to_numpy(data.GetArray(name)).reshape(height, width, 3).copy()
        for name in ("Radiance", "Transmittance")
    )
    picture.UpdatePropertyInformation()
    splat.effects = str(picture.ActiveEffects)
    simple.Delete(picture)
    return result


class FolderTest(unittest.TestCase):
    """A test with a folder of its own, which is gone after it."""

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)


_FOLDER = tempfile.TemporaryDirectory()


def written(name, text):
    """The path of a file of this name with this text, which goes when the tests end."""
    path = os.path.join(_FOLDER.name, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def points_of(proxy):
    data = servermanager.Fetch(proxy)
    if data.GetNumberOfPoints() == 0:
        return np.zeros((0, 3))
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def light_of(proxy):
    return array(proxy, "Intensity").astype(float)


def count_of(proxy):
    return proxy.GetDataInformation().GetNumberOfPoints()


class ProxyTest(unittest.TestCase):
    def refused(self, proxy, names):
        """Each of these values of a property is refused by the name of its key, and the filter
        works again afterwards."""
        for prop, (value, key) in names.items():
            good = proxy.GetPropertyValue(prop)
            good = list(good) if isinstance(value, list) else good  # else a view of the property
            proxy.SetPropertyWithName(prop, value)
            with Messages() as messages:
                proxy.UpdatePipeline()
            self.assertIn(key, messages.text, prop)
            self.assertIn("must be", messages.text, prop)
            self.assertEqual(count_of(proxy), 0, prop)
            proxy.SetPropertyWithName(prop, good)
        proxy.UpdatePipeline()
        self.assertGreater(count_of(proxy), 0)
