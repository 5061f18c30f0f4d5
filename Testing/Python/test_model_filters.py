"""The model's filters and sources by themselves: their properties, and what they refuse."""
import json
import os
import unittest

import numpy as np
from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import vtkPolyData

import galaxy_testing as gt

gt.load_plugin()
# Face-on, so that Z is the height over the disc: its density is exp(-r / 2 kpc). Of points, nearly,
# that kernels take no share in the thickness.
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
smoothing_length = 0.001
"""


def cloud(count=20000, seed=1):
    return np.random.default_rng(seed).normal(size=(count, 3))


class Filters(gt.ProxyTest):
    @classmethod
    def setUpClass(cls):
        cls.galaxy = simple.GalaxyReader(FileName=gt.written("face-on.galaxy", FACE_ON))
        cls.seeds = simple.DiskSeeds(Input=cls.galaxy)
        cls.seeds.UpdatePipeline()

    def thick(self, **properties):
        """Points and intensities of DiskThickness, and the number of children of a seed."""
        made = simple.DiskThickness(Input=self.seeds, **properties)
        made.UpdatePipeline()
        return gt.points_of(made), gt.light_of(made), gt.count_of(made) / gt.count_of(self.seeds)

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
        r = np.hypot(*gt.points_of(self.seeds)[:, :2].T)
        for reading, length in (("RadialScale", 3.0), ("Literal", 0.8)):
            points, _, children = self.thick(
                Model="Tapered", Reading=reading, Children=20, ScaleLength=3.0, ScaleHeight=0.8,
                Sigma=0.05, Law="Box")
            mean = np.maximum(1, 20 * np.exp(-r / length)).mean()  # a seed has one at least
            self.assertAlmostEqual(children / mean, 1, delta=0.02, msg=reading)
            height = 0.8 / np.sqrt(3)
            self.assertAlmostEqual(points[:, 2].std() / height, 1, delta=0.02, msg=reading)

    def test_the_tapered_model_tapers_unasked(self):
        points, _, _ = self.thick(Model="Tapered", Sigma=0)
        r, seeds = (np.hypot(*gt.points_of(proxy)[:, :2].T) if proxy else np.hypot(*points[:, :2].T)
                    for proxy in (None, self.seeds))
        for inner, outer in ((0, 1), (2, 3), (5, 6)):
            children = np.sum((r >= inner) & (r < outer)) / np.sum((seeds >= inner) & (seeds < outer))
            middle = seeds[(seeds >= inner) & (seeds < outer)]
            expected = np.maximum(1, 15 * np.exp(-middle / 2.5)).mean()
            self.assertAlmostEqual(children / expected, 1, delta=0.05)
        thin, _, _ = self.thick(Model="Tapered", Sigma=0, TaperThickness=1)
        r = np.hypot(*thin[:, :2].T)
        heights = [thin[(r >= low) & (r < low + 0.5), 2].std() for low in (0, 5)]
        self.assertAlmostEqual(heights[1] / heights[0], np.exp(-5 / 2.5), delta=0.02)

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
        table = gt.written("widths.txt", "# R FWHM\n0 0.4\n3 0.4\n3.001 1.2\n20 1.2\n")
        points, _, _ = self.thick(Model="Flared", Law="Gaussian", Sigma=0, ProfileTable=table)
        r = np.hypot(*points[:, :2].T)
        for part, fwhm in ((r < 3, 0.4), (r > 3.002, 1.2)):
            self.assertAlmostEqual(2.35482 * points[part, 2].std() / fwhm, 1, delta=0.03)
        for name, text in (("absent.txt", None), ("bad.txt", "0 0.4\n1 -2\n"),
                           ("order.txt", "0 1\n2 1\n1 1\n"), ("empty.txt", "")):
            path = os.path.join(os.sep, "nowhere", name) if text is None else gt.written(name, text)
            bad = simple.DiskThickness(Input=self.seeds, Model="Flared", ProfileTable=path)
            with gt.Messages() as messages:
                bad.UpdatePipeline()
            self.assertIn(name, messages.text)
            self.assertEqual(gt.count_of(bad), 0)

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
            points, depth = gt.points_of(dust), gt.light_of(dust)
            self.assertTrue(np.all(np.isfinite(points)) and np.all(depth >= 0))
            self.assertAlmostEqual(depth.sum() / light, 1, delta=1e-5)
            self.assertAlmostEqual(points[:, 2].std() / 0.1, 1, delta=0.1)
            self.assertGreater(len(points), 2 * gt.count_of(self.seeds))
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
        self.assertEqual(gt.count_of(self.smoothed(vtkPolyData())), 0)

    def test_smoothing_refuses_by_name(self):
        data = self.plain(cloud(1000))
        self.refused(self.smoothed(data), {
            "Factor": (0, "factor"), "Neighbours": (0, "neighbours"), "Length": (-1, "length"),
            "Exponent": (3, "exponent"), "Minimum": (-1, "minimum"), "Maximum": (-1, "maximum"),
        })
        with gt.Messages() as messages:
            lightless = self.smoothed(data, Model="Brightness")
        self.assertIn("Intensity", messages.text)
        self.assertEqual(gt.count_of(lightless), 0)

    # --- GalaxyModel -----------------------------------------------------------------------------

    def test_report_adds_up_and_a_particle_takes_24_bytes_and_its_vertex_8(self):
        model = simple.GalaxyModel(Input=simple.GalaxyReader(FileName=gt.M83), ParticleScale=0.02)
        model.UpdatePipeline()
        model.UpdatePropertyInformation()
        report = json.loads(str(model.ReportJSON))
        names = ["stars", "young stars", "gas", "dust", "bulge"]
        self.assertEqual([entry["component"] for entry in report], names)
        component, away = gt.array(model, "Component"), 4900 - gt.points_of(model)[:, 2]
        light = gt.light_of(model) * (4900 / away)**2  # as the Earth sees it
        totals = np.bincount(component, light, len(names))
        for index, entry in enumerate(report):
            self.assertEqual(entry["particles"], np.count_nonzero(component == index))
            self.assertAlmostEqual(entry["light"] / totals[index], 1, delta=1e-6)
            self.assertGreaterEqual(entry["seeds_drawn"], entry["seeds_kept"])
            self.assertTrue(all(second >= 0 for second in entry["seconds"].values()))
            if entry["flux"] > 0:
                self.assertLessEqual(entry["light"], entry["flux"] * (1 + 1e-6))
        self.assertEqual(sum(entry["particles"] for entry in report), gt.count_of(model))

        data = servermanager.Fetch(model)
        arrays = data.GetPointData()
        columns = [arrays.GetArray(k) for k in range(arrays.GetNumberOfArrays())]
        columns.append(data.GetPoints().GetData())
        size = sum(c.GetNumberOfComponents() * c.GetDataTypeSize() for c in columns)
        self.assertEqual(size, 24)
        self.assertEqual(data.GetNumberOfCells(), data.GetNumberOfPoints())
        vertices = data.GetVerts()
        cells = [vertices.GetOffsetsArray(), vertices.GetConnectivityArray()]
        size = sum(c.GetNumberOfValues() * c.GetDataTypeSize() for c in cells)
        self.assertLessEqual(size, 8 * data.GetNumberOfPoints() + 8)


if __name__ == "__main__":
    unittest.main()
