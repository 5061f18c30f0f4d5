"""What does not fit into memory is refused by name, and the program goes on."""
import contextlib
import os
import resource
import tempfile
import unittest

from paraview import simple

import galaxy_testing as gt


@contextlib.contextmanager
def address_space(more):
    """The process may take so many bytes more."""
    with open("/proc/self/statm", encoding="ascii") as file:
        used = int(file.read().split()[0]) * resource.getpagesize()
    before = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (used + more, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, before)


class Memory(unittest.TestCase):
    def setUp(self):
        gt.load_plugin()

    def refused(self, make, *words, more=1 << 30):
        """What `make()` makes has no points, and a message with these words."""
        with address_space(more), gt.Messages() as messages:
            proxy = make()
            proxy.UpdatePipeline()
        for word in (*words, "of memory, but only"):
            self.assertIn(word, messages.text)
        self.assertEqual(proxy.GetDataInformation().GetNumberOfPoints(), 0)

    def test_pictures(self):
        particles = simple.Spheroid(NumberOfParticles=1000)
        picture = simple.SplatImage(Input=particles, ImageSize=[32, 32])
        for projection in ("Camera", "Equirectangular", "Dome"):
            picture.UpdatePipeline()
            picture.Projection = projection
            picture.ImageSize = [100000, 100000]
            self.refused(lambda: picture, "ImageSize", "100000 x 100000", "choose a smaller one")
            picture.ImageSize = [32, 32]
        picture.ImageSize = [64, 64]
        with gt.Messages() as messages:
            picture.UpdatePipeline()
        self.assertEqual(messages.text, "")
        self.assertEqual(picture.GetDataInformation().GetNumberOfPoints(), 64 * 64)

    def test_models(self):
        self.refused(lambda: simple.Spheroid(NumberOfParticles=2000000000),
                     "Spheroid: spheroid: 2000000000 particles", "56 GB", "use a smaller")
        reader = simple.GalaxyReader(FileName=gt.M83)
        reader.UpdatePipeline()
        model = simple.GalaxyModel(Input=reader, ParticleScale=1000)
        self.refused(lambda: model, "m83.galaxy: ", "use a smaller ParticleScale")
        group = os.path.join(gt.ROOT, "Examples", "M83Group", "m83group.galaxygroup")
        self.refused(lambda: simple.GalaxyGroup(FileName=group, ParticleScale=1000),
                     ".galaxy: ", "use a smaller ParticleScale")

    def test_images(self):
        card = "{:80}".format
        header = "".join([card("SIMPLE  =                    T"), card("BITPIX  =                    8"),
                          card("NAXIS   =                    2"), card("NAXIS1  =                20000"),
                          card("NAXIS2  =                20000"), card("END")])
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "large.fits")
            with open(name, "wb") as file:
                file.write(header.ljust(2880).encode())
                file.truncate(2880 + -(-20000 ** 2 // 2880) * 2880)
            self.refused(lambda: simple.FITSReader(FileName=name),
                         "large.fits: NAXIS", "20000 x 20000", "6.4 GB", "cut out or bin")


if __name__ == "__main__":
    unittest.main(verbosity=2)
