"""The model's filters and sources by themselves: their properties, and what they refuse."""
import json
import os
import tempfile
import unittest

import numpy as np
from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import vtkPolyData

import galaxy_testing as gt

gt.load_plugin()
FOLDER = tempfile.TemporaryDirectory()
# Face-on, so that Z is the height over the disc: its density is exp(-r / 2 kpc).
FACE_ON = """
[galaxy]
ra = 10
dec = 20
distance = 5
radius = 12
rotation_velocity = 200
[[component]]
name = "disc"
particles = 40000
profile = "Exponential"
scale_length = 2
"""


def written(name, text):
    path = os.path.join(FOLDER.name, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def points_of(proxy):
    data = servermanager.Fetch(proxy)
    if data.GetNumberOfPoints() == 0:
        return np.zeros((0, 3))
    return gt.vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def light_of(proxy):
    return gt.array(proxy, "Intensity").astype(float)


def count_of(proxy):
    return proxy.GetDataInformation().GetNumberOfPoints()


def cloud(count=20000, seed=1):
    return np.random.default_rng(seed).normal(size=(count, 3))


class Filters(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.galaxy = simple.GalaxyReader(FileName=written("face-on.galaxy", FACE_ON))
        cls.seeds = simple.DiskSeeds(Input=cls.galaxy)
        cls.seeds.UpdatePipeline()

    def refused(self, proxy, names):
        """Each of these values of a property is refused by the name of its key, and the filter
        works again afterwards."""
        for prop, (value, key) in names.items():
            good = proxy.GetPropertyValue(prop)
            good = list(good) if isinstance(value, list) else good  # else a view of the property
            proxy.SetPropertyWithName(prop, value)
            with gt.Messages() as messages:
                proxy.UpdatePipeline()
            self.assertIn(key, messages.text, prop)
            self.assertIn("must be", messages.text, prop)
            self.assertEqual(count_of(proxy), 0, prop)
            proxy.SetPropertyWithName(prop, good)
        proxy.UpdatePipeline()
        self.assertGreater(count_of(proxy), 0)

    def thick(self, **properties):
        """Points and intensities of DiskThickness, and the number of children of a seed."""
        made = simple.DiskThickness(Input=self.seeds, **properties)
        made.UpdatePipeline()
        return points_of(made), light_of(made), count_of(made) / count_of(self.seeds)

    # --- DiskSeeds -------------------------------------------------------------------------------

    def test_sampling_follows_the_light_or_the_surface(self):
        law = {"ImageDriven": lambda r: 1 - (1 + r / 2) * np.exp(-r / 2),
               "SurfaceUniform": lambda r: r**2}
        light = {}
        for sampling, mass in law.items():
            seeds = simple.DiskSeeds(Input=self.galaxy, Sampling=sampling)
            seeds.UpdatePipeline()
            r = np.sort(gt.array(seeds, "Radius").astype(float))
            distance = np.abs(mass(r) / mass(12.0) - (np.arange(len(r)) + 0.5) / len(r)).max()
            self.assertLess(distance, 1.95 / np.sqrt(len(r)), sampling)  # Kolmogorov-Smirnov
            light[sampling] = gt.array(seeds, "Light").astype(float).sum()
        whole = 2 * np.pi * 4 * law["ImageDriven"](12.0)
        self.assertAlmostEqual(light["ImageDriven"] / whole, 1, delta=0.001)
        self.assertAlmostEqual(light["SurfaceUniform"] / whole, 1, delta=0.02)

    def test_sampling_of_an_image(self):
        galaxy = simple.GalaxyReader(FileName=gt.M83)
        mean, light = {}, {}
        for sampling in ("ImageDriven", "SurfaceUniform"):
            seeds = simple.DiskSeeds(Input=galaxy, Component="stars", ParticleScale=0.02,
                                     Sampling=sampling)
            seeds.UpdatePipeline()
            mean[sampling] = gt.array(seeds, "Intensity").mean()
            light[sampling] = gt.array(seeds, "Light").astype(float).sum()
        self.assertGreater(mean["ImageDriven"], 1.5 * mean["SurfaceUniform"])
        # Seeds that do not look at the light miss some of the lit pixels.
        self.assertLess(light["SurfaceUniform"], light["ImageDriven"])
        self.assertGreater(light["SurfaceUniform"], 0.6 * light["ImageDriven"])

    # --- DiskThickness ---------------------------------------------------------------------------

    def test_vertical_laws_have_their_heights(self):
        for law, rms in (("Gaussian", 1), ("Sech2", 0.9069), ("Exponential", 1.4142),
                         ("Box", 0.57735)):
            points, _, _ = self.thick(Model="Tapered", Law=law, ScaleHeight=0.4, Sigma=0)
            self.assertAlmostEqual(points[:, 2].std() / (0.4 * rms), 1, delta=0.03, msg=law)
            self.assertAlmostEqual(points[:, 2].mean(), 0, delta=0.01, msg=law)
        points, _, _ = self.thick(Model="Tapered", Law="Lorentzian", ScaleHeight=0.4, Sigma=0)
        self.assertLess(np.abs(points[:, 2]).max(), 4.0001)
        self.assertAlmostEqual(np.median(np.abs(points[:, 2])) / 0.4, 0.90, delta=0.04)

    def test_readings_of_the_tapered_model(self):
        r = np.hypot(*points_of(self.seeds)[:, :2].T)
        for reading, length in (("RadialScale", 3.0), ("Literal", 0.8)):
            points, _, children = self.thick(
                Model="Tapered", Reading=reading, Children=20, ScaleLength=3.0, ScaleHeight=0.8,
                Sigma=0.05, Law="Box")
            mean = np.maximum(1, 20 * np.exp(-r / length)).mean()  # a seed has one at least
            self.assertAlmostEqual(children / mean, 1, delta=0.02, msg=reading)
            height = 0.8 / np.sqrt(3)
            self.assertAlmostEqual(points[:, 2].std() / height, 1, delta=0.02, msg=reading)

    def test_flared_and_hydrostatic_gas_is_thicker_outside(self):
        for model in ("Flared", "Hydrostatic"):
            points, _, _ = self.thick(Model=model, Sigma=0.01, Children=2)
            r = np.hypot(*points[:, :2].T)
            self.assertTrue(np.all(np.isfinite(points)))
            inner, outer = (points[part, 2].std() for part in (r < 3, r > 8))
            self.assertGreater(outer, 1.3 * inner, model)
            self.assertLess(outer, 4, model)
        points, _, _ = self.thick(Model="Rings", Sigma=0)  # the flat disc's are without height
        self.assertLess(np.abs(points[:, 2]).max(), 1e-3)

    def test_children_share_or_inherit_the_light(self):
        light = gt.array(self.seeds, "Light").astype(float).sum()
        for child_light, factor in (("Share", 1), ("Inherit", 3)):
            _, intensity, children = self.thick(Model="Flared", Children=3, ChildLight=child_light)
            self.assertEqual(children, 3)
            self.assertAlmostEqual(intensity.sum() / (factor * light), 1, delta=1e-6)

    def test_profile_table_replaces_the_formula(self):
        table = written("widths.txt", "# R FWHM\n0 0.4\n3 0.4\n3.001 1.2\n20 1.2\n")
        points, _, _ = self.thick(Model="Flared", Law="Gaussian", Sigma=0, ProfileTable=table)
        r = np.hypot(*points[:, :2].T)
        for part, fwhm in ((r < 3, 0.4), (r > 3.002, 1.2)):
            self.assertAlmostEqual(2.35482 * points[part, 2].std() / fwhm, 1, delta=0.03)
        for name, text in (("absent.txt", None), ("bad.txt", "0 0.4\n1 -2\n"),
                           ("order.txt", "0 1\n2 1\n1 1\n"), ("empty.txt", "")):
            path = os.path.join(FOLDER.name, name) if text is None else written(name, text)
            bad = simple.DiskThickness(Input=self.seeds, Model="Flared", ProfileTable=path)
            with gt.Messages() as messages:
                bad.UpdatePipeline()
            self.assertIn(name, messages.text)
            self.assertEqual(count_of(bad), 0)

    def test_thickness_refuses_by_name(self):
        thickness = simple.DiskThickness(Input=self.seeds, Model="Flared")
        self.refused(thickness, {
            "Children": (-1, "children"), "Sigma": (-0.1, "sigma"),
            "Compression": (1.5, "compression"), "ScaleLength": (0, "scale_length"),
            "ScaleHeight": (-1, "scale_height"), "FWHMCentre": (-1, "fwhm_centre"),
            "FWHMEdge": (0, "fwhm_edge"), "EdgeRadius": (0, "edge_radius"),
            "FlareLength": (-3, "flare_length"), "FWHMMaximum": (0, "fwhm_maximum"),
            "ReferenceVelocity": (0, "reference_velocity"),
            "VelocityExponent": (float("nan"), "velocity_exponent"),
            "GasDispersion": (0, "gas_dispersion"),
            "StellarSurfaceDensity": (-1, "stellar_surface_density"),
            "GasSurfaceDensity": (-1, "gas_surface_density"),
            "MaximumChildren": (0, "maximum_children"),
        })

    # --- DustFilaments ---------------------------------------------------------------------------

    def test_fractal_dust(self):
        light = gt.array(self.seeds, "Light").astype(float).sum()
        clumping = {}
        for contrast in (0, 2, 5):
            dust = simple.DustFilaments(Input=self.seeds, Model="Fractal", Children=4,
                                        Contrast=contrast, ScaleHeight=0.1, NoiseScale=1)
            dust.UpdatePipeline()
            points, depth = points_of(dust), light_of(dust)
            self.assertTrue(np.all(np.isfinite(points)) and np.all(depth >= 0))
            self.assertAlmostEqual(depth.sum() / light, 1, delta=1e-5)
            self.assertAlmostEqual(points[:, 2].std() / 0.1, 1, delta=0.1)
            self.assertGreater(len(points), 2 * count_of(self.seeds))
            column, _, _ = np.histogram2d(points[:, 0], points[:, 1], bins=16,
                                          range=[[-2, 2], [-2, 2]], weights=depth)
            clumping[contrast] = column.std() / column.mean()
        self.assertGreater(clumping[2], 1.5 * clumping[0])

    def test_dust_refuses_by_name(self):
        dust = simple.DustFilaments(Input=self.seeds, Model="Fractal", Children=1)
        self.refused(dust, {
            "Steps": (0, "steps"), "StepLength": (0, "step_length"),
            "VelocityDispersion": (-1, "velocity_dispersion"),
            "VerticalDispersion": (-1, "vertical_dispersion"),
            "ScaleHeight": (-1, "scale_height"), "DampingTime": (0, "damping_time"),
            "Octaves": (99, "octaves"), "Lacunarity": (0.5, "lacunarity"), "Hurst": (3, "hurst"),
            "Contrast": (-1, "contrast"), "NoiseScale": (0, "noise_scale"),
            "Winding": (1000, "winding"), "Children": (0, "children"), "Spread": (-1, "spread"),
        })

    # --- SmoothingLength -------------------------------------------------------------------------

    def smoothed(self, data, **properties):
        producer = simple.TrivialProducer()
        producer.GetClientSideObject().SetOutput(data)
        proxy = simple.SmoothingLength(Input=producer, **properties)
        proxy.UpdatePipeline()
        return proxy

    def plain(self, position, **arrays):
        data = gt.particles(position, np.ones(len(position)), **arrays).GetClientSideObject()
        data = data.GetOutputDataObject(0)
        data.GetPointData().RemoveArray("SmoothingLength")
        return data

    def test_smoothing_lengths_of_a_plain_cloud(self):
        position = cloud()
        r = np.linalg.norm(position, axis=1)
        found = {}
        for model in ("Density", "Neighbours"):
            h = gt.array(self.smoothed(self.plain(position), Model=model), "SmoothingLength")
            self.assertTrue(np.all(np.isfinite(h)) and np.all(h > 0), model)
            self.assertGreater(np.median(h[r > 2.5]), 1.8 * np.median(h[r < 0.5]), model)
            found[model] = h
        self.assertAlmostEqual(np.median(found["Density"] / found["Neighbours"]), 1, delta=0.15)
        # The mean distance d = n^(-1/3) about the middle, times the factor.
        n = len(position) * (2 * np.pi) ** -1.5
        middle = np.median(found["Neighbours"][r < 0.3])
        self.assertAlmostEqual(middle / (1.5 * n ** (-1 / 3)), 1, delta=0.1)
        twice = self.smoothed(self.plain(position), Factor=3)
        np.testing.assert_allclose(gt.array(twice, "SmoothingLength"), 2 * found["Density"], 1e-5)

    def test_smoothing_lengths_constant_and_by_brightness(self):
        light = np.random.default_rng(2).uniform(0.1, 5, 20000).astype(np.float32)
        data = self.plain(cloud(), Intensity=light)
        h = gt.array(self.smoothed(data, Model="Constant", Length=0.25), "SmoothingLength")
        self.assertTrue(np.all(h == 0.25))
        h = gt.array(self.smoothed(data, Model="Brightness", Length=0.25, Exponent=0.5),
                     "SmoothingLength").astype(float)
        np.testing.assert_allclose(h / h[0], np.sqrt(light / light[0]), 1e-4)
        self.assertAlmostEqual((h * light).sum() / light.sum(), 0.25, delta=1e-5)
        h = gt.array(self.smoothed(data, Minimum=0.2, Maximum=0.3), "SmoothingLength")
        self.assertEqual((h.min(), h.max()), (np.float32(0.2), np.float32(0.3)))

    def test_smoothing_lengths_of_odd_clouds(self):
        odd = {"one": np.zeros((1, 3)), "same": np.ones((500, 3)),
               "line": np.linspace([0, 0, 0], [1, 0, 0], 300),
               "flat": cloud(1000) * [1, 1, 0], "far": cloud(1000) + 1e6}
        for name, position in odd.items():
            for model in ("Density", "Neighbours", "Constant"):
                h = gt.array(self.smoothed(self.plain(position), Model=model), "SmoothingLength")
                self.assertEqual(len(h), len(position))
                self.assertTrue(np.all(np.isfinite(h)) and np.all(h > 0), (name, model))
        self.assertEqual(count_of(self.smoothed(vtkPolyData())), 0)

    def test_smoothing_refuses_by_name(self):
        data = self.plain(cloud(1000))
        self.refused(self.smoothed(data), {
            "Factor": (0, "factor"), "Neighbours": (0, "neighbours"), "Length": (-1, "length"),
            "Exponent": (3, "exponent"), "Minimum": (-1, "minimum"), "Maximum": (-1, "maximum"),
        })
        with gt.Messages() as messages:
            lightless = self.smoothed(data, Model="Brightness")
        self.assertIn("Intensity", messages.text)
        self.assertEqual(count_of(lightless), 0)

    # --- Spheroid --------------------------------------------------------------------------------

    def test_every_profile_has_its_luminosity_and_ends_where_it_should(self):
        # Radii of half of the mass in units of the scale, without truncation.
        half = {"Gaussian": 1.5382, "Hernquist": 1 + np.sqrt(2), "Exponential": 2.6741,
                "Plummer": 1.3048, "Sersic": None, "NFW": None, "Cored": None}
        for profile, expected in half.items():
            spheroid = simple.Spheroid(
                Profile=profile, NumberOfParticles=30000, Luminosity=7.5, Sigma=[0.5, 0.5, 0.5],
                EffectiveRadius=0.5, ScaleRadius=0.5, SersicIndex=4)
            spheroid.UpdatePipeline()
            r = np.linalg.norm(points_of(spheroid), axis=1)
            self.assertEqual(len(r), 30000, profile)
            self.assertTrue(np.all(np.isfinite(r)), profile)
            self.assertAlmostEqual(light_of(spheroid).sum() / 7.5, 1, delta=1e-5, msg=profile)
            if expected:
                self.assertAlmostEqual(np.median(r) / 0.5 / expected, 1, delta=0.02, msg=profile)
            spheroid.Truncation = 0.7
            spheroid.UpdatePipeline()
            r = np.linalg.norm(points_of(spheroid), axis=1)
            self.assertLessEqual(r.max(), 0.7 * (1 + 1e-5), profile)
            self.assertGreater(r.max(), 0.65, profile)
            self.assertAlmostEqual(light_of(spheroid).sum() / 7.5, 1, delta=1e-5, msg=profile)

    def test_sersic_half_light_radius(self):
        for index in (1, 2, 4):
            spheroid = simple.Spheroid(Profile="Sersic", SersicIndex=index, EffectiveRadius=0.8,
                                       NumberOfParticles=200000)
            spheroid.UpdatePipeline()
            projected = np.median(np.hypot(*points_of(spheroid)[:, :2].T))
            self.assertAlmostEqual(projected / 0.8, 1, delta=0.01, msg=str(index))

    def test_clusters_hold_the_particles_together(self):
        spheroid = simple.Spheroid(Profile="Cored", ScaleRadius=2, Clusters=25, Luminosity=3,
                                   ClusterRadius=0.001, NumberOfParticles=25000)
        spheroid.UpdatePipeline()
        points = points_of(spheroid)
        self.assertEqual(len(points), 25000)
        self.assertAlmostEqual(light_of(spheroid).sum() / 3, 1, delta=1e-5)
        # A thousand particles a cluster, in order; half of a Plummer sphere is within 1.305 radii.
        groups = points.reshape(25, 1000, 3)
        centres = np.median(groups, axis=1)
        distance = np.linalg.norm(groups - centres[:, None], axis=2)
        np.testing.assert_allclose(np.median(distance, axis=1), 0.001305, rtol=0.15)
        self.assertGreater(np.linalg.norm(centres, axis=1).std(), 0.2)

    def spheroid(self, **properties):
        source = simple.Spheroid(**dict({"NumberOfParticles": 50000}, **properties))
        source.UpdatePipeline()
        return source

    def test_presets_of_a_spheroid(self):
        bulge = self.spheroid(Preset="Bulge", EffectiveRadius=5, CentralBrightness=2)
        points = points_of(bulge)
        projected = np.median(np.hypot(*points[:, :2].T))
        self.assertAlmostEqual(projected / 0.7, 1, delta=0.02)  # the preset's, not the property's
        x, _, z = np.median(np.abs(points), axis=0)
        self.assertAlmostEqual(z / x, 0.7, delta=0.02)
        half = self.spheroid(Preset="Bulge", CentralBrightness=1)
        self.assertAlmostEqual(light_of(bulge).sum() / light_of(half).sum(), 2, delta=1e-5)
        for preset in ("StellarHalo", "Elliptical", "DwarfSpheroidal", "DwarfElliptical",
                       "DwarfIrregular"):
            self.assertGreater(light_of(self.spheroid(Preset=preset)).sum(), 0, preset)
        self.assertEqual(light_of(self.spheroid(Preset="DarkHalo")).sum(), 0)
        halo = self.spheroid(Preset="DarkHalo", Luminosity=3)
        self.assertAlmostEqual(light_of(halo).sum() / 3, 1, delta=1e-5)
        self.assertLess(np.linalg.norm(points_of(halo), axis=1).max(), 200 * (1 + 1e-5))

    def test_slope_and_orientation_of_a_spheroid(self):
        # A core with the slope 5 is Plummer's sphere.
        points = points_of(self.spheroid(Profile="Cored", Slope=5, Concentration=1e6,
                                         ScaleRadius=0.5))
        self.assertAlmostEqual(np.median(np.linalg.norm(points, axis=1)) / 0.65240, 1, delta=0.01)
        # The first axis 30 degrees from North to the East (-X), the third to the West of it.
        points = points_of(self.spheroid(Sigma=[0.5, 0.3, 0.2], Oriented=1, PositionAngle=30,
                                         Inclination=90))
        s, c = np.sin(np.pi / 6), np.cos(np.pi / 6)
        for axis, sigma in (([-s, c, 0], 0.5), ([0, 0, 1], 0.3), ([c, s, 0], 0.2)):
            self.assertAlmostEqual((points @ axis).std() / sigma, 1, delta=0.02)

    def test_shells_and_listed_clusters_of_a_spheroid(self):
        shells = written("shells.csv", "semi_major,axis_ratio_b,axis_ratio_c,position_angle\n"
                                       "0,0.5,0.25,90\n9,0.5,0.25,90\n")
        x, y, z = points_of(self.spheroid(Profile="Exponential", Shells=shells)).std(axis=0)
        self.assertAlmostEqual(y / x, 0.5, delta=0.01)
        self.assertAlmostEqual(z / x, 0.25, delta=0.005)
        listed = written("clusters.csv", "x,y,z,luminosity\n1,2,3,1\n-4,0,1,3\n")
        source = self.spheroid(ClusterList=listed, Luminosity=8, Center=[0, 0, 10])
        points, light = points_of(source), light_of(source)
        for centre, expected in (([1, 2, 13], 2), ([-4, 0, 11], 6)):
            near = np.linalg.norm(points - centre, axis=1) < 1
            self.assertAlmostEqual(light[near].sum() / expected, 1, delta=1e-3)
        sky = written("sky.csv", "ra,dec\n10,20\n")
        for properties, word in (({"ClusterList": listed}, "Luminosity: must be"),
                                 ({"ClusterList": sky, "Luminosity": 1}, "x, y and z"),
                                 ({"Shells": sky}, "semi_major"),
                                 ({"Shells": "absent.csv"}, "absent.csv")):
            with gt.Messages() as messages:
                bad = self.spheroid(**properties)
            self.assertIn(word, messages.text)
            self.assertEqual(count_of(bad), 0)

    def test_a_spheroid_refuses_by_name(self):
        spheroid = simple.Spheroid(NumberOfParticles=1000)
        nan = float("nan")
        self.refused(spheroid, {
            "NumberOfParticles": (-1, "NumberOfParticles"), "Sigma": ([-1, 1, 1], "sigma"),
            "EffectiveRadius": (0, "effective_radius"), "SersicIndex": (1e9, "sersic_index"),
            "ScaleRadius": (-1, "scale_radius"), "Slope": (1, "slope"),
            "Concentration": (0, "concentration"), "Truncation": (-2, "truncation"),
            "AxisRatios": ([-0.5, 1], "axis_ratios"), "Inclination": (200, "inclination"),
            "PositionAngle": (nan, "position_angle"), "Clusters": (-3, "clusters"),
            "ClusterRadius": (0, "cluster_radius"), "Center": ([0, nan, 0], "Center"),
            "CentralBrightness": (-1, "central_brightness"), "Luminosity": (-5, "Luminosity"),
            "Color": ([1, -1, 1], "Color"), "SmoothingLength": (-1, "SmoothingLength"),
            "RandomSeed": (-1, "RandomSeed"),
        })
        self.refused(spheroid, {
            "Sigma": ([0, 0, 0], "sigma"), "ScaleRadius": (nan, "scale_radius"),
            "Truncation": (1e-300, "truncation"), "AxisRatios": ([0, 0], "axis_ratios"),
            "CentralBrightness": (nan, "central_brightness"), "Luminosity": (nan, "Luminosity"),
            "Color": ([nan, 1, 1], "Color"),
        })
        spheroid.NumberOfParticles = 0
        spheroid.UpdatePipeline()
        self.assertEqual(count_of(spheroid), 0)

    # --- GalaxyModel -----------------------------------------------------------------------------

    def test_report_adds_up_and_a_particle_takes_24_bytes(self):
        model = simple.GalaxyModel(Input=simple.GalaxyReader(FileName=gt.M83), ParticleScale=0.02)
        model.UpdatePipeline()
        model.UpdatePropertyInformation()
        report = json.loads(str(model.ReportJSON))
        names = ["stars", "young stars", "gas", "dust", "bulge"]
        self.assertEqual([entry["component"] for entry in report], names)
        component, light = gt.array(model, "Component"), light_of(model)
        totals = np.bincount(component, light, len(names))
        for index, entry in enumerate(report):
            self.assertEqual(entry["particles"], np.count_nonzero(component == index))
            self.assertAlmostEqual(entry["light"] / totals[index], 1, delta=1e-6)
            self.assertGreaterEqual(entry["seeds_drawn"], entry["seeds_kept"])
            self.assertTrue(all(second >= 0 for second in entry["seconds"].values()))
            if entry["flux"] > 0:
                self.assertLessEqual(entry["light"], entry["flux"] * (1 + 1e-6))
        self.assertEqual(sum(entry["particles"] for entry in report), count_of(model))

        data = servermanager.Fetch(model)
        arrays = data.GetPointData()
        columns = [arrays.GetArray(k) for k in range(arrays.GetNumberOfArrays())]
        columns.append(data.GetPoints().GetData())
        size = sum(c.GetNumberOfComponents() * c.GetDataTypeSize() for c in columns)
        self.assertEqual(size, 24)
        self.assertEqual(data.GetNumberOfCells(), 0)


if __name__ == "__main__":
    unittest.main()
