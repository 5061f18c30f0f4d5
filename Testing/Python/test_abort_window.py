"""The Abort button of ParaView's window, pressed by a real mouse while the plugin works.

ParaView plays the clicks that begin the work (--test-script); xdotool presses Abort meanwhile, as
soon as the button is seen.
"""
import io
import json
import os
import shutil
import subprocess
import tempfile
import time
import unittest

import numpy as np
from PIL import Image

import galaxy_testing as gt
from test_galaxy_window import Clicks

PATIENCE = 200  # seconds for the whole session
APPLY = "propertiesDock/propertiesPanel/Accept"


SCREEN = (0, 0, 1280, 1024)


def photograph(left, top, width, height):
    """That part of the screen."""
    shot = subprocess.run(
        ["import", "-window", "root", "-crop", f"{width}x{height}+{left}+{top}", "-depth", "8", "ppm:-"],
        stdout=subprocess.PIPE, check=True, timeout=60).stdout
    with Image.open(io.BytesIO(shot)) as image:
        return np.asarray(image.convert("RGB"), dtype=int)


def status_bar():
    """Where the window ends, below which the screen is black."""
    lit = np.flatnonzero(photograph(*SCREEN).max(axis=2).any(axis=1))
    return (0, int(lit.max()) - 34, 1280, 35) if len(lit) else None


def abort_button(bar):
    """Where its red cross is in the status bar, if it is there; the bar itself is grey and blue."""
    picture = photograph(*bar)
    red = (picture[..., 0] > 190) & (picture[..., 1] < 80) & (picture[..., 2] < 80)
    rows, columns = np.nonzero(red)
    if len(rows) < 10:
        return None
    return bar[0] + int(np.median(columns)), bar[1] + int(np.median(rows))


def press(place):
    subprocess.run(["xdotool", "mousemove", *map(str, place), "click", "1"], check=True, timeout=60)


class AbortWindow(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.pressed = []
        cls.code, cls.log = cls.use_window()

    @classmethod
    def clicks(cls):
        person = Clicks(cls.folder)
        person.open(gt.M83)
        person.button(APPLY)  # aborted
        person.screenshot("aborted")
        person.button(APPLY)
        person.screenshot("built")
        # The first of these to be drawn when the button is there is aborted.
        for camera in ("edge-on", "face-on", "edge-on", "face-on", "edge-on"):
            person.button("GalaxyToolBar/galaxy-" + camera)
            person.screenshot(camera)
        return person.save()

    @classmethod
    def is_to_abort(cls):
        """Building the model, and later drawing it."""
        def shot(name):
            return os.path.exists(os.path.join(cls.folder, name + ".png"))
        if len(cls.pressed) == 0:
            return not shot("aborted")
        return shot("built") and not any(text.startswith("aborted") for text in cls.statistics())

    @classmethod
    def use_window(cls):
        plugin = os.environ["GALAXY_PLUGIN"]
        here = os.path.dirname(os.path.abspath(__file__))
        with open(os.path.join(cls.folder, "window.log"), "w+", encoding="utf-8") as log:
            window = subprocess.Popen(
                ["paraview", "--dr", "--exit", "--plugins=GalaxyReconstruction",
                 "--plugin-search-paths=" + os.path.dirname(plugin),
                 "--script=" + os.path.join(here, "abort_spy.py"), "--test-script=" + cls.clicks()],
                env=dict(os.environ, HOME=cls.folder, GALAXY_WINDOW_NOTES=cls.folder),
                stdout=log, stderr=log)
            try:
                start, bar = time.time(), None
                while window.poll() is None and time.time() - start < PATIENCE:
                    bar = bar if cls.pressed else status_bar()  # the window may grow yet
                    place = abort_button(bar) if bar and cls.is_to_abort() else None
                    if place:
                        press(place)
                        cls.pressed.append(place)
                    time.sleep(0.02)
            finally:
                window.kill()
                window.wait()
            log.seek(0)
            return window.returncode, log.read()

    @classmethod
    def statistics(cls):
        """What was drawn, a text a picture."""
        with open(os.path.join(cls.folder, "pictures.json"), encoding="utf-8") as file:
            return [json.loads(line) for line in file if line.endswith("\n")]

    def light(self, name):
        path = os.path.join(self.folder, name + ".png")
        self.assertTrue(os.path.exists(path), f"no {name}.png; {self.log[-2000:]}")
        with Image.open(path) as image:
            pixels = np.asarray(image.convert("RGB"), dtype=float) / 255
        return pixels[:len(pixels) * 3 // 4].std()

    def test_the_clicks_were_played_to_the_end(self):
        self.assertEqual(self.code, 0, self.log[-3000:])
        self.assertNotIn("ERR|", self.log)

    def test_a_model_that_was_aborted_is_not_there_and_built_by_the_next_apply(self):
        self.assertLess(self.light("aborted"), 0.01)
        self.assertGreater(self.light("built"), 0.03)

    def test_a_picture_that_was_aborted_is_a_preview_and_saved_whole(self):
        statistics = self.statistics()
        aborted = [text for text in statistics if text.startswith("aborted; ")]
        self.assertGreaterEqual(len(aborted), 1, statistics)
        self.assertIn("stand for all", aborted[0])
        later = statistics[statistics.index(aborted[-1]) + 1:]
        self.assertTrue(any("stand for all" not in text for text in later), later)
        self.assertGreater(self.light("edge-on"), 0.03)


if __name__ == "__main__":
    for tool in ("paraview", "import", "xdotool"):
        if not shutil.which(tool):
            gt.skip(f"{tool} is not installed")
    unittest.main(verbosity=2)
