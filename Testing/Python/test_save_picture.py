"""Pictures in linear light on disk: FITS against astropy, OpenEXR against ffmpeg's own decoder."""
import os
import shutil
import subprocess
import unittest

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkStringArray

import galaxy_testing as gt

try:
    import astropy.units as u
    from astropy.coordinates import SkyCoord
    from astropy.io import fits
    from astropy.wcs import WCS
except ImportError:
    gt.skip("astropy is not installed")

gt.load_plugin()
CENTRE = SkyCoord(204.25383, -29.86576, unit="deg")
DISTANCE = 4900.0  # kpc
WIDTH, HEIGHT = 96, 64
KPC = 0.25  # a pixel at the galaxy's distance
HALF = 0.5 * KPC * HEIGHT
ANGLE = 2 * np.degrees(np.arctan(HALF / DISTANCE))
EARTH = {"CameraPosition": [0, 0, DISTANCE], "CameraViewAngle": ANGLE}
AFAR = {"CameraPosition": [0, 0, 50], "CameraParallelProjection": 1, "CameraParallelScale": HALF}
ROLLS = ([0, 1, 0], [1, 0, 0], [-0.6, 0.8, 0], [0.3, -0.9, 0])


def sky_of(place):
    """Where Earth sees a place of the frame (X West, Y North, Z to Earth), by astropy."""
    x, y, z = place
    seen = SkyCoord(x=DISTANCE - z, y=-x, z=y, unit="kpc", representation_type="cartesian",
                    frame=CENTRE.skyoffset_frame())
    return seen.transform_to("icrs")


def on_sky(source):
    """Says where the particles of a producer stand on the sky."""
    fields = source.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
    name = vtkStringArray()
    name.SetName("GalaxyName")
    name.InsertNextValue("M83")
    fields.AddArray(name)
    for title, values in (("SkyCentre", (CENTRE.ra.deg, CENTRE.dec.deg)),
                          ("SkyDistance", (DISTANCE,))):
        array = vtkDoubleArray()
        array.SetName(title)
        array.SetNumberOfComponents(len(values))
        array.InsertNextTuple(values)
        fields.AddArray(array)
    return source


def one_particle(place):
    return on_sky(gt.particles([place], [1.3], Emission=np.array([[1, 2, 4]], np.float32)))


def picture_of(source, **camera):
    return simple.SplatImage(Input=source, ImageSize=[WIDTH, HEIGHT], Accuracy="Sorted", **camera)


def channels(picture, name):
    """Rows from the bottom up."""
    values = servermanager.Fetch(picture).GetPointData().GetArray(name)
    return vtk_to_numpy(values).reshape(HEIGHT, WIDTH, 3)


def centroid(image):
    """Column and row, the first pixel's centre being 0."""
    weights = image.sum(dtype=float)
    rows, columns = np.indices(image.shape)
    return (columns * image).sum() / weights, (rows * image).sum() / weights


class SavePicture(gt.FolderTest):
    def saved(self, picture, name="picture.fits"):
        simple.SaveData(self.path(name), proxy=picture)
        return fits.open(self.path(name))

    def assert_seen_where_the_sky_is(self, place, camera):
        with self.saved(picture_of(one_particle(place), **camera)) as file:
            coordinates = WCS(file["RADIANCE"].header).celestial
            expected = coordinates.world_to_pixel(sky_of(place))
            found = centroid(file["RADIANCE"].data[1])
        np.testing.assert_allclose(found, expected, atol=0.01)

    def test_every_value_and_the_camera_are_in_fits(self):
        picture = picture_of(one_particle([1, 2, 3]), **EARTH)
        with self.saved(picture) as file:
            self.assertEqual([hdu.name for hdu in file], ["PRIMARY", "RADIANCE", "TRANSMITTANCE"])
            for name in ("Radiance", "Transmittance"):
                hdu = file[name.upper()]
                self.assertEqual(hdu.data.dtype.newbyteorder("="), np.float32)
                np.testing.assert_array_equal(np.moveaxis(hdu.data, 0, 2), channels(picture, name))
            header = file["RADIANCE"].header
            self.assertEqual(u.Unit(header["BUNIT"]), u.kpc**-2)
            self.assertEqual(header["OBJECT"], "M83")
            self.assertEqual(header["CAMPROJ"], "Perspective")
            self.assertEqual([header["CAMPOS" + c] for c in "XYZ"], [0, 0, DISTANCE])
            self.assertAlmostEqual(header["CAMANGLE"], ANGLE, places=12)
            file.verify("exception")

    def test_a_particle_is_where_its_coordinates_are(self):
        for up in ROLLS:
            for place in ([3, -2, 0], [-6, 4, 5], [2, 5, -8]):
                view = dict(EARTH, CameraViewUp=up)
                self.assert_seen_where_the_sky_is(place, view)
            view = dict(AFAR, CameraViewUp=up, CameraFocalPoint=[2, 1, 0])
            view["CameraPosition"] = [2, 1, 50]
            self.assert_seen_where_the_sky_is([3, -2, 0], view)

    def test_earth_may_look_beside_the_galaxy(self):
        # 500 kpc off: there the plane of the sky is another one.
        place = np.array([500.0, -300, 100])
        view = dict(EARTH, CameraFocalPoint=list(place + [2, 1, 0]), CameraViewUp=[0.2, 1, 0])
        self.assert_seen_where_the_sky_is(list(place), view)

    def test_other_views_have_no_place_on_the_sky(self):
        for camera in (
            dict(EARTH, CameraPosition=[0, 0, DISTANCE - 1]),
            dict(EARTH, CameraPosition=[0.01, 0, DISTANCE]),
            dict(EARTH, CameraPosition=[0, 0, -DISTANCE]),
            dict(AFAR, CameraPosition=[0, 0.1, 50]),
            dict(AFAR, CameraPosition=[0, 0, -50]),
        ):
            with self.saved(picture_of(one_particle([0, 0, 0]), **camera)) as file:
                self.assertNotIn("CTYPE1", file["RADIANCE"].header)
                self.assertIn("CAMPOSX", file["RADIANCE"].header)

    def test_a_models_picture_knows_its_sky(self):
        model = simple.GalaxyModel(
            Input=simple.GalaxyReader(FileName=gt.M83), ParticleScale=0.002)
        with self.saved(picture_of(model, **AFAR)) as file:
            header = file["RADIANCE"].header
            self.assertEqual(header["DISTANCE"], 4900)
            place = WCS(header).celestial.pixel_to_world(0.5 * WIDTH - 0.5, 0.5 * HEIGHT - 0.5)
        self.assertLess(place.separation(CENTRE).arcsec, 1e-3)

    def test_the_plugins_own_reader_reads_it(self):
        picture = picture_of(one_particle([0, 0, 0]), **AFAR)
        simple.SaveData(self.path("picture.fits"), proxy=picture)
        values = gt.array(simple.FITSReader(FileName=self.path("picture.fits"), Plane=2), "Intensity")
        expected = channels(picture, "Radiance")[:, :, 2].ravel()
        np.testing.assert_array_equal(values, expected)

    def exr(self, name, layer=""):
        """Red, green and blue of a layer, rows from the top, as ffmpeg decodes them."""
        if not shutil.which("ffmpeg"):
            self.skipTest("ffmpeg is not installed")
        raw = subprocess.run(
            ["ffmpeg", "-v", "error", "-layer", layer, "-i", self.path(name), "-f", "rawvideo",
             "-pix_fmt", "gbrpf32le", "-"], capture_output=True, check=True).stdout
        planes = np.frombuffer(raw, "<f4").reshape(3, HEIGHT, WIDTH)
        return np.stack([planes[2], planes[0], planes[1]], axis=2)

    def absorbing(self):
        return gt.particles(
            [[1, 2, 0], [2, 2, -3]], [3, 5], Emission=np.array([[1, 2, 4], [9, 9, 9]], np.float32),
            Absorption=np.array([[3, 4, 5], [0, 0, 0]], np.float32))

    def test_openexr_has_every_value(self):
        picture = picture_of(self.absorbing(), **AFAR)
        simple.SaveData(self.path("picture.exr"), proxy=picture)
        for name, layer in (("Radiance", ""), ("Transmittance", "transmittance")):
            expected = channels(picture, name)[::-1]
            np.testing.assert_array_equal(self.exr("picture.exr", layer), expected)
        self.assertLess(channels(picture, "Transmittance").min(), 0.9)

    def test_openexr_of_half_precision(self):
        picture = picture_of(self.absorbing(), **AFAR)
        simple.SaveData(self.path("picture.exr"), proxy=picture, PixelType="Half")
        expected = channels(picture, "Radiance")[::-1].astype(np.float16)
        np.testing.assert_array_equal(self.exr("picture.exr"), expected.astype(np.float32))

    def test_openexrs_own_tool_lists_the_channels(self):
        if not shutil.which("exrheader"):
            self.skipTest("exrheader is not installed")
        picture = picture_of(self.absorbing(), **AFAR)
        simple.SaveData(self.path("picture.exr"), proxy=picture)
        header = subprocess.run(["exrheader", self.path("picture.exr")], capture_output=True,
                                text=True, check=True).stdout
        for name in ("R", "transmittance.B"):
            self.assertIn(f"{name}, 32-bit floating-point", header)
        self.assertIn("cameraPosition", header)

    def test_paraviews_own_format_keeps_all(self):
        picture = picture_of(one_particle([1, 2, 3]), **EARTH)
        simple.SaveData(self.path("picture.vti"), proxy=picture)
        again = simple.XMLImageDataReader(FileName=[self.path("picture.vti")])
        for name in ("Radiance", "Transmittance"):
            np.testing.assert_array_equal(channels(again, name), channels(picture, name))
        with self.saved(again, "again.fits") as file:  # also where it was seen from
            self.assertEqual(file["RADIANCE"].header["CTYPE1"], "RA---TAN")

    def test_the_windows_save_data_offers_it_for_pictures_alone(self):
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
        star = one_particle([0, 0, 0])
        picture = picture_of(star, **AFAR)
        for source, offered in ((picture, True), (star, False)):
            source.UpdatePipeline()
            types = factory.GetSupportedFileTypes(source.SMProxy, 0)
            self.assertEqual("*.fits" in types and "*.exr" in types, offered, types)

    def refused(self, picture, name, cause, **properties):
        before = sorted(os.listdir(self.folder))
        with gt.Messages() as messages:
            simple.SaveData(self.path(name), proxy=picture, **properties)
        self.assertIn(cause, messages.text)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_what_cannot_be_written_is_said(self):
        picture = picture_of(self.absorbing(), **AFAR)
        for extension in ("fits", "exr"):
            self.refused(picture, "none/a." + extension, "No such file or directory")
            os.makedirs(self.path("folder." + extension))
            self.refused(picture, "folder." + extension, "is a folder")
            self.refused(simple.Wavelet(), "a." + extension, "must be one slice deep")
            self.refused(simple.Wavelet(WholeExtent=[0, 9, 0, 9, 0, 0]), "a." + extension,
                         "must have a point array Radiance")
        bright = gt.particles([[0, 0, 0]], [1], Emission=np.full((1, 3), 1e6, np.float32))
        self.refused(picture_of(bright, **AFAR), "a.exr", "beyond half precision", PixelType="Half")

    def test_a_writer_that_is_stopped_leaves_nothing(self):
        picture = picture_of(self.absorbing(), **AFAR)
        for name in ("a.fits", "a.exr"):
            writer = simple.SplatImageWriter(Input=picture, FileName=self.path(name))
            algorithm = writer.GetClientSideObject()
            algorithm.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
            with gt.Messages() as messages:
                writer.UpdatePipeline()
            self.assertIn(f"{name}: not written, for the writer was stopped", messages.text)
            self.assertEqual(os.listdir(self.folder), [])


if __name__ == "__main__":
    unittest.main()
