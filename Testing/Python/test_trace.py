"""Python trace: what is done with each proxy becomes a script that does the same. Needs a display."""
import contextlib
import os
import unittest

import numpy as np
from paraview import simple, smtrace

import galaxy_testing as gt
import plugin_xml
import replay

M83_FOLDER = os.path.dirname(gt.M83)
GROUP = os.path.join(gt.ROOT, "Examples", "M83Group", "m83group.galaxygroup")
WRITTEN = ("trace.hdf5", "trace.g1")  # an HDF5 file has the time in it


@contextlib.contextmanager
def modified(proxy):
    """What is set in here is traced, as what is set in the window's Properties panel."""
    item = smtrace._create_trace_item_internal("PropertiesModified", kwargs={"proxy": proxy.SMProxy})
    yield proxy
    item.finalize()


def change(proxy, **values):
    with modified(proxy):
        for name, value in values.items():
            proxy.SetPropertyWithName(name, value)
    return proxy


def save(source, path):
    """File > Save Data."""
    writer = simple.CreateWriter(path, source)
    smtrace._create_trace_item_internal("SaveData", kwargs={
        "writer": writer.SMProxy, "filename": path, "source": source.SMProxy, "port": 0})
    writer.UpdatePipeline()


def opened(folder, name, **values):
    return change(simple.OpenDataFile(os.path.join(folder, name), registrationName=name), **values)


def seeds_of(galaxy, component):
    return change(simple.DiskSeeds(registrationName=component + " seeds", Input=galaxy),
                  Component=component, ParticleScale=0.004)


def particles(galaxy):
    """Every filter that makes particles, with settings that are not the default."""
    model = change(simple.GalaxyModel(registrationName="model", Input=galaxy),
                   ParticleScale=0.004, RandomSeed=7)
    disk = simple.DiskThickness(registrationName="disk", Input=seeds_of(galaxy, "gas"))
    change(disk, Model="Flared", Children=3.0, FWHMMaximum=2.5)
    dust = simple.DustFilaments(registrationName="dust", Input=seeds_of(galaxy, "dust"))
    change(dust, Model="DiskRotation", Steps=3)
    spheroid = change(simple.Spheroid(registrationName="bulge"), Profile="Plummer",
                      NumberOfParticles=3000, Center=[3.0, 2.0, 1.0], ScaleRadius=0.5)
    wide = change(simple.SmoothingLength(registrationName="wide", Input=spheroid),
                  Model="Constant", Length=0.4)
    dwarfs = change(simple.OpenDataFile(GROUP, registrationName="group"),
                    ParticleScale=0.002, Separation=0.02)
    return model, disk, dust, wide, dwarfs


def work():
    """A session with every proxy; the view and the picture without a display."""
    galaxy = opened(M83_FOLDER, "m83.galaxy")
    opened(M83_FOLDER, "images/m83_r.fits", MaskValues=[0.0, 3.0])
    rings = opened(M83_FOLDER, "m83.rings", Distance=4.9)
    view = simple.CreateView("RenderView")
    change(view, UseColorPaletteForBackground=0, Background=[0.0, 0.0, 0.1],
           OrientationAxesVisibility=0, ViewSize=[replay.SIZE, replay.SIZE])
    made = particles(galaxy)
    for proxy in made:
        change(simple.Show(proxy, view), Exposure=0.4, Accuracy="Sorted")
    change(simple.GetDisplayProperties(made[0], view), ComponentVisibility=["gas", "0"],
           ComponentSize=["stars", "1.5"], ComponentBrightness=["young stars", "2"], Gamma=1.2)
    simple.Show(rings, view)
    simple.Hide(made[2], view)
    picture = change(simple.SplatImage(registrationName="picture", Input=made[0]),
                     ImageSize=[64, 48], CameraPosition=[0.0, 0.0, 60.0],
                     ComponentVisibility=["dust", "0"])
    for name in WRITTEN:
        save(made[3], replay.output(name))
    replay.look_at(view)
    return view, picture


def bytes_of(path):
    with open(path, "rb") as file:
        return file.read()


class Trace(unittest.TestCase):
    def test_a_trace_does_the_same(self):
        smtrace.start_trace(preamble="")
        gt.load_plugin()
        view, picture = work()
        seen = replay.shot(view, replay.output("trace.png"))
        script = smtrace.stop_trace()
        self.assertGreater(seen.max(), 200)
        for _, name, _ in plugin_xml.made_by_users():
            self.assertIn(name + "(", script)
        files = [replay.output(name) for name in WRITTEN]
        written = bytes_of(files[1])
        for path in files:
            os.remove(path)
        again = replay.run(script)
        np.testing.assert_array_equal(again["view"], seen)
        np.testing.assert_array_equal(again["picture"], replay.light(picture))
        self.assertEqual(bytes_of(files[1]), written)
        self.assertTrue(os.path.exists(files[0]))
        simple.Delete(view)  # ParaView does not survive sys.exit with one


if __name__ == "__main__":
    unittest.main()
