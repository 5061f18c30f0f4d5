"""States: a scene saved as .pvsm or .py shows the same picture when loaded. Needs a display."""
import unittest

import numpy as np
from paraview import servermanager, simple, smstate

import galaxy_testing as gt
import plugin_xml
import replay

gt.load_plugin()
ODD_NAME = 'A "bulge" of M83 & <more>'  # what XML and Python must quote


class Scene:
    """The galaxy, a spheroid and a picture of them, all with settings that are not the default."""

    def __init__(self):
        self.view = replay.dark_view()
        galaxy = simple.GalaxyReader(registrationName="galaxy", FileName=gt.M83)
        model = simple.GalaxyModel(registrationName="model", Input=galaxy, ParticleScale=0.004)
        model.RandomSeed = 7
        self.display = simple.Show(model, self.view)
        self.display.Exposure, self.display.Stretch, self.display.Gamma = 0.7, 4.0, 1.2
        self.display.Accuracy, self.display.Kernel = "Sorted", "CubicSpline"
        self.display.ComponentVisibility = ["gas", "0", "no such", "0"]
        self.display.ComponentSize = ["stars", "1.5"]
        self.display.ComponentBrightness = ["young stars", "2", "dust", "0.5"]
        self.display.ComponentColor = ["young stars", "1", "0.3", "0.9"]
        self.spheroid = simple.Spheroid(registrationName="bulge", Profile="Sersic", SersicIndex=3)
        self.spheroid.NumberOfParticles, self.spheroid.Center = 5000, [3, 2, 1]
        self.spheroid.Color = [1, 0.5, 0.2]
        simple.Show(self.spheroid, self.view).ComponentBrightness = ["Spheroid", "3"]
        self.picture = simple.SplatImage(registrationName="picture", Input=model)
        self.picture.ImageSize, self.picture.CameraPosition = [64, 48], [0, 0, 60]
        self.picture.ComponentVisibility = ["dust", "0"]
        self.picture.ComponentSize = ["stars", "2"]
        replay.look_at(self.view)

    def seen(self, name="state.png"):
        return replay.shot(self.view, replay.output(name))


class State(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = Scene()
        cls.seen = cls.scene.seen()
        cls.light = replay.light(cls.scene.picture)

    @classmethod
    def tearDownClass(cls):
        simple.Delete(cls.scene.view)  # ParaView does not survive sys.exit with one
        del cls.scene

    def same(self, loaded):
        self.assertEqual(set(loaded), {"view", "picture"})
        np.testing.assert_array_equal(loaded["view"], self.seen)
        np.testing.assert_array_equal(loaded["picture"], self.light)

    def test_pvsm(self):
        path = replay.output("state.pvsm")
        simple.SaveState(path)
        self.same(replay.run(f"from paraview import simple\nsimple.LoadState({path!r})\n"))

    def test_py(self):
        self.same(replay.run(smstate.get_state()))

    def test_each_setting_is_seen(self):
        """Else a lost one would not be noticed above."""
        self.assertGreater(self.seen.max(), 200)
        for name, value, kept in (
            ("ComponentVisibility", [], ["gas", "0"]), ("ComponentSize", [], ["stars", "1.5"]),
            ("ComponentBrightness", [], ["young stars", "2", "dust", "0.5"]),
            ("ComponentColor", [], ["young stars", "1", "0.3", "0.9"]),
            ("Gamma", 1, 1.2), ("Kernel", "Gaussian", "CubicSpline"),
        ):
            self.scene.display.SetPropertyWithName(name, value)
            changed = self.scene.seen("state-changed.png").astype(int)
            self.assertGreater(np.abs(changed - self.seen).max(), 10, name)
            self.scene.display.SetPropertyWithName(name, kept)
        np.testing.assert_array_equal(self.scene.seen(), self.seen)


def another(prop):
    """A value of a property that is not its default and that its domains allow."""
    is_text = prop.IsA("vtkSMStringVectorProperty")
    if prop.GetRepeatCommand():
        numbers = ["0.25"] * (prop.GetNumberOfElementsPerCommand() - 1)
        return [ODD_NAME] + numbers if is_text else [0.5, -1e30]
    if is_text:
        return [ODD_NAME]
    values = elements(prop)
    for domain in domains(prop):
        if domain.IsA("vtkSMEnumerationDomain"):
            entries = map(domain.GetEntryValue, range(domain.GetNumberOfEntries()))
            return [next(entry for entry in entries if entry != values[0])]
        if domain.IsA("vtkSMBooleanDomain"):
            return [1 - values[0]]
    step = 1 if prop.IsA("vtkSMIntVectorProperty") else 0.123456789
    return [value - step if value >= 1 else value + step for value in values]


def domains(prop):
    iterator = prop.NewDomainIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        yield iterator.GetDomain()
        iterator.Next()


def elements(prop):
    return [prop.GetElement(i) for i in range(prop.GetNumberOfElements())]


def set_elements(prop, values):
    prop.SetNumberOfElements(len(values))
    for i, value in enumerate(values):
        prop.SetElement(i, value)


class EveryProperty(unittest.TestCase):
    def test_comes_back(self):
        """All properties of all proxies, through the XML that a state is made of."""
        manager = servermanager.ProxyManager().SMProxyManager
        count = 0
        for group, name, element in plugin_xml.made_by_users():
            saved, loaded = manager.NewProxy(group, name), manager.NewProxy(group, name)
            names = [
                child.get("name") for child in plugin_xml.properties(element)
                if child.tag != "InputProperty" and not child.get("information_only")
            ]
            for prop in map(saved.GetProperty, names):
                default, value = elements(prop), another(prop)
                self.assertNotEqual(default, value, prop.GetXMLName())
                set_elements(prop, value)
            loaded.LoadXMLState(saved.SaveXMLState(None), None)
            for prop in names:
                values = [elements(proxy.GetProperty(prop)) for proxy in (saved, loaded)]
                self.assertEqual(*values, f"{name}.{prop}")
                count += 1
        self.assertGreater(count, 100)


if __name__ == "__main__":
    unittest.main()
