"""The source Spheroid: its light and its shape by every profile, and what it refuses."""
import unittest

import numpy as np
from paraview import simple

import galaxy_testing as gt

gt.load_plugin()


class Spheroid(gt.ProxyTest):
    def test_every_profile_has_its_luminosity_and_ends_where_it_should(self):
        # Radii of half of the mass in units of the scale, without truncation.
        half = {"Gaussian": 1.5382, "Hernquist": 1 + np.sqrt(2), "Exponential": 2.6741,
                "Plummer": 1.3048, "Sersic": None, "NFW": None, "Cored": None}
        for profile, expected in half.items():
            spheroid = simple.Spheroid(
                Profile=profile, NumberOfParticles=30000, Luminosity=7.5, Sigma=[0.5, 0.5, 0.5],
                EffectiveRadius=0.5, ScaleRadius=0.5, SersicIndex=4, Truncation=1e5)
            spheroid.UpdatePipeline()
            r = np.linalg.norm(gt.points_of(spheroid), axis=1)
            self.assertEqual(len(r), 30000, profile)
            self.assertTrue(np.all(np.isfinite(r)), profile)
            self.assertAlmostEqual(gt.light_of(spheroid).sum() / 7.5, 1, delta=1e-5, msg=profile)
            if expected:
                self.assertAlmostEqual(np.median(r) / 0.5 / expected, 1, delta=0.02, msg=profile)
            spheroid.Truncation = 0.7
            spheroid.UpdatePipeline()
            r = np.linalg.norm(gt.points_of(spheroid), axis=1)
            self.assertLessEqual(r.max(), 0.7 * (1 + 1e-5), profile)
            self.assertGreater(r.max(), 0.65, profile)
            self.assertAlmostEqual(gt.light_of(spheroid).sum() / 7.5, 1, delta=1e-5, msg=profile)

    def test_every_profile_ends_unasked(self):
        ends = {"Gaussian": 5, "Sersic": 20, "Hernquist": 40, "Exponential": 15, "Plummer": 20,
                "NFW": 10, "Cored": 10}
        for profile, end in ends.items():
            spheroid = simple.Spheroid(
                Profile=profile, NumberOfParticles=300000, Luminosity=7.5, Sigma=[0.5, 0.5, 0.5],
                EffectiveRadius=0.5, ScaleRadius=0.5, SersicIndex=4)
            spheroid.UpdatePipeline()
            farthest = np.linalg.norm(gt.points_of(spheroid), axis=1).max()
            self.assertLess(farthest, 0.5 * end * (1 + 1e-5), profile)
            self.assertGreater(farthest, 0.5 * end * 0.8, profile)
            self.assertAlmostEqual(gt.light_of(spheroid).sum() / 7.5, 1, delta=1e-5, msg=profile)
        # Seen near its middle, a sphere that ends is as bright as one that does not.
        light = [gt.light_of(self.spheroid(Profile="Plummer", ScaleRadius=0.5, **end)).sum()
                 for end in ({}, {"Truncation": 1e5})]
        self.assertAlmostEqual(light[0] / light[1], (1 + 20**-2) ** -1.5, delta=1e-4)

    def test_sersic_half_light_radius(self):
        for index in (1, 2, 4):
            spheroid = simple.Spheroid(Profile="Sersic", SersicIndex=index, EffectiveRadius=0.8,
                                       Truncation=1e5,
                                       NumberOfParticles=200000)
            spheroid.UpdatePipeline()
            projected = np.median(np.hypot(*gt.points_of(spheroid)[:, :2].T))
            self.assertAlmostEqual(projected / 0.8, 1, delta=0.01, msg=str(index))

    def test_clusters_hold_the_particles_together(self):
        spheroid = simple.Spheroid(Profile="Cored", ScaleRadius=2, Clusters=25, Luminosity=3,
                                   ClusterRadius=0.001, NumberOfParticles=25000)
        spheroid.UpdatePipeline()
        points = gt.points_of(spheroid)
        self.assertEqual(len(points), 25000)
        self.assertAlmostEqual(gt.light_of(spheroid).sum() / 3, 1, delta=1e-5)
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
        points = gt.points_of(bulge)
        projected = np.median(np.hypot(*points[:, :2].T))
        self.assertAlmostEqual(projected / 0.7, 1, delta=0.02)  # the preset's, not the property's
        x, _, z = np.median(np.abs(points), axis=0)
        self.assertAlmostEqual(z / x, 0.7, delta=0.02)
        half = self.spheroid(Preset="Bulge", CentralBrightness=1)
        self.assertAlmostEqual(gt.light_of(bulge).sum() / gt.light_of(half).sum(), 2, delta=1e-5)
        for preset in ("StellarHalo", "Elliptical", "DwarfSpheroidal", "DwarfElliptical",
                       "DwarfIrregular"):
            self.assertGreater(gt.light_of(self.spheroid(Preset=preset)).sum(), 0, preset)
        self.assertEqual(gt.light_of(self.spheroid(Preset="DarkHalo")).sum(), 0)
        halo = self.spheroid(Preset="DarkHalo", Luminosity=3)
        self.assertAlmostEqual(gt.light_of(halo).sum() / 3, 1, delta=1e-5)
        self.assertLess(np.linalg.norm(gt.points_of(halo), axis=1).max(), 200 * (1 + 1e-5))

    def test_slope_and_orientation_of_a_spheroid(self):
        # A core with the slope 5 is Plummer's sphere.
        points = gt.points_of(self.spheroid(Profile="Cored", Slope=5, Concentration=1e6,
                                         ScaleRadius=0.5))
        self.assertAlmostEqual(np.median(np.linalg.norm(points, axis=1)) / 0.65240, 1, delta=0.01)
        # The first axis 30 degrees from North to the East (-X), the third to the West of it.
        points = gt.points_of(self.spheroid(Sigma=[0.5, 0.3, 0.2], Oriented=1, PositionAngle=30,
                                         Inclination=90))
        s, c = np.sin(np.pi / 6), np.cos(np.pi / 6)
        for axis, sigma in (([-s, c, 0], 0.5), ([0, 0, 1], 0.3), ([c, s, 0], 0.2)):
            self.assertAlmostEqual((points @ axis).std() / sigma, 1, delta=0.02)

    def test_shells_and_listed_clusters_of_a_spheroid(self):
        shells = gt.written("shells.csv", "semi_major,axis_ratio_b,axis_ratio_c,position_angle\n"
                                       "0,0.5,0.25,90\n9,0.5,0.25,90\n")
        x, y, z = gt.points_of(self.spheroid(Profile="Exponential", Shells=shells)).std(axis=0)
        self.assertAlmostEqual(y / x, 0.5, delta=0.01)
        self.assertAlmostEqual(z / x, 0.25, delta=0.005)
        listed = gt.written("clusters.csv", "x,y,z,luminosity\n1,2,3,1\n-4,0,1,3\n")
        source = self.spheroid(ClusterList=listed, Luminosity=8, Center=[0, 0, 10])
        points, light = gt.points_of(source), gt.light_of(source)
        for centre, expected in (([1, 2, 13], 2), ([-4, 0, 11], 6)):
            near = np.linalg.norm(points - centre, axis=1) < 1
            self.assertAlmostEqual(light[near].sum() / expected, 1, delta=1e-3)
        sky = gt.written("sky.csv", "ra,dec\n10,20\n")
        for properties, word in (({"ClusterList": listed}, "Luminosity: must be"),
                                 ({"ClusterList": sky, "Luminosity": 1}, "x, y and z"),
                                 ({"Shells": sky}, "semi_major"),
                                 ({"Shells": "absent.csv"}, "absent.csv")):
            with gt.Messages() as messages:
                bad = self.spheroid(**properties)
            self.assertIn(word, messages.text)
            self.assertEqual(gt.count_of(bad), 0)

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
        self.assertEqual(gt.count_of(spheroid), 0)


if __name__ == "__main__":
    unittest.main()
