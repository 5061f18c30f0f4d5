"""What others hand to Splat Image, Smoothing Length and Particle Writer: composite data, any point
set, arrays of any type."""
import os
import unittest

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSetCollection, vtkPolyData,
    vtkStructuredGrid, vtkTable, vtkUnstructuredGrid)

import galaxy_testing as gt

gt.load_plugin()
CAMERA = {"CameraParallelProjection": 1, "CameraParallelScale": 2.0, "CameraPosition": [0, 0, 5]}
RNG = np.random.default_rng(3)
COUNT = 300
PLACES = RNG.normal(0, 0.6, (COUNT, 3)).astype(np.float32)
H = np.full(COUNT, 0.3, np.float32)
LIGHT = RNG.uniform(0.5, 2, COUNT).astype(np.float32)
COLOR = RNG.integers(0, 256, (COUNT, 3)).astype(np.uint8)
HALF = COUNT // 2
STARS_AND_DUST = (("stars", 0, (1, 1, 1)), ("dust", 1, (0.5, 0.7, 1)))


def source_of(data):
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


def fill(data, part=slice(None), table=(), **arrays):
    """A point set with these arrays, and a component table."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(PLACES[part].copy(), deep=True))
    data.SetPoints(points)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values[part]), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    if table:
        names = vtkStringArray()
        names.SetName("ComponentName")
        for name, _, _ in table:
            names.InsertNextValue(name)
        data.GetFieldData().AddArray(names)
        for name, values, kind in (("ComponentAbsorbs", [row[1] for row in table], np.uint8),
                                   ("ComponentAbsorption", [row[2] for row in table], float)):
            array = numpy_to_vtk(np.array(values, kind), deep=True)
            array.SetName(name)
            data.GetFieldData().AddArray(array)
    return data


def whole(**arrays):
    return fill(vtkPolyData(), SmoothingLength=H, **{"Intensity": LIGHT, **arrays})


def image(data):
    source = source_of(data) if hasattr(data, "GetDataObjectType") else data
    return gt.splat(source, 48, **CAMERA)


class Inputs(unittest.TestCase):
    def same(self, data, like, tolerance=1e-5):
        expected = image(like)
        self.assertGreater(expected[0].max(), 0)
        for one, other in zip(image(data), expected):
            np.testing.assert_allclose(one, other, rtol=tolerance, atol=tolerance * other.max())

    def refused(self, data, *words):
        with gt.Messages() as messages:
            picture = simple.SplatImage(Input=source_of(data), ImageSize=[8, 8], **CAMERA)
            picture.UpdatePipeline()
        for word in words:
            self.assertIn(word, messages.text)

    def test_colors_of_every_type(self):
        as_bytes = whole(Color=COLOR)
        for other in (COLOR / 255, (COLOR / 255).astype(np.float32), COLOR.astype(np.uint16) * 257,
                      COLOR.astype(np.int64), COLOR.astype(np.int32), COLOR.astype(np.int16)):
            self.same(whole(Color=other), as_bytes)
        opaque = np.full((COUNT, 1), 255, np.uint8)
        self.same(whole(Color=np.hstack([COLOR, opaque])), as_bytes)
        self.same(whole(Color=np.hstack([COLOR, opaque]) / 255), as_bytes)
        grey = whole(Color=np.repeat(COLOR[:, :1], 3, axis=1))
        self.same(whole(Color=COLOR[:, 0]), grey)
        self.same(whole(Color=COLOR[:, 0] / 255), grey)

    def test_colors_beyond_their_range_are_refused(self):
        self.refused(whole(Color=COLOR.astype(np.int64) + 45), "Color must have", "0 to 255")
        self.refused(whole(Color=COLOR.astype(float)), "Color must have", "0 to 1", "Calculator")
        self.refused(whole(Color=COLOR.astype(np.int32) - 1), "Color must have", "not -1")
        self.refused(whole(Color=np.hstack([COLOR, COLOR])), "Color must have 1 to 4", "not 6")

    def test_numbers_of_components_do_not_wrap(self):
        number = (np.arange(COUNT) % 2).astype(np.uint8)
        like = fill(vtkPolyData(), table=STARS_AND_DUST, SmoothingLength=H, Intensity=LIGHT,
                    Component=number)
        for kind in (np.int64, np.int32, np.float64):
            self.same(fill(vtkPolyData(), table=STARS_AND_DUST, SmoothingLength=H, Intensity=LIGHT,
                           Component=number.astype(kind)), like)
        for wrong in (256, 300, -1, 0.5, np.nan):
            self.refused(whole(Component=np.full(COUNT, wrong)),
                         "Component must have whole numbers 0 to 255")

    def test_other_types_of_numbers(self):
        like = whole()
        for kind in (np.float64, np.float32):
            self.same(whole(Intensity=LIGHT.astype(kind)), like)
        ones = np.ones(COUNT)
        self.same(whole(Intensity=ones.astype(np.int64)), whole(Intensity=ones))
        wide = whole()
        wide.GetPoints().SetData(numpy_to_vtk(PLACES.astype(float), deep=True))
        self.same(wide, like)

    def test_any_point_set(self):
        like = whole(Color=COLOR)
        arrays = {"SmoothingLength": H, "Intensity": LIGHT, "Color": COLOR}
        self.same(fill(vtkUnstructuredGrid(), **arrays), like)
        grid = vtkStructuredGrid()
        grid.SetDimensions(COUNT // 10, 10, 1)
        self.same(fill(grid, **arrays), like)
        lengths = simple.SmoothingLength(Input=source_of(like))
        kept = simple.Threshold(Input=lengths, Scalars=["POINTS", "Intensity"],
                                LowerThreshold=1.0, UpperThreshold=9.0)
        some = LIGHT >= 1
        kept.UpdatePipeline()
        self.assertEqual(gt.count_of(kept), some.sum())
        h = gt.array(lengths, "SmoothingLength")
        self.same(kept, fill(vtkPolyData(), some, SmoothingLength=h, Intensity=LIGHT, Color=COLOR))

    def test_images_and_tables(self):
        data = vtkImageData()
        data.SetDimensions(4, 3, 1)
        places = np.array([data.GetPoint(i) for i in range(12)], np.float32)
        for name, values in (("SmoothingLength", 0.4), ("Intensity", 1.0)):
            array = numpy_to_vtk(np.full(12, values), deep=True)
            array.SetName(name)
            data.GetPointData().AddArray(array)
        self.same(data, gt.particles(places, np.full(12, 0.4), Intensity=np.ones(12)))
        self.refused(vtkTable(), "vtkTable has no points", "Table To Points")

    def test_composite_data(self):
        first, second = slice(0, HALF), slice(HALF, None)
        arrays = {"SmoothingLength": H, "Intensity": LIGHT, "Color": COLOR}
        parts = [fill(vtkPolyData(), first, **arrays),
                 fill(vtkUnstructuredGrid(), second, **arrays)]
        like = whole(Color=COLOR)
        blocks = vtkMultiBlockDataSet()
        inner = vtkMultiBlockDataSet()
        inner.SetBlock(1, parts[1])
        inner.SetBlock(2, vtkPolyData())
        blocks.SetBlock(0, parts[0])
        blocks.SetBlock(1, inner)
        blocks.SetBlock(3, vtkTable())
        self.same(blocks, like)
        collection = vtkPartitionedDataSetCollection()
        for k, part in enumerate(parts):
            collection.SetPartition(2 * k, 1, part)
        self.same(collection, like)
        group = simple.GroupDatasets(Input=[source_of(part) for part in parts])
        self.same(group, like)

    def test_components_of_several_sets(self):
        """Of equal names and factors one, of others each its own."""
        number = (np.arange(COUNT) % 2).astype(np.uint8)
        like = fill(vtkPolyData(), table=STARS_AND_DUST, SmoothingLength=H, Intensity=0.1 * LIGHT,
                    Component=number)
        for tables in ((STARS_AND_DUST, STARS_AND_DUST), (STARS_AND_DUST, STARS_AND_DUST[::-1])):
            blocks = vtkMultiBlockDataSet()
            for k, part in enumerate((slice(0, HALF), slice(HALF, None))):
                own = number if tables[k] == STARS_AND_DUST else 1 - number
                blocks.SetBlock(k, fill(vtkPolyData(), part, table=tables[k], SmoothingLength=H,
                                        Intensity=0.1 * LIGHT, Component=own))
            self.same(blocks, like)
            writer = simple.ParticleWriter(Input=source_of(blocks))
            writer.FileName = os.path.join(gt.output_folder(), "two-tables.csv")
            with gt.Messages():
                writer.UpdatePipeline()
            rows = np.genfromtxt(writer.FileName, delimiter=",", names=True)
            np.testing.assert_array_equal(rows["component"], number)
            np.testing.assert_array_equal(rows["absorbs"], number)

    def test_arrays_that_only_some_sets_have(self):
        number = (np.arange(COUNT) % 2).astype(np.uint8)
        white = np.full((COUNT, 3), 255, np.uint8)
        emission = np.outer(LIGHT, [1, 1, 1]) * (number == 0)[:, None]
        absorption = np.outer(0.1 * LIGHT, [0.5, 0.7, 1]) * number[:, None]
        light = np.where(number, 0.1 * LIGHT, LIGHT)
        like = fill(vtkPolyData(), SmoothingLength=H, Emission=emission, Absorption=absorption)
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, fill(vtkPolyData(), slice(0, HALF), table=STARS_AND_DUST,
                                SmoothingLength=H, Intensity=light, Component=number, Color=white))
        blocks.SetBlock(1, fill(vtkPolyData(), slice(HALF, None), SmoothingLength=H,
                                Emission=emission, Absorption=absorption))
        self.same(blocks, like, 1e-4)
        blocks.SetBlock(2, fill(vtkPolyData(), Intensity=LIGHT))
        blocks.GetMetaData(2).Set(blocks.NAME(), "without h")
        self.refused(blocks, "without h: ", "no point array SmoothingLength")

    def test_smoothing_lengths_of_any_data(self):
        like = simple.SmoothingLength(Input=source_of(whole()))
        h = gt.array(like, "SmoothingLength")
        blocks = vtkMultiBlockDataSet()
        parts = [fill(vtkPolyData(), slice(0, HALF)), fill(vtkUnstructuredGrid(), slice(HALF, None))]
        for k, part in enumerate(parts):
            blocks.SetBlock(k, part)
        several = simple.SmoothingLength(Input=source_of(blocks))
        several.UpdatePipeline()
        output = several.GetClientSideObject().GetOutputDataObject(0)
        self.assertEqual(output.GetClassName(), "vtkMultiBlockDataSet")
        kinds = [output.GetBlock(k).GetClassName() for k in (0, 1)]
        self.assertEqual(kinds, ["vtkPolyData", "vtkUnstructuredGrid"])
        own = np.concatenate([
            vtk_to_numpy(output.GetBlock(k).GetPointData().GetArray("SmoothingLength"))
            for k in (0, 1)])
        np.testing.assert_array_equal(own, h)
        for part in parts:
            self.assertIsNone(part.GetPointData().GetArray("SmoothingLength"))

    def written(self, data, name):
        """The report, and what was said, of writing this file."""
        writer = simple.ParticleWriter(Input=source_of(data))
        writer.FileName = os.path.join(gt.output_folder(), name)
        with gt.Messages() as messages:
            writer.UpdatePipeline()
        writer.UpdatePropertyInformation()
        return str(writer.Report), messages.text, writer.FileName

    def test_the_writer_says_what_it_makes_up(self):
        made_up = ("velocities of 0 km/s", "smoothing lengths of 0 kpc", "masses of 1",
                   "component 0")
        report, message, path = self.written(fill(vtkPolyData()), "bare.hdf5")
        self.assertIn(f"{COUNT} particles written; made up: ", report)
        for words in made_up:
            self.assertIn(words, report)
            self.assertIn(words, message)
            self.assertIn(words.encode(), open(path, "rb").read())  # in the header's attribute
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, fill(vtkPolyData(), slice(0, 100)))
        blocks.SetBlock(1, fill(vtkPolyData(), slice(100, None), Intensity=LIGHT))
        report, _, _ = self.written(blocks, "some.csv")
        self.assertIn("masses of 1 (no point array Intensity for 100 particles)", report)
        number = np.zeros(COUNT, np.uint8)
        velocity = np.zeros((COUNT, 3), np.float32)
        report, message, path = self.written(
            whole(Velocity=velocity, Color=COLOR, Component=number), "own.hdf5")
        self.assertEqual(report, f"{COUNT} particles written")
        self.assertEqual(message, "")
        self.assertNotIn(b"MadeUp", open(path, "rb").read())


if __name__ == "__main__":
    unittest.main()
