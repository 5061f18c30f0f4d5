"""Several MPI processes have, show and write what one does. Needs a display and mpirun."""
import json
import os
import re
import shutil
import subprocess
import unittest

import numpy as np
from PIL import Image

import galaxy_testing as gt

PICTURES = ("model", "before_green", "translucent", "parts", "copies")
FILES = ("image.fits", "parts.fits", "particles.g2", "parts.g2")
# Not as processes of this one, which is of MPI too.
ENVIRONMENT = {name: value for name, value in os.environ.items()
               if not name.startswith(("OMPI_", "PMIX_", "PRTE_", "ORTE_"))}
ENVIRONMENT.update(OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                   OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
SCENE = os.path.join(gt.ROOT, "Testing", "Python", "parallel_scene.py")
DATA = os.path.join(gt.ROOT, "Testing", "Python", "parallel_data.py")


def on_processes(count):
    return ["mpirun", "--oversubscribe", "-np", str(count)] if count > 1 else []


def run(name, script, *program, more=()):
    """The folder that the script, run by the program, has filled."""
    folder = os.path.join(gt.output_folder(), "parallel-" + name)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    done = subprocess.run([*program, script, folder, *more], env=ENVIRONMENT, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=200)
    assert done.returncode == 0, done.stdout[-3000:]
    return folder


class Pictures:
    """What parallel_scene.py draws."""

    def __init__(self, name, *program, port=None):
        folder = run(name, SCENE, *program, more=[port] if port else [])
        with open(os.path.join(folder, "statistics.txt")) as text:
            self.effects, self.statistics = text.read().splitlines()
        self.pictures = {}
        for name in PICTURES:
            with Image.open(os.path.join(folder, name + ".png")) as image:
                self.pictures[name] = np.asarray(image.convert("RGB"), dtype=float)

    def __getitem__(self, name):
        return self.pictures[name]


def count(name, processes):
    """What parallel_data.py counts, and the files it writes."""
    folder = run(name, DATA, *on_processes(processes), "pvbatch")
    with open(os.path.join(folder, "data.json")) as file:
        results = json.load(file)
    for name in FILES:
        with open(os.path.join(folder, name), "rb") as file:
            results[name] = file.read()
    return results


@unittest.skipUnless(shutil.which("mpirun"), "mpirun is not installed")
class Parallel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.one = Pictures("one", "pvbatch")

    def is_as_of_one(self, several):
        for name in PICTURES:
            self.assertGreater(self.one[name].mean(), 25, name)
            difference = np.abs(several[name] - self.one[name]).max(axis=2)
            # On the rim of the ball, whose depth falls steeply, the last bit of a depth may show;
            # what is translucent ParaView rounds on each process.
            most = {"parts": 1, "copies": 1, "translucent": 8}.get(name, 3)
            self.assertLessEqual(difference.max(), most, name)
            few = 0.02 if name == "translucent" else 5e-4
            self.assertLess((difference > 1).mean(), few, name)
            self.assertLess(difference.mean(), 0.05, name)
        self.assertEqual(several.effects, self.one.effects)
        drawn = "[0-9]+ particles drawn"
        self.assertEqual(re.match(drawn, several.statistics)[0],
                         re.match(drawn, self.one.statistics)[0])

    def test_the_scene_tells_its_pictures_apart(self):
        for one, other in (("model", "before_green"), ("before_green", "translucent"),
                           ("model", "parts")):
            self.assertGreater(np.abs(self.one[one] - self.one[other]).mean(), 2)
        np.testing.assert_array_equal(self.one["parts"], self.one["copies"])

    def test_two_and_three_processes(self):
        self.is_as_of_one(Pictures("of-two", *on_processes(2), "pvbatch"))
        self.is_as_of_one(Pictures("of-three", *on_processes(3), "pvbatch", "--sym"))

    def test_a_server_shows_and_tells_its_client_the_same(self):
        server = subprocess.Popen([*on_processes(2), "pvserver", "--server-port=0"], text=True,
                                  env=ENVIRONMENT, stdout=subprocess.PIPE)
        try:
            line = ""
            while "Accepting" not in line and server.poll() is None:
                line = server.stdout.readline()
            port = re.search(r":(\d+)", line).group(1)
            self.is_as_of_one(Pictures("server", "pvpython", port=port))
        finally:
            server.terminate()
            server.wait()
            server.stdout.close()

    def test_every_particle_is_there_and_written_once(self):
        one = count("data-one", 1)
        self.assertEqual(one["rows"], one["model"])
        self.assertEqual(one["model histogram"], one["model"])
        self.assertEqual(one["image"], 60 * 50)
        self.assertEqual(one["parts"], 900)
        several = count("data-three", 3)
        for name, value in one.items():
            self.assertEqual(several[name], value, name)


if __name__ == "__main__":
    unittest.main()
