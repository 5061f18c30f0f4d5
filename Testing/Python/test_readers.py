"""FITSReader, TiltedRingReader and GalaxyReader through the server manager."""
import os
import tempfile
import unittest

import numpy as np
from astropy.io import fits
from paraview import servermanager, simple

import galaxy_testing as gt

gt.load_plugin()


def fetch(proxy):
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy)


class Fits(gt.FolderTest):
    def test_mock_images_agree_with_astropy(self):
        folder = os.path.join(gt.ROOT, "Examples", "M83", "images")
        names = sorted(name for name in os.listdir(folder) if name.endswith(".fits"))
        self.assertEqual(len(names), 8)
        for name in names:
            reader = simple.FITSReader(FileName=os.path.join(folder, name))
            data = fetch(reader)
            expected = fits.getdata(os.path.join(folder, name)).astype(float)
            values = gt.vtk_to_numpy(data.GetPointData().GetArray("Intensity"))
            np.testing.assert_array_equal(values.reshape(expected.shape), expected)
            self.assertEqual(data.GetOrigin(), (1.0, 1.0, 0.0))
            cards = data.GetFieldData().GetAbstractArray("FITSHeader")
            text = [cards.GetValue(i) for i in range(cards.GetNumberOfValues())]
            self.assertTrue(any("mock" in card.lower() for card in text), name)

    def test_plane_extension_scaling_and_blank(self):
        rng = np.random.default_rng(3)
        cube = rng.normal(size=(4, 3, 5)).astype(np.float32)
        scaled = fits.ImageHDU(np.arange(6, dtype=np.int16).reshape(2, 3), name="SCALED")
        hdus = fits.HDUList([fits.PrimaryHDU(cube), scaled])
        hdus.writeto(self.path("cube.fits"))
        with fits.open(self.path("cube.fits"), mode="update", do_not_scale_image_data=True) as file:
            file["SCALED"].header["BSCALE"] = 0.5
            file["SCALED"].header["BZERO"] = 10.0
            file["SCALED"].header["BLANK"] = 4
        plane = fetch(simple.FITSReader(FileName=self.path("cube.fits"), Plane=2))
        values = gt.vtk_to_numpy(plane.GetPointData().GetArray("Intensity"))
        np.testing.assert_array_equal(values.reshape(3, 5), cube[2].astype(float))
        image = fetch(simple.FITSReader(FileName=self.path("cube.fits"), Extension="SCALED"))
        values = gt.vtk_to_numpy(image.GetPointData().GetArray("Intensity"))
        np.testing.assert_array_equal(values, [10, 10.5, 11, 11.5, np.nan, 12.5])

    def test_planes_moment_and_masked_values(self):
        rng = np.random.default_rng(5)
        cube = rng.normal(size=(6, 4, 5)).astype(np.float32)
        header = fits.Header()
        header.update(CTYPE3="VRAD", CUNIT3="m/s", CRVAL3=100e3, CRPIX3=1.0, CDELT3=-5e3,
                      BUNIT="JY/BEAM")
        fits.PrimaryHDU(cube, header).writeto(self.path("line.fits"))

        def values(**properties):
            data = fetch(simple.FITSReader(FileName=self.path("line.fits"), **properties))
            return gt.vtk_to_numpy(data.GetPointData().GetArray("Intensity")).reshape(4, 5)

        mean = cube[1:4].astype(float).mean(axis=0)
        np.testing.assert_allclose(values(Planes=[1, 3]), mean, rtol=1e-12)
        # Channels lie at 100, 95, 90 ... km/s; those from 88 to 96 are the second and the third.
        moment = 5 * cube[1:3].astype(float).sum(axis=0)
        np.testing.assert_allclose(values(VelocityRange=[88, 96]), moment, rtol=1e-12)
        masked = values(Plane=0, MaskValues=[float(cube[0, 2, 3])])
        self.assertTrue(np.isnan(masked[2, 3]))
        self.assertEqual(np.isnan(masked).sum(), 1)

    def test_asinh_magnitudes_are_linear(self):
        stored = np.arange(6, dtype=np.float32).reshape(2, 3)
        header = fits.Header()
        header.update(BSOFTEN=120.0, BOFFSET=35.0)
        fits.PrimaryHDU(stored, header).writeto(self.path("stack.fits"))
        data = fetch(simple.FITSReader(FileName=self.path("stack.fits")))
        values = gt.vtk_to_numpy(data.GetPointData().GetArray("Intensity"))
        factor = 10 ** (stored.ravel() / 2.5)
        np.testing.assert_allclose(values, 35 + 120 * (factor - 1 / factor), rtol=1e-6)
        note = data.GetFieldData().GetAbstractArray("Note").GetValue(0)
        self.assertIn("asinh", note)

    def refuse(self, reader, *words, **properties):
        with gt.Messages() as messages:
            proxy = reader(**properties)
            proxy.UpdatePipeline()
        for word in words:
            self.assertIn(word, messages.text)
        self.assertEqual(proxy.GetDataInformation().GetNumberOfPoints(), 0)

    def test_bad_files_are_refused_by_name(self):
        with open(self.path("text.fits"), "w", encoding="ascii") as file:
            file.write("not a FITS file")
        self.refuse(simple.FITSReader, "text.fits", FileName=self.path("text.fits"))
        fits.PrimaryHDU(np.ones((100, 100))).writeto(self.path("whole.fits"))
        with open(self.path("whole.fits"), "rb") as file:
            half = file.read()[:20000]
        with open(self.path("half.fits"), "wb") as file:
            file.write(half)
        self.refuse(simple.FITSReader, "half.fits", FileName=self.path("half.fits"))
        self.refuse(simple.FITSReader, "whole.fits", FileName=self.path("whole.fits"), Plane=7)
        self.refuse(simple.FITSReader, "absent.fits", FileName=self.path("absent.fits"))

    def test_bad_rings_name_the_line(self):
        with open(self.path("bad.rings"), "w", encoding="ascii") as file:
            file.write("# r vrot z0 i pa\n0 100 10 30 200\n50 110 10 oops 200\n")
        path = self.path("bad.rings")
        self.refuse(simple.TiltedRingReader, "bad.rings", "line 3", FileName=path)

    def test_bad_galaxy_names_the_key(self):
        with open(self.path("bad.galaxy"), "w", encoding="ascii") as file:
            file.write("[galaxy]\nra = 1\ndec = 2\ndistanse = 3\n")
        words = ("bad.galaxy", "distanse", "distance")
        self.refuse(simple.GalaxyReader, *words, FileName=self.path("bad.galaxy"))


class Rings(unittest.TestCase):
    def test_m83_rings_are_circles_of_their_radius(self):
        distance = 4.9
        reader = simple.TiltedRingReader(
            FileName=os.path.join(gt.ROOT, "Examples", "M83", "m83.rings"),
            Distance=distance,
            SpinSense="Clockwise",
        )
        data = fetch(reader)
        self.assertEqual(data.GetNumberOfCells(), 15)
        radius = gt.vtk_to_numpy(data.GetCellData().GetArray("Radius"))
        arcsec = [0, 172, 343, 515, 686, 858, 1030, 1200, 1370, 1540, 1720, 1890, 2060, 2230, 5230]
        np.testing.assert_allclose(radius, np.radians(np.array(arcsec) / 3600) * distance * 1e3)
        points = gt.vtk_to_numpy(data.GetPoints().GetData()).reshape(15, -1, 3)
        np.testing.assert_allclose(
            np.linalg.norm(points, axis=2), radius[:, None] * np.ones(points.shape[1]), rtol=1e-5
        )
        # The first point of a ring is its receding end, at the position angle from North to East.
        pa = np.radians(gt.vtk_to_numpy(data.GetCellData().GetArray("PositionAngle")))
        end = points[5, 0] / radius[5]
        np.testing.assert_allclose(end, [-np.sin(pa[5]), np.cos(pa[5]), 0], atol=1e-6)
        # Clockwise: the near side (+Z) lies 90 degrees from the receding end toward the East.
        near = points[5, np.argmax(points[5, :, 2])]
        expected = pa[5] + np.pi / 2
        self.assertGreater(near @ [-np.sin(expected), np.cos(expected), 0], 0)

    def test_a_disk_of_a_tirific_model_with_any_column(self):
        text = """NDISKS= 2
NUR= 3
RADI= 0 60 120
VROT= 0 100 120
INCL= 40 40 50
PA= 350 355 10
Z0= 5
SDIS= 8 9 10
VROT_2= 0 90 110
INCL_2= 60
PA_2= 30
Z0_2= 7
"""
        with tempfile.NamedTemporaryFile("w", suffix=".def") as file:
            file.write(text)
            file.flush()
            first = fetch(simple.TiltedRingReader(FileName=file.name)).GetCellData()
            second = fetch(simple.TiltedRingReader(FileName=file.name, Disk=2)).GetCellData()
        column = lambda cells, name: list(gt.vtk_to_numpy(cells.GetArray(name)))
        self.assertEqual(column(first, "PositionAngle"), [350, 355, 370])
        self.assertEqual(column(first, "ScaleHeight"), [5, 5, 5])
        self.assertEqual(column(second, "RotationVelocity"), [0, 90, 110])
        self.assertEqual(column(second, "Inclination"), [60, 60, 60])
        names = [first.GetArrayName(i) for i in range(first.GetNumberOfArrays())]
        self.assertTrue(any("SDIS" in name or "ispersion" in name for name in names), names)

    def test_a_galaxy_of_a_table_with_several(self):
        text = """# %ECSV 1.0
# ---
# delimiter: ','
# datatype:
# - {name: Name, datatype: string}
# - {name: bbRad, unit: arcsec, datatype: float64}
# - {name: bbVrot, unit: km / s, datatype: float64}
# - {name: bbInc, unit: deg, datatype: float64}
# - {name: bbPA, unit: deg, datatype: float64}
Name,bbRad,bbVrot,bbInc,bbPA
NGC 1,10,100,40,80
NGC 2,5,150,50,30
NGC 2,15,160,51,31
"""
        with tempfile.NamedTemporaryFile("w", suffix=".ecsv") as file:
            file.write(text)
            file.flush()
            cells = fetch(simple.TiltedRingReader(FileName=file.name, GalaxyName="ngc2")).GetCellData()
            with gt.Messages() as messages:
                simple.TiltedRingReader(FileName=file.name).UpdatePipeline()
                simple.TiltedRingReader(FileName=file.name, GalaxyName="NGC 22").UpdatePipeline()
        column = lambda name: list(gt.vtk_to_numpy(cells.GetArray(name)))
        self.assertEqual(column("Radius"), [5, 15])
        self.assertEqual(column("RotationVelocity"), [150, 160])
        self.assertEqual(column("Inclination"), [50, 51])
        self.assertEqual(column("PositionAngle"), [30, 31])
        self.assertIn("holds 2 galaxies, NGC 1, NGC 2", messages.text)
        self.assertIn("did you mean `NGC 2`?", messages.text)

    def test_galaxy_has_rings_and_images_by_name(self):
        reader = simple.GalaxyReader(FileName=gt.M83)
        reader.UpdatePipeline()
        collection = reader.GetClientSideObject().GetOutputDataObject(0)
        names = [
            collection.GetMetaData(i).Get(collection.NAME())
            for i in range(collection.GetNumberOfPartitionedDataSets())
        ]
        self.assertEqual(names[0], "rings")
        self.assertEqual(len(names), 9)
        self.assertEqual(collection.GetPartition(0, 0).GetNumberOfCells(), 15)
        # The images lie about the galaxy's centre, in kpc, East (-X) on the left.
        image = collection.GetPartition(1, 0)
        low, high = np.array(image.GetBounds()).reshape(3, 2).T
        arcmin = np.radians(1 / 60) * 4900
        self.assertLess(np.abs(low + high)[:2].max(), 0.1)
        np.testing.assert_allclose((high - low)[:2], 1024 * 0.95 / 60 * arcmin, rtol=0.01)
        header = fits.getheader(os.path.join(gt.ROOT, "Examples", "M83", "images", "m83_r.fits"))
        self.assertLess(header["CDELT1"] if "CDELT1" in header else header["CD1_1"], 0)
        self.assertGreater(image.GetPoint(1)[0], image.GetPoint(0)[0])  # West to the right


if __name__ == "__main__":
    unittest.main()
