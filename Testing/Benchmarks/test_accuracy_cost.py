"""The command that tells what accuracy costs runs, keeps its bounds, and says what it measured."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import accuracy_cost


class TestAccuracyCost(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.json = os.path.join(cls.folder.name, "cost.json")
        cls.table = os.path.join(cls.folder.name, "cost.md")
        cls.finished = subprocess.run(
            ["/usr/bin/python3", os.path.join(HERE, "accuracy_cost.py"), "--particles", "20000",
             "--size", "128", "--repeats", "1", "--bench", os.environ["GALAXY_BENCH_ACCURACY"],
             "--json", cls.json, "--table", cls.table], capture_output=True, text=True)
        if cls.finished.returncode == 0:
            with open(cls.json, encoding="utf-8") as file:
                cls.data = json.load(file)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def setUp(self):
        self.assertEqual(self.finished.returncode, 0, self.finished.stderr)

    def runs_of(self, level):
        return [r for r in self.data["runs"] if r["level"] == level and "error" in r]

    def test_every_level_is_there_on_five_scenes(self):
        for level in ("Sorted", "Bounded", "Preview"):
            scenes = {r["scene"] for r in self.runs_of(level) if "particles" not in r["scene"]}
            self.assertEqual(len(scenes), 5, level)

    def test_sorted_is_the_reference_to_1e_minus_5_of_white(self):
        for run in self.runs_of("Sorted"):
            if "particles" not in run["scene"]:  # there it is compared with Overlapping
                self.assertLess(run["error"], 1e-5, run)

    def test_no_bound_is_broken(self):
        self.assertEqual(accuracy_cost.broken(self.data), [])
        self.assertTrue(all("bound" in r for r in self.runs_of("Bounded")))

    def test_overlapping_converges_at_second_order(self):
        scenes = {r["scene"] for r in self.runs_of("Overlapping")}
        self.assertEqual(len(scenes), 2)
        for scene in scenes:
            errors = [r["rms"] for r in self.runs_of("Overlapping") if r["scene"] == scene]
            for coarse, fine in zip(errors[1:], errors[2:]):
                self.assertGreater(coarse / fine, 2.5, scene)

    def test_larger_samples_are_nearer(self):
        for scene in {r["scene"] for r in self.runs_of("Preview")}:
            errors = [r["rms"] for r in self.runs_of("Preview") if r["scene"] == scene]
            self.assertLess(errors[0], errors[3], scene)

    def test_the_table_has_a_line_for_each(self):
        with open(self.table, encoding="utf-8") as file:
            lines = file.read().splitlines()
        rows = [line for line in lines if line.startswith("| ") and "level" not in line]
        self.assertGreaterEqual(len(rows), len(self.data["runs"]))


if __name__ == "__main__":
    unittest.main()
