"""Every number that a user can give a proxy of the plugin: it makes finite output, or an error or a
warning names the property."""
import json
import os
import re
import tempfile
import unittest

os.environ["OMP_NUM_THREADS"] = "1"  # many small models, for which threads are more work than they do

import numpy as np
from paraview import simple

import galaxy_testing as gt

BEFORE = set(vars(simple))
gt.load_plugin()
PROXIES = set(vars(simple)) - BEFORE

FLOATS = (-1.0, 0.0, float("nan"), float("inf"), float("-inf"), 1e300)
INTEGERS = (-1, 0)
SCENE = """[galaxy]
ra = 204.25
dec = -29.87
distance = 4.9
inclination = 30
radius = 5
[image.i]
file = "picture.fits"
[[component]]
name = "stars"
particles = 80
layers = [{ image = "i", clip = [0, 1] }]
[[component]]
name = "counted"
particles = "Auto"
noise = 0.2
layers = [{ image = "i", clip = [0, 1] }]
[[component]]
name = "dust"
role = "Absorbs"
particles = 20
layers = [{ image = "i", clip = [0, 1] }]
[component.dust]
steps = 5
"""


def write_fits(path, values, cards):
    """An image with the given values and header cards, by hand."""
    height, width = values.shape
    cards = {"SIMPLE": "T", "BITPIX": -64, "NAXIS": 2, "NAXIS1": width, "NAXIS2": height, **cards}
    text = "".join(f"{key:8}= {value:>20}".ljust(80) for key, value in cards.items()) + "END"
    data = values.astype(">f8").tobytes()
    with open(path, "wb") as file:
        file.write(text.ljust(-(-len(text) // 2880) * 2880).encode())
        file.write(data.ljust(-(-len(data) // 2880) * 2880, b"\0"))


def write_scene(folder, holes=()):
    """`holes`: (row, column, value) of pixels with values of their own."""
    y, x = np.indices((24, 24)) - 11.5
    values = np.exp(-np.hypot(x, y) / 5)
    for row, column, value in holes:
        values[row, column] = value
    write_fits(os.path.join(folder, "picture.fits"), values, {
        "CTYPE1": "'RA---TAN'", "CTYPE2": "'DEC--TAN'", "CRVAL1": 204.25, "CRVAL2": -29.87,
        "CRPIX1": 12.5, "CRPIX2": 12.5, "CDELT1": -20 / 3600, "CDELT2": 20 / 3600})
    for name, text in (
        ("scene.galaxy", SCENE),
        ("scene.rings", "0 100 5 30 40\n200 200 5 40 50\n"),
        ("scene.galaxygroup", "[[member]]\ngalaxy = 'scene.galaxy'\n"),
    ):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)


def arrays_of(data):
    """Every array of numbers of a data object, with those of its parts."""
    if data.IsA("vtkPartitionedDataSetCollection"):
        for k in range(data.GetNumberOfPartitionedDataSets()):
            for part in range(data.GetNumberOfPartitions(k)):
                yield from arrays_of(data.GetPartition(k, part))
        return
    if data.IsA("vtkPointSet") and data.GetPoints():
        yield data.GetPoints().GetData()
    for attributes in (data.GetPointData(), data.GetCellData()):
        for k in range(attributes.GetNumberOfArrays()):
            if attributes.GetArray(k):
                yield attributes.GetArray(k)


def are_finite(data):
    return all(np.all(np.isfinite(gt.vtk_to_numpy(array))) for array in arrays_of(data))


def size_of(data):
    return sum(array.GetNumberOfTuples() for array in arrays_of(data))


def plain(text):
    """Without regard to capitals, blanks and underscores."""
    return re.sub("[ _]", "", text).lower()


class Refusals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.directory.cleanup)
        write_scene(cls.directory.name)

    def path(self, name):
        return os.path.join(self.directory.name, name)

    def galaxy(self):
        return simple.GalaxyReader(FileName=self.path("scene.galaxy"))

    def makers(self):
        """By proxy: how it is made, and the modes in which its properties have a meaning."""
        galaxy = self.galaxy()
        stars = simple.DiskSeeds(Input=galaxy, Component="stars")
        dust = simple.DiskSeeds(Input=galaxy, Component="dust")
        model = simple.GalaxyModel(Input=galaxy)

        def models(*names):
            return [{"Model": name} for name in names]

        def profiles(*names):
            return [{"Profile": name, "NumberOfParticles": 50} for name in names]

        return {
            "FITSReader": (lambda: simple.FITSReader(FileName=self.path("picture.fits")), [{}]),
            "TiltedRingReader": (
                lambda: simple.TiltedRingReader(FileName=self.path("scene.rings")), [{}]),
            "GalaxyReader": (self.galaxy, [{}]),
            "GalaxyGroup": (
                lambda: simple.GalaxyGroup(FileName=self.path("scene.galaxygroup")), [{}]),
            "GalaxyModel": (lambda: simple.GalaxyModel(Input=galaxy), [{}, {"Velocities": 1}]),
            "DiskSeeds": (
                lambda: simple.DiskSeeds(Input=galaxy),
                [{"Component": "stars"}, {"Component": "counted"},
                 {"Component": "stars", "Sampling": "SurfaceUniform"}]),
            "DiskThickness": (
                lambda: simple.DiskThickness(Input=stars),
                models("FromDescription", "Gaussian", "Tapered", "Flared", "Hydrostatic",
                       "Rings")),
            "DustFilaments": (
                lambda: simple.DustFilaments(Input=dust),
                models("FromDescription", "RingVelocity", "DiskRotation", "Fractal")),
            "Spheroid": (
                simple.Spheroid,
                profiles("Gaussian", "Sersic", "Hernquist", "Exponential", "Plummer", "NFW",
                         "Cored")),
            "SmoothingLength": (
                lambda: simple.SmoothingLength(Input=model),
                models("Density", "Neighbours", "Constant", "Brightness")),
            "SplatImage": (
                lambda: simple.SplatImage(Input=model, ImageSize=[16, 16]), [{}]),
            "SplatImageWriter": (
                lambda: simple.SplatImageWriter(
                    Input=simple.SplatImage(Input=model, ImageSize=[16, 16]),
                    FileName=self.path("light.fits")), [{}]),
            "ParticleWriter": (
                lambda: simple.ParticleWriter(Input=model, FileName=self.path("model.gad")), [{}]),
        }

    def numeric_properties(self, proxy):
        """(name, SM property, numbers to try) of a proxy."""
        definition = proxy.SMProxy
        for name in proxy.ListProperties():
            prop = definition.GetProperty(name)
            if prop is None or prop.GetInformationOnly():
                continue
            if prop.IsA("vtkSMDoubleVectorProperty"):
                yield name, prop, FLOATS
            elif prop.IsA("vtkSMIntVectorProperty") or prop.IsA("vtkSMIdTypeVectorProperty"):
                yield name, prop, INTEGERS

    def update(self, proxy):
        with gt.Messages() as messages:
            proxy.SMProxy.UpdateVTKObjects()
            proxy.UpdatePipeline()
        return messages.text

    def judge(self, proxy, name, value, text):
        """What is wrong with how the proxy took a value; empty where nothing is."""
        is_named = plain(name).rstrip("s") in plain(text)
        if text and not is_named:
            return "the message does not name it: " + text.strip().splitlines()[-1]
        if proxy.SMProxy.IsA("vtkSMWriterProxy"):
            return ""
        data = proxy.GetClientSideObject().GetOutputDataObject(0)
        if not are_finite(data):
            return "numbers that are not finite"
        if not text and value != 0 and size_of(data) == 0:
            return "nothing comes out, and nothing is said"
        return ""

    def try_property(self, proxy, name, prop, values):
        wrong = []
        good = [prop.GetElement(k) for k in range(prop.GetNumberOfElements())]
        for place in range(len(good)):
            for value in values:
                prop.SetElement(place, value)
                problem = self.judge(proxy, name, value, self.update(proxy))
                if problem:
                    wrong.append(f"{name}[{place}] = {value}: {problem}")
            prop.SetElement(place, good[place])
        return wrong

    def test_every_proxy_of_the_plugin_is_tried(self):
        self.assertEqual(PROXIES, set(self.makers()))

    def test_a_number_is_refused_by_its_name_or_gives_finite_output(self):
        for kind, (make, modes) in self.makers().items():
            for mode in modes:
                with self.subTest(proxy=kind, **mode):
                    proxy = make()
                    for name, value in mode.items():
                        proxy.SetPropertyWithName(name, value)
                    self.assertEqual(self.update(proxy), "")
                    wrong = []
                    for name, prop, values in self.numeric_properties(proxy):
                        if name not in mode:
                            wrong += self.try_property(proxy, name, prop, values)
                    self.assertEqual(wrong, [], "\n" + "\n".join(wrong))
                    simple.Delete(proxy)

    def messages_of(self, kind, **properties):
        proxy = self.makers()[kind][0]()
        for name, value in properties.items():
            proxy.SetPropertyWithName(name, value)
        return self.update(proxy)

    def test_these_are_refused(self):
        nan, inf = float("nan"), float("inf")
        for kind, name, values in (
            ("GalaxyGroup", "Magnification", (-1, 0, nan, inf, 1e300)),
            ("GalaxyGroup", "Separation", (-1, 0, nan, inf)),
            ("GalaxyGroup", "ParticleScale", (-1, nan, inf, 1e300)),
            ("GalaxyGroup", "RandomSeed", (-1,)),
            ("GalaxyModel", "ParticleScale", (-1, nan, inf, 1e300)),
            ("GalaxyModel", "ViewPixel", (-1, nan, inf)),
            ("GalaxyModel", "RandomSeed", (-1,)),
            ("DiskSeeds", "ParticleScale", (-1, nan, inf, 1e300)),
            ("DiskSeeds", "ViewPixel", (-1, nan, inf)),
            ("DiskSeeds", "RandomSeed", (-1,)),
            ("TiltedRingReader", "Distance", (-1, nan, inf, 1e300)),
            ("TiltedRingReader", "PixelScale", (-1, nan, inf)),
            ("TiltedRingReader", "Disk", (-1, 0)),
        ):
            for value in values:
                with self.subTest(proxy=kind, name=name, value=value):
                    said = self.messages_of(kind, **{name: value})
                    self.assertRegex(said, r"ERROR|Error")
                    self.assertIn(name, said)

    def test_light_without_particles_is_said(self):
        said = self.messages_of("GalaxyModel", ParticleScale=0)
        self.assertIn("no particles for stars, counted, dust", said)
        self.assertIn("; raise `particles` or ParticleScale", said)

    def test_blank_and_negative_pixels_are_counted(self):
        nan = float("nan")
        holes = [(0, 0, nan), (10, 11, nan), (10, 12, nan), (3, 4, -1e-3), (12, 12, -7)]
        with tempfile.TemporaryDirectory() as folder:
            write_scene(folder, holes)
            model = simple.GalaxyModel(
                Input=simple.GalaxyReader(FileName=os.path.join(folder, "scene.galaxy")))
            self.update(model)
            model.UpdatePropertyInformation()
        for component in json.loads(str(model.ReportJSON)):
            self.assertEqual(component["blank_pixels"], 3)
            self.assertEqual(component["negative_pixels"], 2)
        self.assertEqual(str(model.Report).count("3 are blank and 2 negative"), 3)
        self.assertTrue(are_finite(model.GetClientSideObject().GetOutputDataObject(0)))

    def test_a_tiny_scale_leaves_no_component_dark(self):
        galaxy = self.galaxy()
        light = []
        for properties in ({}, {"ParticleScale": 1e-9}, {"ViewPixel": 1e6}):
            model = simple.GalaxyModel(Input=galaxy, **properties)
            self.assertEqual(self.update(model), "")
            light.append(np.bincount(gt.array(model, "Component"),
                                     gt.array(model, "Intensity").astype(float)))
        # One particle has the light of that joined pixel which the disc's centre is on.
        for few in light[1:]:
            self.assertTrue(np.all(few > 0.6 * light[0]))
            self.assertTrue(np.all(few < 1.5 * light[0]))

    def test_seeds_of_an_automatic_count_are_the_models(self):
        galaxy = self.galaxy()
        kept = []
        for view_pixel in (0, 1, 2.5):
            model = simple.GalaxyModel(Input=galaxy, ViewPixel=view_pixel)
            seeds = simple.DiskSeeds(Input=galaxy, Component="counted", ViewPixel=view_pixel)
            model.UpdatePipeline()
            seeds.UpdatePipeline()
            model.UpdatePropertyInformation()
            counted = json.loads(str(model.ReportJSON))[1]
            self.assertEqual(counted["component"], "counted")
            self.assertEqual(counted["seeds_kept"],
                             seeds.GetDataInformation().GetNumberOfPoints())
            kept.append(counted["seeds_kept"])
        self.assertEqual(sorted(kept, reverse=True), kept)
        self.assertGreater(kept[0], kept[-1])


if __name__ == "__main__":
    unittest.main()
