"""Everything that can take long tells how far it is, and stops where it is told to."""
import os
import unittest

from paraview import simple

import galaxy_testing as gt

GROUP = os.path.join(gt.ROOT, "Examples", "M83Group", "m83group.galaxygroup")


def galaxy():
    return simple.GalaxyReader(FileName=gt.M83)


def model():
    return simple.GalaxyModel(Input=galaxy(), ParticleScale=0.03)


def seeds(component):
    return simple.DiskSeeds(Input=galaxy(), Component=component, ParticleScale=0.03)


MAKERS = {
    "GalaxyReader": galaxy,
    "GalaxyModel": model,
    "GalaxyGroup": lambda: simple.GalaxyGroup(FileName=GROUP, ParticleScale=0.03),
    "DiskSeeds": lambda: seeds("stars"),
    "DiskThickness": lambda: simple.DiskThickness(Input=seeds("stars")),
    "DustFilaments": lambda: simple.DustFilaments(Input=seeds("dust")),
    "Spheroid": lambda: simple.Spheroid(NumberOfParticles=1000),
    "SmoothingLength": lambda: simple.SmoothingLength(Input=model(), Model="Neighbours"),
    "SplatImage": lambda: simple.SplatImage(Input=model(), ImageSize=[64, 64]),
}



class Progress(unittest.TestCase):
    def setUp(self):
        gt.load_plugin()

    def told(self, proxy, stop_after=None):
        """The fractions that the algorithm tells, until it is told to stop."""
        inputs = proxy.GetProperty("Input")
        if inputs:
            inputs[0].UpdatePipeline()
        fractions = []

        def listen(caller, _):
            fractions.append(caller.GetProgress())
            if len(fractions) == stop_after:
                caller.SetAbortExecute(1)

        proxy.GetClientSideObject().AddObserver("ProgressEvent", listen)
        with gt.Messages() as messages:
            proxy.UpdatePipeline()
        self.assertEqual(messages.text, "")
        return fractions

    def test_the_fraction_grows(self):
        for name, make in MAKERS.items():
            with self.subTest(name):
                proxy = make()
                fractions = self.told(proxy)
                between = {f for f in fractions if 0 < f < 1}
                self.assertGreaterEqual(len(between), 1, fractions)
                self.assertEqual(fractions, sorted(fractions))
                self.assertGreater(proxy.GetDataInformation().GetNumberOfPoints(), 0)

    def test_what_is_stopped_says_nothing_and_has_no_data(self):
        for name, make in MAKERS.items():
            with self.subTest(name):
                proxy = make()
                fractions = self.told(proxy, stop_after=2)  # the first is VTK's own 0
                self.assertLess(max(fractions[:2]), 1)
                self.assertLessEqual(len(fractions), 3)  # and the last VTK's own 1
                self.assertEqual(proxy.GetDataInformation().GetNumberOfPoints(), 0)

    def test_a_model_that_was_stopped_can_be_built_after_all(self):
        proxy = model()
        algorithm = proxy.GetClientSideObject()
        stop = algorithm.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
        proxy.UpdatePipeline()
        self.assertEqual(proxy.GetDataInformation().GetNumberOfPoints(), 0)
        algorithm.RemoveObserver(stop)
        algorithm.Modified()
        proxy.UpdatePipeline()
        self.assertGreater(len(gt.points_of(proxy)), 10000)


if __name__ == "__main__":
    unittest.main(verbosity=2)
