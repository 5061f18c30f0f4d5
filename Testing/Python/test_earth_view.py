"""The light seen from Earth, pixel by pixel, judged by astropy's world coordinates and numpy alone.

Every particle is put on its image's pixel, and the light of each pixel must be the image's. Real
images lie in GALAXY_REAL_DATA, or shared/data beside the checkout; where they are absent, what
needs them is skipped, saying so.
"""
import json
import os
import sys
import tempfile
import unittest
import warnings

import numpy as np
from paraview import servermanager, simple

import galaxy_testing as gt

try:
    from astropy.io import fits
    from astropy.utils.exceptions import AstropyWarning
    from astropy.wcs import WCS
    from astropy.wcs.utils import pixel_to_pixel
except ImportError:
    gt.skip("no astropy here")

gt.load_plugin()
warnings.simplefilter("ignore", AstropyWarning)

MOCK = os.path.join(gt.ROOT, "Examples", "M83", "images")
DATA = os.environ.get("GALAXY_REAL_DATA", os.path.join(gt.ROOT, "..", "shared", "data"))
# The model follows its coordinates by a table that is right to 0.001 pixel: which of two pixels a
# particle so close to their common edge is on, only the model can know.
EDGE = 0.003
M83 = {"ra": 204.25383, "dec": -29.86576, "distance": 4.9, "spin": "Clockwise",
       "rings": os.path.join(gt.ROOT, "Examples", "M83", "m83.rings")}
THICK = """[component.thickness]
model = "Tapered"
law = "Sech2"
children = 3
sigma = 0.03
scale_height = 0.25
"""
TIGHT = 1e-6  # the model's fluxes and intensities are single precision numbers


def real(*path):
    """A file of the real data; without it the test is skipped."""
    path = os.path.join(DATA, *path)
    if not os.path.exists(path):
        raise unittest.SkipTest(f"no {path}")
    return path


def tangent_plane(ra, dec, mpc):
    """Coordinates whose pixels, from 0, are X (West) and Y (North) in kpc about a galaxy."""
    plane = WCS(naxis=2)
    plane.wcs.ctype = "RA---TAN", "DEC--TAN"
    plane.wcs.radesys = "ICRS"
    plane.wcs.crval = ra, dec
    plane.wcs.crpix = 1, 1
    kpc = np.degrees(1 / (1000 * mpc))
    plane.wcs.cdelt = -kpc, kpc
    return plane


class Scene:
    """A galaxy of one image and one component, its model, and what astropy makes of them."""

    def __init__(self, image, galaxy, clip, component="", image_keys="", wcs=None,
                 normalize_at="Child", scale=1, **properties):
        with fits.open(image) as file:
            values = np.squeeze(file[0].data).astype(np.float64)
            self.header = file[0].header
        self.wcs = wcs or WCS(self.header, naxis=2)
        self.distance = galaxy["distance"]
        self.plane = tangent_plane(galaxy["ra"], galaxy["dec"], self.distance)
        self.shape = values.shape
        low, high = clip
        intensity = np.clip((values - low) / (high - low), 0, 1)
        self.centres = self.on_plane(*np.indices(self.shape)[::-1])
        self.areas = self.pixel_areas()
        self.flux = np.nan_to_num(intensity) * self.areas
        lines = [f"{key} = {json.dumps(value)}" for key, value in galaxy.items()]
        self.text = "\n".join([
            "[galaxy]", *lines, "[image.i]", f"file = {json.dumps(image)}", image_keys,
            "[[component]]", "name = 'all'", f"normalize_at = '{normalize_at}'",
            f"layers = [{{ image = 'i', clip = [{float(low)}, {float(high)}] }}]", component])
        self.build(scale, properties)

    def on_plane(self, column, row):
        """(X, Y) kpc of pixel coordinates from 0."""
        return pixel_to_pixel(self.wcs, self.plane, np.asarray(column), np.asarray(row))

    def pixel_areas(self):
        """kpc^2, of the quadrangles that the pixels are on the tangent plane."""
        rows, columns = self.shape
        v, u = np.indices((rows + 1, columns + 1)) - 0.5
        x, y = self.on_plane(u, v)
        across = [a[1:, 1:] - a[:-1, :-1] for a in (x, y)]
        along = [a[1:, :-1] - a[:-1, 1:] for a in (x, y)]
        return 0.5 * np.abs(across[0] * along[1] - across[1] * along[0])

    def build(self, scale, properties):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.galaxy")
            with open(path, "w", encoding="utf-8") as file:
                file.write(self.text)
            reader = simple.GalaxyReader(FileName=path)
            model = simple.GalaxyModel(Input=reader, ParticleScale=scale, **properties)
            model.UpdatePipeline()
            model.UpdatePropertyInformation()
            self.report, = json.loads(str(model.ReportJSON))
            data = servermanager.Fetch(model)
        self.points = gt.vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        arrays = data.GetPointData()
        self.light = gt.vtk_to_numpy(arrays.GetArray("Intensity")).astype(float)
        # As a pinhole camera at the Earth sees them in the plane of the sky through the centre.
        distance = 1000 * self.distance
        larger = distance / (distance - self.points[:, 2])
        self.points[:, :2] *= larger[:, None]
        self.light *= larger**2
        velocity = arrays.GetArray("Velocity")
        self.velocity = gt.vtk_to_numpy(velocity).astype(float) if velocity else None
        simple.Delete(model)
        simple.Delete(reader)
        self.column, self.row = pixel_to_pixel(self.plane, self.wcs, *self.points[:, :2].T)

    def summed(self, weights, chosen=slice(None), at_u=0, at_v=0):
        """Weights of the chosen particles by pixel, each moved by (at_u, at_v) pixels."""
        column = np.rint(self.column[chosen] + at_u).astype(int)
        row = np.rint(self.row[chosen] + at_v).astype(int)
        inside = (column >= 0) & (row >= 0) & (column < self.shape[1]) & (row < self.shape[0])
        flat = np.bincount((row * self.shape[1] + column)[inside], weights[chosen][inside],
                           minlength=self.flux.size)
        return flat.reshape(self.shape)

    def nearest_edge(self):
        """By particle: pixels to the nearest edge of its pixel."""
        return 0.5 - np.maximum(*(np.abs(a - np.rint(a)) for a in (self.column, self.row)))

    def across_edges(self, close):
        """Which pixels have one of the `close` particles on an edge of theirs, on either side; and
        no less than the light of those."""
        touched, light = np.zeros(self.shape), np.zeros(self.shape)
        for at_u in (-EDGE, EDGE):
            for at_v in (-EDGE, EDGE):
                touched += self.summed(np.ones(len(close)), close, at_u, at_v)
                light += self.summed(self.light, close, at_u, at_v)
        return touched > 0, light

    def within(self, half):
        """The pixels whose centres are in the box |X|, |Y| < half."""
        return (np.abs(self.centres[0]) < half) & (np.abs(self.centres[1]) < half)

    def in_ellipse(self, radius, inclination, position_angle):
        """The pixels whose centres are within this ring."""
        X, Y = self.centres
        angle = np.radians(position_angle)
        u = -X * np.sin(angle) + Y * np.cos(angle)
        w = X * np.cos(angle) + Y * np.sin(angle)
        return np.hypot(u, w / np.cos(np.radians(inclination))) < radius


class EarthView(unittest.TestCase):
    def judge(self, name, scene, disc, half):
        """Every pixel with particles has its own light, and every lit one of `disc` has particles.
        `half`: half the side of the box in which the model looks at the image, kpc."""
        self.assertEqual(scene.report["bins"], 1, "too few particles to judge pixels")
        self.assertEqual(scene.report["particles"], len(scene.light))
        close = scene.nearest_edge() < EDGE
        light = scene.summed(scene.light)
        clear = scene.summed(np.ones(len(close)), ~close) > 0
        disputed, around = scene.across_edges(close)
        pixel = np.sqrt(scene.areas.max())
        inside = scene.within(half - pixel)
        self.assertEqual(light[~scene.within(half + pixel)].max(initial=0), 0)
        lit = inside & (scene.flux > 0)
        disputed &= inside

        judged = clear & lit & ~disputed
        worst = np.abs(light[judged] / scene.flux[judged] - 1).max()
        share = np.count_nonzero(judged & disc) / np.count_nonzero(lit & disc)
        print(f"{name}: {len(scene.light)} particles, {scene.report['filled']} of them fill; "
              f"{np.count_nonzero(judged)} pixels judged, {100 * share:.1f} % of the disc's, "
              f"the worst is off by {worst:.1e}; ", end="")
        self.assertFalse(np.any(lit & disc & ~clear & ~disputed), "a lit pixel without particles")
        self.assertLess(worst, TIGHT)
        self.assertGreater(share, 0.7)
        dark = inside & ~lit & ~disputed
        self.assertEqual(light[dark].max(initial=0), 0, "light on a dark pixel")

        # The disputed: with none of the particles on their edges too little, with all too much.
        without = scene.summed(scene.light, ~close)[disputed]
        self.assertTrue(np.all(without <= scene.flux[disputed] * (1 + TIGHT)))
        have = (clear | disc)[disputed]
        enough = without + around[disputed] >= scene.flux[disputed] * (1 - TIGHT)
        self.assertTrue(np.all(enough[have]))

        # As a whole. Off the disc a pixel counts if a particle happens to be seen on it.
        total = scene.light.sum()
        self.assertAlmostEqual(total / scene.report["light"], 1, delta=1e-7)
        sure = inside & (clear | disc)
        covered = scene.flux[sure].sum()
        seen = clear | disc | disputed
        doubtful = scene.flux[~sure & seen & scene.within(half + pixel)].sum()
        self.assertGreater(total, covered * (1 - TIGHT))
        self.assertLess(total, (covered + doubtful) * (1 + TIGHT))
        whole = scene.flux.sum()
        print(f"light {total:.6g}, the image's {covered:.6g} to {covered + doubtful:.6g}; "
              f"flux {scene.report['flux']:.6g}, the image's {whole:.6g} kpc^2")
        self.assertAlmostEqual(scene.report["flux"] / whole, 1, delta=TIGHT)

    def judge_m83(self, name, image, clip, outer, half, wcs=None, image_keys=""):
        if outer:
            rings = np.loadtxt(M83["rings"])
            arcsec = np.degrees(outer / 4900) * 3600
            inclination, angle = (np.interp(arcsec, rings[:, 0], rings[:, k]) for k in (3, 4))
        scene = Scene(image, M83, clip, image_keys=image_keys, wcs=wcs,
                      component="particles = 400000\n"
                      + (f"outer_radius = {outer}\n" if outer else "") + THICK)
        disc = scene.in_ellipse(outer, inclination, angle) if outer else scene.flux >= 0
        self.judge(name, scene, disc, half)
        return scene

    def test_mock_m83_r(self):
        self.judge_m83("M83 r", os.path.join(MOCK, "m83_r.fits"), (0, 3.5), 5.0, 5.0)

    def test_mock_m83_hydrogen_lies_on_the_disc_as_a_whole(self):
        image = os.path.join(MOCK, "m83_hi_high.fits")
        top = float(fits.getdata(image).max())
        scene = self.judge_m83("M83 H I", image, (0, top), None, 125.0)
        self.assertAlmostEqual(scene.report["light"] / scene.report["flux"], 1, delta=TIGHT)
        self.assertAlmostEqual(scene.light.sum() / scene.flux.sum(), 1, delta=1e-5)

    def test_m83_plate_with_given_coordinates(self):
        image = real("M83", "m83_dss1_J_671.fits")
        scale, angle = 1.6995, -1.127
        keys = (f"ra = 204.253134\ndec = -29.866267\npixel_scale = {scale}\n"
                f"position_angle = {angle}\nreference_pixel = [336, 336]")
        wcs = WCS(naxis=2)
        wcs.wcs.ctype = "RA---TAN", "DEC--TAN"
        wcs.wcs.radesys = "ICRS"
        wcs.wcs.crval = 204.253134, -29.866267
        wcs.wcs.crpix = 336, 336
        c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
        wcs.wcs.cd = scale / 3600 * np.array([[-c, s], [s, c]])
        self.judge_m83("M83 plate", image, (2500, 13200), 6.0, 6.0, wcs, keys)

    def test_m51_flat_disc(self):
        image = real("M51", "SDSS9_M51_r.fits")
        galaxy = {"ra": 202.4696, "dec": 47.1952, "distance": 8.58, "inclination": 45.0,
                  "position_angle": 173.0, "radius": 14.0}
        scene = Scene(image, galaxy, (0.02, 3.6), component="particles = 300000\n" + THICK)
        disc = scene.in_ellipse(14.0, 45.0, 173.0)
        self.judge("M51 r", scene, disc, 14.0)
        off = 1 - scene.report["light"] / scene.report["flux"]
        outside = 1 - scene.flux[disc].sum() / scene.flux.sum()
        print(f"M51 r off the disc: {off:.4f}, of the image's light {outside:.4f}")
        self.assertLess(off, outside)  # the disc's thickness is seen beyond its edge
        self.assertAlmostEqual(off, outside, delta=0.03)

    def test_ngc_2903_hydrogen_and_its_velocities(self):
        image, table = (real("NGC2903", f"NGC_2903{n}") for n in ("_HI_mom0.fits", ".def"))
        galaxy = {"ra": 143.0421, "dec": 21.5008, "distance": 8.9, "rings": table}
        outer = 30.0
        scene = Scene(image, galaxy, (0, 6000), Velocities=1, component=f"""
            particles = 8000
            outer_radius = {outer}
            velocity_dispersion = 10
            """ + THICK)
        disc = scene.in_ellipse(outer, 65.637, 209.31)
        self.judge("NGC 2903 H I", scene, disc, outer)
        measured = np.squeeze(fits.getdata(real("NGC2903", "NGC_2903_HI_mom1.fits"))) / 1000.0
        light = scene.summed(scene.light)
        systemic = 554.848
        sight = systemic - scene.velocity[:, 2]
        with np.errstate(invalid="ignore", divide="ignore"):
            model = scene.summed(scene.light * sight) / light
        seen = (light > 0) & np.isfinite(measured) & (scene.flux > 0.02 * scene.flux.max())
        correlation = np.corrcoef(model[seen], measured[seen])[0, 1]
        slope = np.polyfit(model[seen], measured[seen], 1)[0]
        print(f"NGC 2903 velocities: {np.count_nonzero(seen)} pixels, correlation "
              f"{correlation:.4f}, slope {slope:.3f}, rms "
              f"{np.std(model[seen] - measured[seen]):.1f} km/s")
        self.assertGreater(correlation, 0.9)

    def test_other_normalisations_leave_residuals(self):
        image = os.path.join(MOCK, "m83_r.fits")
        keys = "particles = 150000\nouter_radius = 3.0\n" + THICK
        scatter = {}
        for rule in ("Child", "Seed", "None"):
            scene = Scene(image, M83, (0, 3.5), keys, normalize_at=rule)
            light = scene.summed(scene.light)
            disputed, _ = scene.across_edges(scene.nearest_edge() < EDGE)
            judged = (scene.flux > 0) & scene.in_ellipse(2.5, 23.7, 227) & ~disputed
            scatter[rule] = np.std(light[judged] / scene.flux[judged])
            whole = scene.light.sum() / scene.flux[scene.in_ellipse(3.0, 23.7, 227)].sum()
            print(f"normalize_at {rule}: scatter of the pixels {scatter[rule]:.1e}, "
                  f"the disc's light times {whole:.4f}")
            if rule != "Child":  # which also lights what the thickness shows beyond the edge
                self.assertAlmostEqual(whole, 1, delta=0.005)
        self.assertLess(scatter["Child"], TIGHT)
        self.assertGreater(scatter["Seed"], 0.05)
        self.assertGreater(scatter["None"], 0.05)


if __name__ == "__main__":
    unittest.main(verbosity=2)  # which says what is skipped, and why
