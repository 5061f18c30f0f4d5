"""The cameras that a model gives with its particles, as a script sets them, and on a server."""
import os
import tempfile
import unittest

import numpy as np
from paraview import simple

import galaxy_pictures as gp
import galaxy_testing as gt

try:
    from astropy.io import fits
    from astropy.wcs import WCS
    from astropy.wcs.utils import pixel_to_pixel
except ImportError:
    fits = None

CAMERAS = ("Earth", "FaceOn", "EdgeOn", "MajorAxis")
SIZE = 200

gt.load_plugin()


def build():
    model = simple.GalaxyModel(Input=simple.GalaxyReader(FileName=gt.M83), ParticleScale=0.05)
    model.UpdatePipeline()
    return model


def starlight(model, camera):
    """The light of the stars and the bulge alone, rows from the top."""
    return gp.render(model, camera, SIZE, ("gas", "dust", "young stars")).sum(axis=2)


def spread(picture):
    """The root mean square extent of the light of a picture, across and upward, pixels."""
    y, x = np.mgrid[:SIZE, :SIZE]
    weight = picture / picture.sum()
    return [np.sqrt((weight * (v - (weight * v).sum()) ** 2).sum()) for v in (x, y)]


class Viewpoints(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = build()

    def test_what_the_client_knows_is_what_the_data_hold(self):
        for name in CAMERAS:
            known = gp.field_values(self.model, "Camera" + name)
            np.testing.assert_array_equal(known, gt.array(self.model, "Camera" + name, "field")[0])

    def test_from_earth_the_picture_is_the_sky(self):
        half_size = gp.field_values(self.model, "FieldHalfSize")[0]
        earth = starlight(self.model, gp.viewpoint(self.model, "Earth"))
        sky = starlight(self.model, gp.sky_camera(half_size))
        self.assertLess(np.abs(earth - sky).sum() / sky.sum(), 0.03)
        # A picture half a pixel off, or turned, is not.
        self.assertGreater(np.abs(earth - np.fliplr(sky)).sum() / sky.sum(), 0.2)

    def test_the_disc_is_round_and_flat(self):
        across, upward = spread(starlight(self.model, gp.viewpoint(self.model, "FaceOn")))
        self.assertAlmostEqual(across / upward, 1, delta=0.1)
        across, upward = spread(starlight(self.model, gp.viewpoint(self.model, "EdgeOn")))
        self.assertLess(upward, 0.35 * across)
        across, upward = spread(starlight(self.model, gp.viewpoint(self.model, "MajorAxis")))
        self.assertLess(upward, 0.35 * across)

    def test_a_group_is_whole_from_earth(self):
        group = simple.GalaxyGroup(ParticleScale=0.002, FileName=os.path.join(
            gt.ROOT, "Examples", "M83Group", "m83group.galaxygroup"))
        group.UpdatePipeline()
        camera = gp.viewpoint(group, "Earth")
        p, eye = gt.points_of(group), np.array(camera["CameraPosition"])
        tangent = np.abs(p[:, :2]).max(axis=1) / (eye[2] - p[:, 2])
        edge = np.tan(np.radians(camera["CameraViewAngle"] / 2))
        self.assertAlmostEqual(tangent.max() / edge, 1, delta=1e-6)


WIDTH, HEIGHT, PIXEL = 90, 60, 4.0  # the latter in arcsec
BLOBS = ((20, 15, 3.0), (70, 20, 2.0), (35, 48, 4.0))  # column, row and width, pixels


def turned_image(path):
    """Three blobs, the image's +y 35 degrees from North to East, its reference pixel far from its
    middle and its middle from the galaxy's. Returns the values and the coordinates."""
    wcs = WCS(naxis=2)
    wcs.wcs.ctype = "RA---TAN", "DEC--TAN"
    wcs.wcs.radesys = "ICRS"
    wcs.wcs.crval = 204.27, -29.89
    wcs.wcs.crpix = 15, 70
    c, s = np.cos(np.radians(35)), np.sin(np.radians(35))
    wcs.wcs.cd = PIXEL / 3600 * np.array([[-c, s], [s, c]])
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    values = sum(np.exp(-((x - column) ** 2 + (y - row) ** 2) / (2 * width**2))
                 for column, row, width in BLOBS)
    fits.writeto(path, values.astype(np.float32), wcs.to_header())
    return values, wcs


@unittest.skipUnless(fits, "no astropy here")
class FromEarthAsAnImage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.values, cls.wcs = turned_image(os.path.join(folder.name, "turned.fits"))
        path = os.path.join(folder.name, "blobs.galaxy")
        with open(path, "w", encoding="utf-8") as file:
            file.write("""
                [galaxy]
                ra = 204.25383
                dec = -29.86576
                distance = 4.9
                radius = 12
                [image."wide field"]
                file = "turned.fits"
                [[component]]
                name = "stars"
                particles = 200000
                layers = [{ image = "wide field", clip = [0, 1] }]
                """)
        model = simple.GalaxyModel(Input=simple.GalaxyReader(FileName=path))
        picture = simple.SplatImage(Input=model, ImageSize=[WIDTH, HEIGHT],
                                    **gp.viewpoint(model, "Earth:wide field"))
        cls.light = gt.array(picture, "Radiance").reshape(HEIGHT, WIDTH, 3).sum(axis=2)
        cls.saved = os.path.join(folder.name, "picture.fits")
        simple.SaveData(cls.saved, proxy=picture)

    def test_its_coordinates_are_the_images(self):
        with fits.open(self.saved) as file:
            wcs = WCS(file["RADIANCE"].header).celestial
        x, y = (v.ravel() for v in np.meshgrid([0, WIDTH / 3, WIDTH - 1], [0, HEIGHT - 1]))
        np.testing.assert_allclose(pixel_to_pixel(self.wcs, wcs, x, y), (x, y), atol=1e-3)

    def test_its_light_is_where_the_images_is(self):
        self.assertGreater(np.corrcoef(self.light.ravel(), self.values.ravel())[0, 1], 0.999)
        y, x = np.mgrid[:HEIGHT, :WIDTH]
        for column, row, width in BLOBS:
            near = np.hypot(x - column, y - row) < 3 * width
            for v, place in ((x, column), (y, row)):
                self.assertAlmostEqual(np.average(v[near], weights=self.light[near]), place, delta=0.01)


class ViewpointsOnAServer(unittest.TestCase):
    def test_cameras_reach_the_client(self):
        known = [gp.field_values(build(), "Camera" + name) for name in CAMERAS]
        with gt.server():
            remote = build()
            self.assertIsNone(remote.GetClientSideObject())
            for name, values in zip(CAMERAS, known):
                self.assertEqual(gp.field_values(remote, "Camera" + name), values)


if __name__ == "__main__":
    unittest.main(verbosity=2)
