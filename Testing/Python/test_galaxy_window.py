"""The window used as a person does: opens galaxies, presses Apply and the plugin's buttons, changes the
display, saves screenshots and a state and loads it again.

ParaView plays the clicks (--test-script) in one window; the tests look at what it saved. What the
galaxy must look like is drawn by SplatImage, which shares only the engine with the window.
"""
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from xml.sax.saxutils import quoteattr

import numpy as np
from paraview import simple
from PIL import Image

import galaxy_pictures as gp
import galaxy_testing as gt

PATIENCE = 150  # seconds for the whole session
MAIN = "pqClientMainWindow/"
DISPLAY = (MAIN + "propertiesDock/propertiesPanel/scrollArea/qt_scrollarea_viewport/"
           "scrollAreaWidgetContents/DisplayFrame/ProxyPanel/")

# What the display is told before the state is saved.
RED_STARS = {"ComponentVisibility": ["gas", "0", "dust", "0"], "ComponentBrightness": ["stars", "3"],
             "ComponentColor": ["stars", "1", "0", "0"]}


def fewer_particles(path):
    """M83 with a twentieth of its particles."""
    with open(gt.M83, encoding="utf-8") as file:
        text = file.read()
    home = os.path.dirname(gt.M83)
    text = re.sub(r'"(images/[^"]*|m83\.rings)"', lambda m: f'"{home}/{m[1]}"', text)
    text = re.sub(r"^particles = (\d+)", lambda m: f"particles = {int(m[1]) // 20}", text, flags=re.M)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def plugin_with_example(folder):
    """Puts the plugin into a folder, and as its example M83 with fewer particles."""
    m83 = os.path.join(folder, "Examples", "M83")
    os.makedirs(m83)
    fewer_particles(os.path.join(m83, "m83.galaxy"))
    os.symlink(os.path.join(os.path.dirname(gt.M83), "images"), os.path.join(m83, "images"))
    os.symlink(os.environ["GALAXY_PLUGIN"], os.path.join(folder, "GalaxyReconstruction.so"))
    return folder


class Clicks:
    """What a person does, as ParaView plays it."""

    def __init__(self, folder):
        self.folder = folder
        self.events = []

    def add(self, widget, command, argument="", window=MAIN):
        self.events.append(f"<pqevent object={quoteattr(window + widget)} "
                           f'command="{command}" arguments={quoteattr(argument)}/>')

    def menu(self, menu, action):
        self.add(menu, "activate", action)

    def open(self, path):
        self.menu("menubar/menu_File", "actionFileOpen")
        self.files("FileOpenDialog", path)

    def button(self, name):
        self.add(name, "activate")

    def files(self, dialog, path):
        self.add(dialog, "filesSelected", path)

    def display(self, name, command, argument):
        self.add(DISPLAY[len(MAIN):] + name, command, argument)

    def color(self, name, rgb):
        button = DISPLAY[len(MAIN):] + name
        self.button(button)
        self.add(button + "/1QColorDialog0", "setChosenColor", rgb)
        self.add(button + "/1QColorDialog0", "done", "1")

    def eye(self, place):
        """Clicks into the pipeline browser: `place` is a row and column of each level."""
        for command in ("mousePress", "mouseRelease"):
            self.add("pipelineBrowserDock/pipelineBrowser", command, f"1,1,0,8,8,{place}")

    def save_state(self, name):
        self.menu("menubar/menu_File", "actionFileSaveServerState")
        self.files("FileSaveServerStateDialog", os.path.join(self.folder, name))

    def load_state(self, name):
        self.menu("menubar/menu_File", "actionFileLoadServerState")
        self.files("FileLoadServerStateDialog", os.path.join(self.folder, name))
        self.add("widget/OKButton", "activate", window="LoadStateOptionsDialog/")

    def reset(self):
        self.menu("menubar/menu_Edit", "actionDelete_All")
        self.button("CoreUtilitiesPromptUser/qt_msgbox_buttonbox/1QPushButton0")

    def check(self, row, shown):
        """The play fails unless this row of the display's panel is shown, or not."""
        self.events.append(f'<pqcheck object={quoteattr(DISPLAY + row)} property="visible" '
                           f'arguments="{str(shown).lower()}"/>')

    def screenshot(self, name):
        self.menu("menubar/menu_File", "actionFileSaveScreenshot")
        self.files("SaveScreenshotFileDialog", os.path.join(self.folder, name + ".png"))
        self.button("SaveScreenshotDialog/widget/OKButton")

    def save(self):
        path = os.path.join(self.folder, "clicks.xml")
        with open(path, "w", encoding="utf-8") as file:
            file.write("<pqevents>\n" + "\n".join(self.events) + "\n</pqevents>\n")
        return path


def clicks(folder, galaxy):
    person = Clicks(folder)
    person.open(galaxy)
    person.button("propertiesDock/propertiesPanel/Accept")
    person.screenshot("earth")
    person.display("Exposure/DoubleRangeWidget/DoubleLineEdit", "set_string", "0.4")
    person.screenshot("dim")
    person.display("GalaxyComponents/Visible gas", "set_boolean", "false")
    person.screenshot("no gas")
    person.display("GalaxyComponents/Visible dust", "set_boolean", "false")
    person.screenshot("no dust")
    person.display("GalaxyComponents/Brightness stars", "set_double", "3")
    person.screenshot("bright stars")
    person.color("GalaxyComponents/Color stars", "255,0,0")
    person.screenshot("red stars")
    person.button("GalaxyToolBar/galaxy-edge-on")
    person.screenshot("edge-on")
    person.menu("menubar/menu_Edit", "actionEditCameraUndo")
    person.screenshot("undone")
    person.menu("galaxy-earth-as", "galaxy-earth-as-fuv")
    person.menu("GalaxyToolBar/galaxy-earth-as", "galaxy-earth-as-hi_low")
    person.eye("/0:0/0:0/0:1")
    person.screenshot("hidden")
    person.eye("/0:0/0:0/0:1")
    person.screenshot("shown")
    person.menu("Galaxy", "galaxy-face-on")
    person.screenshot("saved")
    person.save_state("window.pvsm")
    person.reset()
    person.screenshot("reset")
    person.load_state("window.pvsm")
    person.screenshot("loaded")
    person.reset()
    person.menu("galaxy-examples", "M83")
    person.screenshot("example")
    person.reset()
    person.menu("Galaxy", "galaxy-open")
    person.files("FileOpenDialog", galaxy)
    person.button("propertiesDock/propertiesPanel/Accept")
    person.screenshot("opened")
    for representation in ("Splats", "Points"):
        person.display("Representation/displayRepresentationWidget/comboBox", "set_string", representation)
        for row in ("Opacity", "Specular", "Look", "GalaxyComponents", "ScaleBar", "Accuracy"):
            person.check(row, (row in ("Opacity", "Specular")) == (representation == "Points"))
    person.display("Representation/displayRepresentationWidget/comboBox", "set_string", "Splats")
    person.button("propertiesDock/propertiesPanel/SearchBox/AdvancedButton")
    person.check("Diffuse", False)
    person.check("ActiveEffects/Text", True)
    return person.save()


def use_window(folder):
    """Plays the clicks in a window; its log."""
    plugins = plugin_with_example(os.path.join(folder, "plugins"))
    galaxy = fewer_particles(os.path.join(folder, "m83 small.galaxy"))
    with open(os.path.join(folder, "window.log"), "w+", encoding="utf-8") as log:
        window = subprocess.run(
            ["paraview", "--dr", "--exit", "--plugins=GalaxyReconstruction",
             "--plugin-search-paths=" + plugins,
             "--script=" + os.path.join(os.path.dirname(os.path.abspath(__file__)), "window_spy.py"),
             "--test-script=" + clicks(folder, galaxy)],
            env=dict(os.environ, HOME=folder, GALAXY_WINDOW_NOTES=folder),
            stdout=log, stderr=log, timeout=PATIENCE, check=False)
        log.seek(0)
        return window.returncode, log.read()


class GalaxyWindow(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.code, cls.log = use_window(cls.folder)
        gt.load_plugin()
        reader = simple.GalaxyReader(FileName=os.path.join(cls.folder, "m83 small.galaxy"))
        cls.model = simple.GalaxyModel(Input=reader)
        cls.model.UpdatePipeline()

    def picture(self, name):
        """The saved screenshot without the corner with the axes, from 0 to 1."""
        path = os.path.join(self.folder, name + ".png")
        self.assertTrue(os.path.exists(path), f"no {name}.png; {self.log[-2000:]}")
        with Image.open(path) as image:
            pixels = np.asarray(image.convert("RGB"), dtype=float) / 255
        pixels[-len(pixels) // 4:, :len(pixels[0]) // 5] = 0
        return pixels

    def expected(self, like, camera, exposure, components):
        height, width = like.shape[:2]
        picture = simple.SplatImage(
            Input=self.model, ImageSize=[width, height], **camera, **components)
        picture.UpdatePipeline()
        radiance = gt.array(picture, "Radiance").reshape(height, width, 3)[::-1]
        pixels = np.asarray(gp.tone_map(radiance, exposure, stretch=10), dtype=float) / 255
        pixels[-height // 4:, :width // 5] = 0
        return pixels

    def assertShows(self, name, camera, exposure, **components):
        seen = self.picture(name)
        expected = self.expected(seen, gp.viewpoint(self.model, camera), exposure, components)
        self.assertGreater(expected.mean(), 0.02)
        difference = np.abs(seen - expected).mean() / expected.mean()
        self.assertLess(difference, 0.03, name)

    def notes(self):
        with open(os.path.join(self.folder, "pictures.json"), encoding="utf-8") as file:
            return [json.loads(line) for line in file]

    def cameras(self):
        """The names of the cameras that the pictures were drawn with, each as long as it stayed."""
        known = {name: gp.viewpoint(self.model, name)
                 for name in ("Earth", "FaceOn", "EdgeOn", "Earth:fuv", "Earth:hi_low")}
        names = []
        for shown in self.notes():
            for name, camera in known.items():
                if all(np.allclose(shown[key], camera[key], rtol=1e-6) for key in camera):
                    names += [] if names[-1:] == [name] else [name]
        return names

    def test_the_clicks_were_played_to_the_end(self):
        self.assertEqual(self.code, 0, self.log[-3000:])
        self.assertNotIn("ERR|", self.log)

    def test_an_opened_galaxy_is_built_and_seen_from_earth(self):
        self.assertEqual(self.notes()[-1]["sources"], ["GalaxyModel1", "m83 small.galaxy"])
        self.assertShows("earth", "Earth", 1)

    def test_exposure(self):
        self.assertShows("dim", "Earth", 0.4)

    def test_the_table_hides_components(self):
        self.assertShows("no gas", "Earth", 0.4, ComponentVisibility=["gas", "0"])
        self.assertShows("no dust", "Earth", 0.4, ComponentVisibility=["gas", "0", "dust", "0"])
        self.assertGreater(self.picture("no dust").sum(), 1.02 * self.picture("no gas").sum())

    def test_the_table_brightens_and_colours_a_component(self):
        self.assertShows("red stars", "Earth", 0.4, **RED_STARS)
        bright, red = (self.picture(name).sum(axis=(0, 1)) for name in ("bright stars", "red stars"))
        self.assertGreater(bright.sum(), 1.05 * self.picture("no dust").sum())
        self.assertGreater(red[0] / red[1], 2 * bright[0] / bright[1])

    def test_the_eye_hides_and_shows(self):
        self.assertEqual(self.picture("hidden").max(), 0)
        self.assertGreater(self.picture("shown").max(), 0.5)

    def test_a_state_brings_the_picture_back(self):
        self.assertShows("saved", "FaceOn", 0.4, **RED_STARS)
        self.assertGreater(self.picture("reset")[0].min(), 0.1)  # ParaView's own background
        np.testing.assert_allclose(self.picture("loaded"), self.picture("saved"), atol=0.02)

    def test_an_example_and_the_menus_open_show_what_file_open_does(self):
        for name in ("example", "opened"):
            np.testing.assert_allclose(self.picture(name), self.picture("earth"), atol=0.02)

    def test_edge_on_the_disc_is_flat(self):
        light = self.picture("edge-on").sum(axis=2)
        y, x = np.mgrid[:light.shape[0], :light.shape[1]]
        across, upward = (
            np.sqrt(np.average((v - np.average(v, weights=light)) ** 2, weights=light))
            for v in (x, y))
        self.assertLess(upward, 0.35 * across)

    def test_the_cameras_follow_the_buttons_the_menus_and_undo(self):
        self.assertEqual(
            self.cameras(), ["Earth", "EdgeOn", "Earth", "Earth:fuv", "Earth:hi_low", "FaceOn"])
        np.testing.assert_allclose(
            self.picture("undone"), self.picture("red stars"), atol=0.02)

    def test_the_trace_holds_what_was_done(self):
        with open(os.path.join(self.folder, "trace.py"), encoding="utf-8") as file:
            trace = file.read()
        self.assertIn("GalaxyReader(", trace)
        self.assertIn("GalaxyModel(", trace)
        self.assertIn("ComponentVisibility = ['dust', '0', 'gas', '0']", trace)
        positions = re.findall(r"CameraPosition = \[(.*)\]", trace)
        for name in ("Earth", "EdgeOn"):
            wanted = gp.viewpoint(self.model, name)["CameraPosition"]
            self.assertTrue(any(np.allclose([float(v) for v in p.split(",")], wanted)
                                for p in positions), f"{name}: {positions}")


if __name__ == "__main__":
    if not shutil.which("paraview"):
        gt.skip("paraview is not installed")
    unittest.main(verbosity=2)
