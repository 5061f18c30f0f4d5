"""The filter SplatImage: closed forms through the server manager."""
import unittest

import numpy as np

import galaxy_testing as gt

gt.load_plugin()
SIGNATURE = {"CameraParallelProjection": 1, "CameraParallelScale": 1.0, "CameraPosition": [0, 0, 5]}
H = 0.9
SIGMA = H / 3
SIZE = 64
CENTRE = (SIZE // 2, SIZE // 2)  # its centre lies half a pixel from the axis
GREY = np.ones((1, 3), dtype=np.float32)


def column(x, y):
    """The Gaussian footprint at (x, y) kpc from the particle, 1/kpc^2 (interface: Gaussian)."""
    return np.exp(-(x * x + y * y) / SIGMA**2) / (np.pi * SIGMA**2 * (1 - np.exp(-9)))


HALF_PIXEL = 1.0 / SIZE
G = column(HALF_PIXEL, HALF_PIXEL)


class SplatImage(unittest.TestCase):
    def test_total_light_is_the_luminosity(self):
        for h in (0.003, 0.02, 0.9):
            source = gt.particles([[0.013, -0.021, 0]], [h], Emission=[[1.0, 2.0, 4.0]])
            radiance, _ = gt.splat(source, SIZE, **SIGNATURE)
            total = radiance.astype(float).sum(axis=(0, 1)) * (2.0 / SIZE) ** 2
            np.testing.assert_allclose(total, [1, 2, 4], rtol=2e-4)

    def test_one_emitter_is_its_footprint(self):
        source = gt.particles([[0, 0, 0]], [H], Emission=3 * GREY)
        radiance, transmittance = gt.splat(source, SIZE, **SIGNATURE)
        np.testing.assert_allclose(radiance[CENTRE], 3 * G, rtol=2e-3)
        np.testing.assert_array_equal(transmittance, 1)
        self.assertIn("no sort", gt.splat.effects)

    def test_an_absorber_dims_what_lies_behind_it_and_only_that(self):
        k = 1.5 / G
        for z, expected in ((1.0, np.exp(-1.5)), (-1.0, 1.0)):
            source = gt.particles(
                [[0, 0, 0], [0, 0, z]], [H, H],
                Emission=np.array([[1, 1, 1], [0, 0, 0]], dtype=np.float32),
                Absorption=np.array([[0, 0, 0], [k, k, k]], dtype=np.float32),
            )
            radiance, transmittance = gt.splat(source, SIZE, **SIGNATURE)
            np.testing.assert_allclose(radiance[CENTRE], G * expected, rtol=3e-3)
            np.testing.assert_allclose(transmittance[CENTRE], np.exp(-1.5), rtol=3e-3)

    def test_emitting_and_absorbing_particle(self):
        e, t = 2.0, np.array([0.0, 1e-3, 5.0])
        source = gt.particles([[0, 0, 0]], [H], Emission=e * GREY, Absorption=[t / G])
        radiance, _ = gt.splat(source, SIZE, **SIGNATURE)
        phi = [1, (1 - np.exp(-1e-3)) / 1e-3, (1 - np.exp(-5)) / 5]
        np.testing.assert_allclose(radiance[CENTRE], e * G * np.array(phi), rtol=3e-3)

    def test_particles_in_one_place_share_their_path(self):
        # Evenly mixed, light and dust of tau 3 let phi(3) through; one after the other, all or
        # exp(-3) of it.
        t = 3.0
        source = gt.particles(
            [[0, 0, 0], [0, 0, 0]], [H, H],
            Emission=np.array([[1, 1, 1], [0, 0, 0]], dtype=np.float32),
            Absorption=np.array([[0, 0, 0], [t / G] * 3], dtype=np.float32),
        )
        mixed = (1 - np.exp(-t)) / t
        for accuracy, slices, expected, rtol in (
            ("Sorted", 4, np.exp(-t), 1e-2), ("Overlapping", 4, mixed, 3e-3),
            ("Overlapping", 0.5, mixed, 3e-3),  # one source function: right by any slices
        ):
            radiance, transmittance = gt.splat(
                source, SIZE, Accuracy=accuracy, Slices=slices, **SIGNATURE)
            np.testing.assert_allclose(radiance[CENTRE], G * expected, rtol=rtol)
            np.testing.assert_allclose(transmittance[CENTRE], np.exp(-t), rtol=1e-2)
        self.assertIn("slices", gt.splat.effects)

    def test_intensity_color_and_component_table(self):
        source = gt.particles(
            [[0, 0, 0]], [H],
            Intensity=np.array([2], dtype=np.float32),
            Color=np.array([[255, 51, 0]], dtype=np.uint8),
            Component=np.array([0], dtype=np.uint8),
        )
        radiance, _ = gt.splat(source, SIZE, **SIGNATURE)
        np.testing.assert_allclose(radiance[CENTRE], 2 * G * np.array([1, 0.2, 0]), rtol=3e-3)

    def test_size_brightness_and_color_of_a_component(self):
        reader = gt.simple.Spheroid(Sigma=[0.001] * 3, NumberOfParticles=1, SmoothingLength=H)
        plain, _ = gt.splat(reader, SIZE, **SIGNATURE)
        settings = {"ComponentBrightness": ["spheroid", "3"]}
        brighter, _ = gt.splat(reader, SIZE, **SIGNATURE, **settings)
        np.testing.assert_allclose(brighter, 3 * plain, rtol=1e-5)
        smaller, _ = gt.splat(reader, SIZE, **SIGNATURE, ComponentSize=["spheroid", "0.7"])
        np.testing.assert_allclose(smaller.sum(), plain.sum(), rtol=1e-3)
        np.testing.assert_allclose(smaller.max(), plain.max() / 0.7**2, rtol=1e-2)
        hidden, _ = gt.splat(reader, SIZE, **SIGNATURE, ComponentVisibility=["spheroid", "0"])
        np.testing.assert_array_equal(hidden, 0)
        colored, _ = gt.splat(
            reader, SIZE, **SIGNATURE, ComponentColor=["spheroid", "1", "0.5", "0.25"])
        np.testing.assert_allclose(colored, plain * [1, 0.5, 0.25], rtol=1e-5)
        other, _ = gt.splat(reader, SIZE, **SIGNATURE, ComponentBrightness=["nobody", "3"])
        np.testing.assert_array_equal(other, plain)

    def test_looks_show_what_they_are_named_for(self):
        """Dust alone shines with its optical depth; atomic gas alone is blue."""
        reader = gt.simple.GalaxyReader(FileName=gt.M83)
        model = gt.simple.GalaxyModel(Input=reader, ParticleScale=0.01)
        earth = dict(CameraPosition=[0, 0, 100], CameraParallelProjection=1,
                     CameraParallelScale=8, Accuracy="Sorted")
        only_dust = [text for name in ("stars", "young stars", "gas", "bulge")
                     for text in (name, "0")]
        _, transmittance = gt.splat(model, SIZE, **earth, ComponentVisibility=only_dust)
        dust, none = gt.splat(model, SIZE, **earth, Look="Dust Only",
                              ComponentColor=["dust", "1", "1", "1"])
        np.testing.assert_array_equal(none, 1)
        _, grey = gt.splat(model, SIZE, **earth, ComponentVisibility=only_dust,
                           ComponentColor=["dust", "1", "1", "1"])
        np.testing.assert_allclose(dust[..., 0], -np.log(grey[..., 0]), rtol=1e-3, atol=1e-5)
        self.assertLess(transmittance.min(), 0.99)
        gas, none = gt.splat(model, SIZE, **earth, Look="H I")
        np.testing.assert_array_equal(none, 1)
        np.testing.assert_allclose(gas[..., 0], 0.35 * gas[..., 2], rtol=1e-4)

    def test_perspective_sees_the_same_surface_brightness(self):
        source = gt.particles([[0, 0, 0]], [H], Emission=GREY)
        for distance in (20.0, 80.0):
            radiance, _ = gt.splat(
                source, SIZE, CameraPosition=[0, 0, distance],
                CameraViewAngle=2 * np.degrees(np.arctan(1 / distance)),
            )
            np.testing.assert_allclose(radiance[CENTRE], G, rtol=1e-2)

    def test_missing_arrays_are_said(self):
        source = gt.particles([[0, 0, 0]], [H])
        picture = gt.simple.SplatImage(Input=source)
        with gt.Messages() as messages:
            picture.UpdatePipeline()
        self.assertIn("Intensity", messages.text)

    def test_nan_particles_are_left_out_and_said(self):
        source = gt.particles(
            [[0, 0, 0], [np.nan, 0, 0]], [H, H], Emission=np.ones((2, 3), dtype=np.float32)
        )
        with gt.Messages() as messages:
            radiance, _ = gt.splat(source, SIZE, **SIGNATURE)
        self.assertIn("1 particles", messages.text)
        self.assertTrue(np.isfinite(radiance).all())


if __name__ == "__main__":
    unittest.main()
