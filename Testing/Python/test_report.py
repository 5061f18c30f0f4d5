"""What GalaxyModel reports of itself."""
import json
import unittest

import numpy as np
from astropy.io import fits
from paraview import simple

import galaxy_testing as gt

gt.load_plugin()

PIXEL, SIZE, LENGTH = 0.05, 301, 1.0  # kpc, pixels, kpc
GALAXY = """
[galaxy]
name = "made"
ra = 10
dec = 20
distance = 5
radius = 30
[image.r]
file = "report.fits"
background = "Auto"
[image.wide]
file = "wide.fits"
[image.both]
combine = ["r", "wide"]
"""


def component(name, **keys):
    lines = "".join(f"{key} = {value}\n" for key, value in keys.items())
    return (f"[[component]]\nname = {name}\nparticles = 20000\n{lines}"
            "[component.thickness]\nsigma = 0\n")


def in_toml(text):
    """As TOML writes a text, in quotes and with what is no print escaped."""
    shown = "".join(c if c.isprintable() and c not in '"\\' else f"\\U{ord(c):08x}" for c in text)
    return f'"{shown}"'


def write_image(name, values, pixel):
    header = fits.Header()
    degrees = np.degrees(pixel / 5000)
    middle = (np.array(values.shape) + 1) / 2
    header.update(CTYPE1="RA---TAN", CTYPE2="DEC--TAN", CRVAL1=10.0, CRVAL2=20.0, CRPIX1=middle[1],
                  CRPIX2=middle[0], CDELT1=-degrees, CDELT2=degrees, BMAJ=2 * degrees,
                  BMIN=2 * degrees, BPA=0.0)
    fits.PrimaryHDU(values.astype(np.float32), header).writeto(gt.written(name, ""), overwrite=True)


def report_of(components, seed=1):
    reader = simple.GalaxyReader(FileName=gt.written("report.galaxy", GALAXY + components))
    model = simple.GalaxyModel(Input=reader, RandomSeed=seed)
    model.UpdatePipeline()
    model.UpdatePropertyInformation()
    report = json.loads(str(model.ReportJSON))
    words = str(model.Report)
    simple.Delete(model)
    simple.Delete(reader)
    return report, words


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        y, x = np.mgrid[:SIZE, :SIZE] - (SIZE - 1) / 2
        cls.light = 1000 * np.exp(-np.hypot(x, y) * PIXEL / LENGTH)
        noise = np.random.default_rng(3).normal(40, 2, cls.light.shape)
        write_image("report.fits", cls.light + noise, PIXEL)
        write_image("wide.fits", cls.light[::2, ::2], 2 * PIXEL)

    def test_the_share_on_the_disc_is_of_all_the_images_light(self):
        radii = [0.02, 0.31, 1.01, 3.01, 5.01]  # no pixel's middle lies on an edge
        layers = "[{ image = 'r', clip = [0, 1100], threshold = 0.006 }]"
        report, words = report_of("".join(
            component(f"'within {radius}'", outer_radius=radius, layers=layers) for radius in radii))
        shown = np.where(self.light > 6.6, self.light, 0) / 1100
        y, x = np.mgrid[:SIZE, :SIZE] - (SIZE - 1) / 2
        for radius, found in zip(radii, report):
            self.assertAlmostEqual(found["flux"] / (shown.sum() * PIXEL**2), 1, delta=0.01)
            expected = shown[np.hypot(x, y) * PIXEL < radius].sum() / shown.sum()
            share = found["light"] / found["flux"]
            self.assertAlmostEqual(share, expected, delta=0.02 * expected + 2e-4, msg=str(radius))
            self.assertIn(f"{100 * share:.1f} % of its images' light", words)
        self.assertLess(report[0]["light"] / report[0]["flux"], 1e-3)

    def test_of_every_image_background_scatter_and_clip(self):
        report, words = report_of(
            component("'one'", layers="[{ image = 'r', clip = [0, 500] }, { image = 'wide' }]")
            + component("'two'", layers="[{ image = 'both', clip_percentile = [50, 99] }]"))
        r, wide = report[0]["images"]
        self.assertEqual((r["image"], wide["image"]), ("r", "wide"))
        self.assertAlmostEqual(r["background"], 40, delta=0.5)
        self.assertAlmostEqual(r["scatter"], 2, delta=0.1)
        self.assertEqual(r["clip"], [0, 500])
        self.assertEqual(wide["background"], 0)
        lit = self.light[::2, ::2]
        np.testing.assert_allclose(wide["clip"], [0, np.percentile(lit, 99.9)], rtol=1e-5)
        names = [image["image"] for image in report[1]["images"]]
        self.assertEqual(names, ["r", "wide", "both"])
        self.assertAlmostEqual(report[1]["images"][0]["background"], 40, delta=0.5)
        self.assertIsNone(report[1]["images"][0]["clip"])
        self.assertGreater(report[1]["images"][2]["clip"][1], report[1]["images"][2]["clip"][0])
        self.assertIn("image r: background ", words)
        self.assertIn(", clip 0 to 500 over the background", words)

    def test_a_spheroid_says_what_it_took_and_where_it_ends(self):
        stars = component("'stars'", layers="[{ image = 'r', clip = [0, 1100], threshold = 0.006 }]")
        bulge = ("[[component]]\nname = 'bulge'\ntype = 'Spheroid'\nparticles = 20000\n"
                 "[component.spheroid]\nsigma = [{0}, {0}, {0}]\nlight_from = 'stars'\n"
                 "light_fraction = {1}\n")
        with gt.Messages() as messages:
            report, words = report_of(stars + bulge.format(1, 0.15))
        self.assertEqual(messages.text, "")
        whole = report[0]["light"] + report[1]["light"]
        self.assertAlmostEqual(report[1]["light"] / whole, 0.15, delta=0.001)
        self.assertEqual(report[1]["end"], 5)
        self.assertIn("ends at 5.0", words)
        with gt.Messages() as messages:
            report, words = report_of(stars + bulge.format(0.01, 0.9))
        self.assertLess(report[1]["light"], 0.5 * report[1]["light_asked"])
        self.assertIn("light_fraction", messages.text)
        self.assertIn("bulge", messages.text)
        self.assertIn(" % of the light that it is to take", words)

    def test_it_is_json_whatever_the_names(self):
        names = ['quo"te', "back\\slash", "\\u0041", "tab\tline\nfeed\x01\x1f\x7f\x9b",
                 "é✓\U0001f30c\ufffe", "</a>&", "{}[],:'", "null\0 and more"]
        report, words = report_of("".join(
            component(in_toml(name), profile='"Exponential"', outer_radius=9) for name in names))
        self.assertEqual([entry["component"] for entry in report], names)
        self.assertIn("and more: 20000 particles", words)

    def test_a_negative_seed_is_refused_everywhere(self):
        galaxy = simple.GalaxyReader(FileName=gt.written(
            "seeds.galaxy", GALAXY.split("[image")[0] + component("'a'", profile='"Exponential"')))
        group = gt.written("seeds.galaxygroup", "[group]\n[[member]]\ngalaxy = 'seeds.galaxy'\n")
        seeds = simple.DiskSeeds(Input=galaxy)
        for proxy in (seeds, simple.GalaxyModel(Input=galaxy), simple.DiskThickness(Input=seeds),
                      simple.DustFilaments(Input=seeds), simple.Spheroid(),
                      simple.GalaxyGroup(FileName=group)):
            label = proxy.GetXMLName()
            for seed in (-1, -(2**31)):
                proxy.RandomSeed = seed
                with gt.Messages() as messages:
                    proxy.UpdatePipeline()
                self.assertIn("RandomSeed: must be at least 0", messages.text, label)
                self.assertEqual(gt.count_of(proxy), 0, label)
            proxy.RandomSeed = 2**31 - 1
            proxy.UpdatePipeline()
            self.assertGreater(gt.count_of(proxy), 0, label)
            domain = proxy.GetProperty("RandomSeed").FindDomain("vtkSMIntRangeDomain")
            self.assertEqual((domain.GetMinimumExists(0), domain.GetMinimum(0)), (1, 0), label)


if __name__ == "__main__":
    unittest.main(verbosity=2)
