"""ParticleWriter: what it writes, read back by yt, splash and h5py."""
import os
import shutil
import subprocess
import unittest

import numpy as np
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkStringArray, vtkUnsignedCharArray

import galaxy_testing as gt

try:
    import h5py
except ImportError:
    gt.skip("h5py is not installed")
try:
    import yt
    from yt.frontends.gadget.io import IOHandlerGadgetBinary

    yt.set_log_level("error")
    IOHandlerGadgetBinary._vector_fields["Color"] = 3
except ImportError:
    gt.skip("yt is not installed")
if not shutil.which("splash"):
    gt.skip("splash is not installed")

gt.load_plugin()
NAMES = ["stars", "gas", "dust", "bulge"]
ABSORBS = [0, 0, 1, 0]
GADGET_TYPES = [2, 0, 5, 3]
YT_TYPES = ("Gas", "Halo", "Disk", "Bulge", "Stars", "Bndry")
YT_FIELDS = (
    "Coordinates", "Velocities", "ParticleIDs", "Mass", ("InternalEnergy", "Gas"),
    ("Density", "Gas"), "SmoothingLength", "Component", "Color",
)


def add_component_table(data):
    names, absorbs = vtkStringArray(), vtkUnsignedCharArray()
    names.SetName("ComponentName")
    absorbs.SetName("ComponentAbsorbs")
    for name, absorbing in zip(NAMES, ABSORBS):
        names.InsertNextValue(name)
        absorbs.InsertNextValue(absorbing)
    data.GetFieldData().AddArray(names)
    data.GetFieldData().AddArray(absorbs)


class Sample:
    """Particles of four components in no order, as arrays and as a proxy."""

    names, absorbs, gadget_types = NAMES, ABSORBS, GADGET_TYPES

    def __init__(self, count=5000, components=(0, 1, 2, 3)):
        random = np.random.default_rng(11)
        self.position = random.normal(size=(count, 3)).astype(np.float32)
        self.smoothing_length = random.uniform(0.1, 0.3, count).astype(np.float32)
        self.arrays = {
            "Velocity": (200 * random.normal(size=(count, 3))).astype(np.float32),
            "Intensity": np.exp(9 * random.normal(size=count)).astype(np.float32),
            "Color": random.integers(0, 256, (count, 3)).astype(np.uint8),
            "Component": random.choice(components, count).astype(np.uint8),
        }
        self.proxy = gt.particles(self.position, self.smoothing_length, **self.arrays)
        add_component_table(self.proxy.GetClientSideObject().GetOutputDataObject(0))
        self.type = np.array(self.gadget_types)[self.arrays["Component"]]

    def of_type(self, gadget_type):
        """Every array of the particles of one type, by the names of HDF5."""
        chosen = self.type == gadget_type
        intensity = self.arrays["Intensity"][chosen]
        return {
            "Coordinates": self.position[chosen],
            "Velocities": self.arrays["Velocity"][chosen],
            "ParticleIDs": np.flatnonzero(chosen) + 1,
            "Masses": intensity,
            "Intensity": intensity,
            "SmoothingLength": self.smoothing_length[chosen],
            "Component": self.arrays["Component"][chosen],
            "Color": self.arrays["Color"][chosen],
        }


class Model(Sample):
    """The particles of M83's model, a few of them, with velocities."""

    names = ["stars", "young stars", "gas", "dust", "bulge"]
    absorbs = [0, 0, 0, 1, 0]
    gadget_types = [2, 4, 0, 5, 3]

    def __init__(self):
        self.proxy = simple.GalaxyModel(
            Input=simple.GalaxyReader(FileName=gt.M83), ParticleScale=0.002, Velocities=1)
        data = servermanager.Fetch(self.proxy)
        self.position = gt.vtk_to_numpy(data.GetPoints().GetData()).copy()
        attributes = data.GetPointData()
        self.arrays = {name: gt.vtk_to_numpy(attributes.GetArray(name)).copy()
                       for name in ("Velocity", "Intensity", "Color", "Component")}
        self.smoothing_length = gt.vtk_to_numpy(attributes.GetArray("SmoothingLength")).copy()
        self.type = np.array(self.gadget_types)[self.arrays["Component"]]


class Writers(gt.FolderTest):
    def assert_same(self, read, expected, what=""):
        """Equal to the last bit, as float32 or as integers."""
        np.testing.assert_array_equal(np.asarray(read), expected, what)

    def test_h5py_reads_every_array_and_the_components(self):
        self.check_h5py(Sample())

    def check_h5py(self, sample):
        simple.SaveData(self.path("model.hdf5"), proxy=sample.proxy)
        with h5py.File(self.path("model.hdf5")) as file:
            for gadget_type in sample.gadget_types:
                group = file[f"PartType{gadget_type}"]
                for name, values in sample.of_type(gadget_type).items():
                    self.assert_same(group[name], values, name)
                self.assertEqual(group["Coordinates"].attrs["Unit"].decode(), "kpc")
            self.assertEqual(file["PartType2/Color"].dtype, np.uint8)
            self.assertEqual("Density" in file["PartType2"], False)
            table = file["Components"]
            self.assertEqual([name.decode() for name in table["Name"]], sample.names)
            self.assert_same(table["Absorbs"], sample.absorbs)
            self.assert_same(table["ParticleType"], sample.gadget_types)
            if not isinstance(sample, Model):
                self.assert_same(table["Absorption"], np.ones((4, 3)))
            counts = np.bincount(sample.type, minlength=6)
            self.assert_same(file["Header"].attrs["NumPart_Total"], counts)

    def check_yt(self, dataset, sample, types, names):
        data = dataset.all_data()
        for gadget_type in sample.gadget_types:
            for name, values in sample.of_type(gadget_type).items():
                field = (types[gadget_type], names.get(name, name))
                if name == "Intensity" and field not in dataset.field_list:
                    continue
                read = data[field]
                if name == "Coordinates":
                    read = read.to("kpc").astype(np.float32)
                self.assert_same(read, values, field)

    def test_yt_reads_both_binary_formats(self):
        self.check_yt_binary(Sample())

    def check_yt_binary(self, sample):
        for name in ("model.g1", "model.gad"):
            simple.SaveData(self.path(name), proxy=sample.proxy)
            dataset = yt.load(self.path(name), field_spec=YT_FIELDS)
            self.check_yt(dataset, sample, YT_TYPES, {"Masses": "Mass"})

    def test_yt_reads_a_binary_file_as_it_comes(self):
        # Without a word on its fields: what every Gadget file has is where yt looks for it.
        sample = Sample()
        gas = sample.of_type(0)
        for name in ("model.g1", "model.gad"):
            simple.SaveData(self.path(name), proxy=sample.proxy)
            data = yt.load(self.path(name)).all_data()
            self.assert_same(data["Gas", "SmoothingLength"], gas["SmoothingLength"])
            self.assert_same(data["Bndry", "Mass"], sample.of_type(5)["Masses"])

    def test_yt_reads_hdf5(self):
        self.check_yt_hdf5(Sample())

    def check_yt_hdf5(self, sample):
        simple.SaveData(self.path("model.h5"), proxy=sample.proxy)
        dataset = yt.load(self.path("model.h5"))
        self.check_yt(dataset, sample, [f"PartType{k}" for k in range(6)], {})

    def test_yt_projects_the_intensity_of_gas(self):
        sample = Sample()
        simple.SaveData(self.path("model.hdf5"), proxy=sample.proxy)
        box = np.array([[-6, 6]] * 3)
        dataset = yt.load(self.path("model.hdf5"), bounding_box=box)
        image = dataset.proj(("gas", "density"), "z").to_frb((12, "kpc"), 256)["gas", "density"]
        pixel = dataset.quan(12 / 256, "code_length") ** 2
        total = float((image * pixel).sum().to("code_mass"))
        self.assertAlmostEqual(total / sample.of_type(0)["Masses"].sum(dtype=float), 1, places=2)

    def splash(self, name, gadget_format):
        """The columns that splash reads of a file."""
        environment = dict(os.environ, GSPLASH_FORMAT=str(gadget_format))
        result = subprocess.run(
            ["splash", "to", "ascii", name, "-gadget"], cwd=self.folder, env=environment,
            stdin=subprocess.DEVNULL, capture_output=True, timeout=60, check=True,
        )
        self.assertNotIn(b"ERROR", result.stdout)
        return np.loadtxt(self.path(name + ".ascii")).T

    def test_splash_reads_both_binary_formats(self):
        self.check_splash(Sample())

    def check_splash(self, sample):
        of_type = [sample.of_type(k) for k in sorted(sample.gadget_types)]

        def all_types(name):
            return np.concatenate([arrays[name] for arrays in of_type])

        gas = len(of_type[0]["Masses"])
        halved = all_types("SmoothingLength")  # splash's own h is half of Gadget's, for gas
        halved[:gas] *= 0.5
        for name, gadget_format in (("model.g1", 1), ("model.gad", 2)):
            simple.SaveData(self.path(name), proxy=sample.proxy)
            columns = self.splash(name, gadget_format).astype(np.float32)
            self.assert_same(columns[:3].T, all_types("Coordinates"))
            self.assert_same(columns[3:6].T, all_types("Velocities"))
            self.assert_same(columns[6], all_types("Masses"))
            read = slice(None) if gadget_format == 2 else slice(gas)
            self.assert_same(columns[9][read], halved[read])
        self.assert_same(columns[10], all_types("Component"))  # format 2 alone

    def test_splash_reads_particles_without_gas(self):
        # Of named blocks splash 3.6 loses count behind the masses where there is no gas.
        sample = Sample(components=(0, 2))
        simple.SaveData(self.path("model.g1"), proxy=sample.proxy)
        columns = self.splash("model.g1", 1).astype(np.float32)
        of_type = [sample.of_type(k) for k in (2, 5)]
        self.assert_same(columns[:3].T, np.concatenate([part["Coordinates"] for part in of_type]))
        self.assert_same(columns[6], np.concatenate([part["Masses"] for part in of_type]))

    def test_csv_by_the_writers_name(self):
        self.check_csv(Sample())

    def check_csv(self, sample):
        writer = simple.ParticleWriter(Input=sample.proxy, FileName=self.path("model.csv"))
        writer.UpdatePipeline()
        table = np.genfromtxt(self.path("model.csv"), delimiter=",", names=True, dtype=np.float32)
        for channel, name in enumerate(("x_kpc", "y_kpc", "z_kpc")):
            self.assert_same(table[name], sample.position[:, channel])
        for channel, name in enumerate(("vx_km_s", "vy_km_s", "vz_km_s")):
            self.assert_same(table[name], sample.arrays["Velocity"][:, channel])
        for channel, name in enumerate(("red", "green", "blue")):
            self.assert_same(table[name], sample.arrays["Color"][:, channel])
        self.assert_same(table["smoothing_length_kpc"], sample.smoothing_length)
        self.assert_same(table["intensity"], sample.arrays["Intensity"])
        self.assert_same(table["component"], sample.arrays["Component"])
        self.assert_same(table["absorbs"], np.array(sample.absorbs)[sample.arrays["Component"]])

    def test_a_models_particles_by_every_writer(self):
        sample = Model()
        self.assertGreater(len(sample.position), 1000)
        self.assertGreater(np.abs(sample.arrays["Velocity"]).max(), 100)
        self.assertEqual(set(sample.type), set(sample.gadget_types))
        for check in (self.check_h5py, self.check_yt_binary, self.check_yt_hdf5,
                      self.check_splash, self.check_csv):
            with self.subTest(check=check.__name__):
                check(sample)

    def test_an_index_that_is_none_is_refused(self):
        for value in (np.nan, -1.0, 256.0, 0.5, np.inf):
            proxy = gt.particles(np.zeros((3, 3)), [1, 1, 1], Component=np.array([0, 1, value]))
            for name in ("model.gad", "model.h5"):
                with gt.Messages() as messages:
                    simple.SaveData(self.path(name), proxy=proxy)
                self.assertIn("Component must have whole numbers 0 to 255, not ", messages.text)
                self.assertIn("at point 2", messages.text)
            self.assertEqual(os.listdir(self.folder), [])

    def test_a_writer_that_is_stopped_says_so(self):
        sample = Sample(100000)
        for name in ("model.gad", "model.h5", "model.csv"):
            writer = simple.ParticleWriter(Input=sample.proxy, FileName=self.path(name))
            algorithm = writer.GetClientSideObject()
            algorithm.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
            with gt.Messages() as messages:
                writer.UpdatePipeline()
            self.assertIn(f"{name}: not written, for the writer was stopped", messages.text)
            self.assertNotEqual(algorithm.GetErrorCode(), 0)
            self.assertEqual(os.listdir(self.folder), [])

    def test_paraviews_own_csv_writer_still_answers(self):
        sample = Sample(10)
        simple.SaveData(self.path("model.csv"), proxy=sample.proxy)
        with open(self.path("model.csv"), encoding="utf-8") as file:
            self.assertIn('"Points:0"', file.readline())

    def test_format_wins_over_the_extension(self):
        sample = Sample(10)
        simple.SaveData(self.path("a.gad"), proxy=sample.proxy, Format="Gadget1")
        simple.SaveData(self.path("b.g1"), proxy=sample.proxy)
        with open(self.path("a.gad"), "rb") as one, open(self.path("b.g1"), "rb") as other:
            self.assertEqual(one.read(), other.read())

    def test_anyones_points(self):
        sphere = simple.Sphere(ThetaResolution=10)
        simple.SaveData(self.path("sphere.h5"), proxy=sphere)
        with h5py.File(self.path("sphere.h5")) as file:
            group = file["PartType2"]
            points = gt.vtk_to_numpy(servermanager.Fetch(sphere).GetPoints().GetData())
            self.assert_same(group["Coordinates"], points)
            self.assert_same(group["Velocities"], np.zeros_like(points))
            self.assert_same(group["Masses"], np.ones(len(points)))
            self.assert_same(group["Color"], np.full(points.shape, 255))

    def test_arrays_of_other_types_are_converted(self):
        proxy = gt.particles(
            np.zeros((3, 3)), [1, 1, 1], Intensity=np.array([1, 2, 3]),
            Velocity=np.arange(9.0).reshape(3, 3), Component=np.array([0, 5, 2]),
            Color=np.array([[0, 0.5, 1]] * 3), Emission=np.array([7.0, 8, 9]),
        )
        simple.SaveData(self.path("model.h5"), proxy=proxy)
        with h5py.File(self.path("model.h5")) as file:
            group = file["PartType2"]  # components without a table emit
            self.assert_same(group["Masses"], [1, 2, 3])
            self.assert_same(group["Velocities"], np.arange(9).reshape(3, 3))
            self.assert_same(group["Component"], [0, 5, 2])
            self.assert_same(group["Color"], [[0, 128, 255]] * 3)
            self.assert_same(group["Emission"], [7, 8, 9])
            self.assertEqual(len(file["Components/Name"]), 6)

    def test_what_does_not_fit_is_named_and_nothing_written(self):
        nan = np.array([[0, 0, 0], [0, np.nan, 0]])
        for cause, position, arrays in (
            ("Velocity must have 3 components, not 1", np.zeros((2, 3)), {"Velocity": [1.0, 2]}),
            ("Intensity must have 2 values, one a point, not 3", np.zeros((2, 3)),
             {"Intensity": [1.0, 2, 3]}),
            ("Component must have whole numbers", np.zeros((2, 3)), {"Component": [0, 256]}),
            ("particle 1: its position must be finite", nan, {}),
        ):
            proxy = gt.particles(position, [1, 1], **arrays)
            with gt.Messages() as messages:
                simple.SaveData(self.path("model.gad"), proxy=proxy)
            self.assertIn(cause, messages.text)
            self.assertEqual(os.listdir(self.folder), [])

    def test_a_place_that_cannot_be_written(self):
        with gt.Messages() as messages:
            simple.SaveData(self.path("none/model.gad"), proxy=Sample(10).proxy)
        self.assertIn("model.gad: cannot be written: No such file or directory", messages.text)


if __name__ == "__main__":
    unittest.main()
