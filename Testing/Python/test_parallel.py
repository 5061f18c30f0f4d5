"""A view of several MPI processes shows what that of one does. Needs a display and mpirun."""
import os
import re
import shutil
import subprocess
import unittest

import numpy as np
from PIL import Image

import galaxy_testing as gt

PROCESSES = 3
# Not as processes of this one, which is of MPI too.
ENVIRONMENT = {name: value for name, value in os.environ.items()
               if not name.startswith(("OMPI_", "PMIX_", "PRTE_", "ORTE_"))}
ENVIRONMENT.update(OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                   OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
SCENE = os.path.join(gt.ROOT, "Testing", "Python", "parallel_scene.py")


def on_processes(count):
    return ["mpirun", "--oversubscribe", "-np", str(count)] if count > 1 else []


def draw(name, program, *port):
    """The pictures of the scene by their names."""
    folder = os.path.join(gt.output_folder(), "parallel-" + name)
    os.makedirs(folder, exist_ok=True)
    done = subprocess.run([*program, SCENE, folder, *port], env=ENVIRONMENT, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=200)
    assert done.returncode == 0, done.stdout[-3000:]
    pictures = {}
    for name in ("model", "before_green", "parts"):
        with Image.open(os.path.join(folder, name + ".png")) as image:
            pictures[name] = np.asarray(image.convert("RGB"), dtype=float) / 255
    return pictures


@unittest.skipUnless(shutil.which("mpirun"), "mpirun is not installed")
class Parallel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.one = draw("one", ["pvbatch"])
        cls.several = draw("several", [*on_processes(PROCESSES), "pvbatch"])

    def test_a_galaxy_that_each_process_has_is_drawn_once(self):
        self.assertGreater(self.one["model"].mean(), 0.1)
        np.testing.assert_allclose(self.several["model"], self.one["model"], atol=1.5 / 255)

    def test_particles_of_which_each_process_has_a_part_are_drawn_together(self):
        self.assertGreater(self.one["parts"].mean(), 0.1)
        np.testing.assert_allclose(self.several["parts"], self.one["parts"], atol=1.5 / 255)

    def test_the_background_is_seen_through_the_mean_transmittance(self):
        before_green = self.one["before_green"]
        self.assertGreater(np.abs(before_green - self.one["model"]).mean(), 0.02)
        np.testing.assert_allclose(self.several["before_green"], before_green, atol=5 / 255)

    def test_a_server_of_several_processes(self):
        server = subprocess.Popen([*on_processes(2), "pvserver", "--server-port=0"], text=True,
                                  env=ENVIRONMENT, stdout=subprocess.PIPE)
        try:
            line = ""
            while "Accepting" not in line and server.poll() is None:
                line = server.stdout.readline()
            pictures = draw("server", ["pvpython"], re.search(r":(\d+)", line).group(1))
        finally:
            server.terminate()
            server.wait()
            server.stdout.close()
        for name in ("model", "parts"):  # sent with less of their colours
            self.assertLess(np.abs(pictures[name] - self.one[name]).mean(), 3 / 255, name)


if __name__ == "__main__":
    unittest.main()
