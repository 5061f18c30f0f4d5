"""The benchmark of the model at a fiftieth of its particles: its numbers are consistent."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))


def benchmark(folder, *options):
    """What bench_model.py prints, and its JSON."""
    path = os.path.join(folder, "model.json")
    done = subprocess.run(
        [sys.executable, os.path.join(HERE, "bench_model.py"), "--json", path, *options],
        capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(done.stdout + done.stderr)
    with open(path, encoding="utf-8") as file:
        return done.stdout, json.load(file)


class BenchModel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            cls.printed, cls.results = benchmark(folder, "--scale", "0.02", "--threads", "1,2")

    def test_the_components_particles_add_up(self):
        for run in self.results["runs"]:
            self.assertEqual(sum(c["particles"] for c in run["components"]), run["particles"])
            self.assertGreater(run["particles"], 10000)

    def test_the_printed_table_adds_up(self):
        lines = self.printed.splitlines()
        first = next(k for k, line in enumerate(lines) if line.startswith("component "))
        heads = lines[first].split()
        from_right = heads.index("particles") - len(heads)  # names may have blanks
        rows = [line.split() for line in lines[first + 1:lines.index("", first)]]
        counts = [int(row[from_right].replace(",", "")) for row in rows]
        self.assertEqual(rows[-1][0], "all")
        self.assertEqual(sum(counts[:-1]), counts[-1])
        self.assertEqual(counts[-1], self.results["runs"][-1]["particles"])

    def test_the_phases_memory_is_printed(self):
        run = self.results["runs"][-1]
        lines = self.printed.splitlines()
        first = next(k for k, line in enumerate(lines) if line.startswith("phase "))
        self.assertTrue(lines[first].endswith("memory at its end"))
        printed = [float(line.split()[-2]) for line in lines[first + 1:first + 5]]
        held = [phase["memory"] for phase in run["phases"]]
        self.assertEqual([phase["phase"] for phase in run["phases"]],
                         ["paraview", "plugin", "read", "model"])
        for shown, size in zip(printed, held):
            self.assertAlmostEqual(shown, size / 1e6, delta=0.051)
        self.assertLess(held[1], held[3])  # which holds the images and the particles
        self.assertLessEqual(max(held), run["peak"])

    def test_a_particle_takes_24_bytes(self):
        for run in self.results["runs"]:
            self.assertEqual(run["model_bytes"], 24 * run["particles"])
            self.assertEqual(sum(run["arrays"].values()), run["model_bytes"])

    def test_the_peak_holds_the_process_and_the_model(self):
        for run in self.results["runs"]:
            self.assertGreater(run["peak_above_baseline"], 0.9 * run["model_bytes"])
            sampled = max(size for _, size in run["memory"])
            self.assertGreater(sampled, run["baseline"])
            self.assertLess(sampled, 1.02 * run["peak"])

    def test_the_number_of_threads_changes_no_count(self):
        counts = [[(c["seeds_kept"], c["particles"], c["filled"]) for c in run["components"]]
                  for run in self.results["runs"]]
        self.assertEqual(counts[0], counts[1])

    def test_stages_lie_within_the_model(self):
        for run in self.results["runs"]:
            stages = sum(sum(c["seconds"].values()) for c in run["components"])
            self.assertLessEqual(stages, run["seconds"]["model"])


if __name__ == "__main__":
    unittest.main()
