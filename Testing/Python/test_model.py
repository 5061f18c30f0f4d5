"""Seeds, thickness, dust, whole galaxies and groups through the server manager."""
import hashlib
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import VTK_FLOAT, VTK_UNSIGNED_CHAR

import galaxy_testing as gt

gt.load_plugin()
SCALE = 0.02
ARRAYS = ("SmoothingLength", "Intensity", "Color", "Component")


def build(scale=SCALE, **properties):
    reader = simple.GalaxyReader(FileName=gt.M83)
    model = simple.GalaxyModel(Input=reader, ParticleScale=scale, **properties)
    model.UpdatePipeline()
    return model


def digest(model):
    data = servermanager.Fetch(model)
    total = hashlib.sha256(gt.vtk_to_numpy(data.GetPoints().GetData()).tobytes())
    for name in ARRAYS:
        total.update(gt.vtk_to_numpy(data.GetPointData().GetArray(name)).tobytes())
    return total.hexdigest()


class Model(unittest.TestCase):
    def test_arrays_are_as_documented(self):
        data = servermanager.Fetch(build(Velocities=1))
        count = data.GetNumberOfPoints()
        self.assertGreater(count, 10000)
        for name, kind, channels in (
            ("SmoothingLength", VTK_FLOAT, 1),
            ("Intensity", VTK_FLOAT, 1),
            ("Color", VTK_UNSIGNED_CHAR, 3),
            ("Component", VTK_UNSIGNED_CHAR, 1),
            ("Velocity", VTK_FLOAT, 3),
        ):
            values = data.GetPointData().GetArray(name)
            self.assertEqual(values.GetDataType(), kind, name)
            self.assertEqual(values.GetNumberOfComponents(), channels, name)
            self.assertEqual(values.GetNumberOfTuples(), count, name)
        names = data.GetFieldData().GetAbstractArray("ComponentName")
        names = [names.GetValue(i) for i in range(names.GetNumberOfValues())]
        self.assertEqual(names, ["stars", "young stars", "gas", "dust", "bulge"])
        component = gt.vtk_to_numpy(data.GetPointData().GetArray("Component"))
        self.assertEqual(set(np.unique(component)), set(range(5)))

    def test_same_seed_same_particles_for_any_number_of_threads(self):
        here = digest(build())
        for threads in ("1", "3"):
            environment = dict(os.environ, OMP_NUM_THREADS=threads)
            result = subprocess.run(
                ["pvpython", os.path.abspath(__file__), "--digest"],
                env=environment, capture_output=True, text=True, check=True,
            )
            self.assertIn(here, result.stdout)
        self.assertNotEqual(here, digest(build(RandomSeed=2)))

    def test_light_does_not_depend_on_the_number_of_particles(self):
        totals = []
        for scale in (SCALE, 2 * SCALE):
            model = build(scale)
            component = gt.array(model, "Component")
            intensity = gt.array(model, "Intensity").astype(float)
            total = np.bincount(component, intensity)
            # A bulge particle has no more light than its pixel; what few cannot take stays there.
            total[0] += total[4]
            totals.append(total[:4])
        np.testing.assert_allclose(totals[0], totals[1], rtol=0.03)

    def test_the_filters_one_by_one_make_the_models_component(self):
        galaxy = simple.GalaxyReader(FileName=gt.M83)
        whole = servermanager.Fetch(build())
        component = gt.vtk_to_numpy(whole.GetPointData().GetArray("Component"))
        points = gt.vtk_to_numpy(whole.GetPoints().GetData())
        for index, name, make in (
            (0, "stars", simple.DiskThickness),
            (3, "dust", simple.DustFilaments),
        ):
            seeds = simple.DiskSeeds(Input=galaxy, Component=name, ParticleScale=SCALE)
            particles = make(Input=seeds)
            particles.UpdatePipeline()
            data = servermanager.Fetch(particles)
            made = gt.vtk_to_numpy(data.GetPoints().GetData())
            mine = points[component == index]
            # The model has particles of its own for pixels that no other fell on, at the end.
            self.assertLessEqual(len(mine), 1.2 * len(made))
            np.testing.assert_array_equal(made, mine[: len(made)])

    def test_gaussian_children_scatter_by_sigma_and_share_the_light(self):
        galaxy = simple.GalaxyReader(FileName=gt.M83)
        seeds = simple.DiskSeeds(Input=galaxy, Component="stars", ParticleScale=SCALE)
        seeds.UpdatePipeline()
        flat = gt.vtk_to_numpy(servermanager.Fetch(seeds).GetPoints().GetData()).astype(float)
        light = gt.array(seeds, "Light").astype(float)
        for sigma in (0.1, 1.0):
            particles = simple.DiskThickness(Input=seeds, Model="Gaussian", Sigma=sigma, Children=0)
            particles.UpdatePipeline()
            data = servermanager.Fetch(particles)
            points = gt.vtk_to_numpy(data.GetPoints().GetData()).astype(float)
            self.assertEqual(points.shape, flat.shape)  # one child a seed, in the seeds' order
            variance = (points - flat).var(axis=0)
            # A child stands in the plane of its own ring, which the warp has turned. Across that
            # its kernel, of h^2/18, has its share in the thickness.
            h = gt.vtk_to_numpy(data.GetPointData().GetArray("SmoothingLength")).astype(float)
            np.testing.assert_allclose(np.sqrt(variance[:2]), sigma, rtol=0.06)
            whole = variance.sum() + (h**2).mean() / 18
            np.testing.assert_allclose(np.sqrt(whole / 3), sigma, rtol=0.06)
            intensity = gt.vtk_to_numpy(data.GetPointData().GetArray("Intensity")).astype(float)
            seen = intensity * (4900 / (4900 - points[:, 2]))**2  # by the Earth
            self.assertAlmostEqual(seen.sum() / light.sum(), 1, places=5)

    def test_resolutions_of_one_line_are_combined(self):
        images = os.path.join(os.path.dirname(gt.M83), "images")
        names = ("high", "medium", "low")
        text = "[galaxy]\nra = 204.25383\ndec = -29.86576\ndistance = 4.9\nradius = 60\n"
        for name in names:
            text += f'[image.{name}]\nfile = "{images}/m83_hi_{name}.fits"\n'
        text += '[image.all]\ncombine = ["high", "medium", "low"]\n'
        text += "[[component]]\nname = 'gas'\nlayers = [{ image = 'all' }]\n"
        with tempfile.NamedTemporaryFile("w", suffix=".galaxy") as file:
            file.write(text)
            file.flush()
            reader = simple.GalaxyReader(FileName=file.name)
            model = simple.GalaxyModel(Input=reader, ParticleScale=0.2)
            model.UpdatePipeline()
        self.assertGreater(model.GetDataInformation().GetNumberOfPoints(), 5000)

    def test_a_dark_component_is_said(self):
        with open(gt.M83, encoding="utf-8") as file:
            text = file.read().replace("ra = 204.25383", "ra = 13.6")
        folder = os.path.dirname(gt.M83)
        with tempfile.NamedTemporaryFile("w", suffix=".galaxy", dir=folder) as file:
            file.write(text)
            file.flush()
            model = simple.GalaxyModel(Input=simple.GalaxyReader(FileName=file.name),
                                       ParticleScale=SCALE)
            with gt.Messages() as messages:
                model.UpdatePipeline()
        self.assertIn("no particles for stars", messages.text)

    def test_unstable_dust_is_refused(self):
        galaxy = simple.GalaxyReader(FileName=gt.M83)
        seeds = simple.DiskSeeds(Input=galaxy, Component="dust", ParticleScale=SCALE)
        dust = simple.DustFilaments(
            Input=seeds, Model="DiskRotation", StepLength=100, ScaleHeight=0.001
        )
        with gt.Messages() as messages:
            dust.UpdatePipeline()
        self.assertIn("dust", messages.text)
        self.assertEqual(dust.GetDataInformation().GetNumberOfPoints(), 0)

    def test_spheroid_has_its_sigmas(self):
        bulge = simple.Spheroid(Sigma=[0.5, 1, 2], Center=[10, 0, 0], NumberOfParticles=40000)
        bulge.UpdatePipeline()
        points = gt.vtk_to_numpy(servermanager.Fetch(bulge).GetPoints().GetData()).astype(float)
        np.testing.assert_allclose(points.std(axis=0), [0.5, 1, 2], rtol=0.02)
        np.testing.assert_allclose(points.mean(axis=0), [10, 0, 0], atol=0.04)

    def test_group_members_stand_where_the_sky_has_them(self):
        group = simple.GalaxyGroup(
            FileName=os.path.join(gt.ROOT, "Examples", "M83Group", "m83group.galaxygroup"),
            ParticleScale=SCALE,
        )
        group.UpdatePipeline()
        data = servermanager.Fetch(group)
        names = data.GetFieldData().GetAbstractArray("ComponentName")
        names = [names.GetValue(i) for i in range(names.GetNumberOfValues())]
        component = gt.vtk_to_numpy(data.GetPointData().GetArray("Component"))
        points = gt.vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        ra0, dec0, d0 = np.radians(204.25384), np.radians(-29.86576), 4900.0
        west = np.array([np.sin(ra0), -np.cos(ra0), 0])
        toward = -np.array([np.cos(dec0) * np.cos(ra0), np.cos(dec0) * np.sin(ra0), np.sin(dec0)])
        axes = np.array([west, np.cross(toward, west), toward])
        for name, ra, dec, distance in (
            ("NGC 5264", 205.4042, -29.9139, 4790.0),
            ("IC 4316", 205.0754, -28.8944, 4350.0),
            ("UGCA 365", 204.1283, -29.2364, 5420.0),
            ("ESO 444-G084", 204.3342, -28.0461, 4610.0),
        ):
            mine = [i for i, full in enumerate(names) if full.startswith(name + "/")]
            self.assertTrue(mine, names)
            middle = points[np.isin(component, mine)].mean(axis=0)
            ra, dec = np.radians(ra), np.radians(dec)
            place = distance * np.array(
                [np.cos(dec) * np.cos(ra), np.cos(dec) * np.sin(ra), np.sin(dec)]
            )
            np.testing.assert_allclose(middle, axes @ place + [0, 0, d0], atol=3.0)


if __name__ == "__main__":
    if "--digest" in sys.argv:
        print(digest(build()))
    else:
        unittest.main()
