"""The movies of Examples as users make them: by pvbatch, stopped, gone on with, changed."""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np
from PIL import Image

import galaxy_movie as gm
import galaxy_testing as gt

PVBATCH = shutil.which("pvbatch")
if not PVBATCH:
    gt.skip("pvbatch is not installed")
FRAMES = 3
SMALL = ["--frames", str(FRAMES), "--size", "64x48", "--particle-scale", "0.005"]


class Movies(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def run_script(self, name, *arguments):
        script = os.path.join(gt.ROOT, "Examples", name)
        result = subprocess.run(
            [PVBATCH, script, self.folder, *SMALL, *arguments], capture_output=True, text=True,
            timeout=120, stdin=subprocess.DEVNULL)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def path(self, k):
        return os.path.join(self.folder, f"frame-{k:05d}.png")

    def written(self):
        """When each frame was written."""
        return [os.stat(self.path(k)).st_mtime_ns for k in range(FRAMES)]

    def check_frames(self, size):
        names = [name for name in os.listdir(self.folder) if name.endswith(".png")]
        self.assertEqual(len(names), FRAMES)
        frames = [np.asarray(Image.open(self.path(k)), dtype=float) for k in range(FRAMES)]
        for frame in frames:
            self.assertEqual(frame.shape, (size[1], size[0], 3))
            self.assertGreater(frame.max(), 100)
        self.assertGreater(np.abs(frames[0] - frames[-1]).mean(), 1)

    def check_video(self, name):
        if shutil.which("ffmpeg"):
            self.assertGreater(os.path.getsize(os.path.join(self.folder, name)), 500)

    def test_an_orbit_goes_on_where_it_was(self):
        text = self.run_script("movie_orbit.py")
        self.assertIn(f"frame {FRAMES} of {FRAMES}: ", text)
        self.assertIn("min", text)
        self.check_frames((64, 48))
        self.check_video("m83-orbit.mp4")
        before = self.written()
        os.remove(self.path(1))
        text = self.run_script("movie_orbit.py")
        self.assertIn(f"{FRAMES - 1} of {FRAMES} frames are there already", text)
        after = self.written()
        self.assertEqual((before[0], before[2]), (after[0], after[2]))
        self.assertGreater(after[1], before[1])

    def test_a_flight_through(self):
        self.run_script("movie_flythrough.py")
        self.check_frames((64, 48))
        self.check_video("m83-flythrough.mp4")

    def test_a_flight_for_a_dome(self):
        self.run_script("movie_flythrough.py", "--dome", "--size", "48x48")
        self.check_frames((48, 48))
        for k in range(FRAMES):
            frame = np.asarray(Image.open(self.path(k)))
            self.assertEqual(frame[:6, :6].max(), 0)  # outside of the circle

    def test_a_zoom(self):
        self.run_script("movie_zoom.py")
        self.check_frames((64, 48))
        self.check_video("m83-group-zoom.mp4")


class Parts(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def test_a_frame_is_whole_or_not_there(self):
        class Broken:
            def save(self, path, _):
                with open(path, "w", encoding="utf-8") as file:
                    file.write("half a")
                raise KeyboardInterrupt

        movie = gm.Movie(self.folder, {}, [{"CameraViewAngle": 30.0}])
        with self.assertRaises(KeyboardInterrupt):
            movie.draw(lambda: lambda camera: Broken())
        self.assertEqual(os.listdir(self.folder), ["movie.json"])

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_a_folder_may_have_any_name(self):
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        image = Image.new("RGB", (16, 16), "white")
        for name in ("100%", "%05d", "a:b", "http:x", "[ab]*?", "two\nlines", "-y",
                     os.path.join(self.folder, "at %d:x")):
            for _ in range(2):  # what is there is found again
                movie = gm.Movie(name, {}, [{"CameraViewAngle": 30.0}] * 2)
                movie.draw(lambda: lambda _: image)
                self.assertEqual(movie.missing(), [])
            video = movie.encode("video.mp4", 25)
            self.assertGreater(os.path.getsize(video), 500, name)
            self.assertEqual(sorted(os.listdir(name)), [
                "frame-00000.png", "frame-00001.png", "movie.json", "video.mp4"])
            movie = gm.Movie(name, {"scene": "another"}, [])
            self.assertEqual(sorted(os.listdir(name)), ["movie.json", "video.mp4"])

    def test_an_ffmpeg_that_cannot_is_told_of_before_frames_are_drawn(self):
        false = os.path.join(self.folder, "ffmpeg")
        with open(false, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\nexit 1\n")
        os.chmod(false, 0o755)
        movie = gm.Movie(os.path.join(self.folder, "movie"), {}, [{"CameraViewAngle": 30.0}])
        with unittest.mock.patch.dict(os.environ, PATH=self.folder + ":" + os.environ["PATH"]):
            with self.assertRaises(SystemExit) as refused:
                movie.draw(self.fail)
        self.assertIn("libx264", str(refused.exception))
        self.assertEqual(os.listdir(movie.folder), ["movie.json"])

    def test_what_a_killed_script_has_left_goes(self):
        with open(os.path.join(self.folder, ".frame-00003.png.part"), "w", encoding="utf-8"):
            pass
        gm.Movie(self.folder, {}, [])
        self.assertEqual(os.listdir(self.folder), ["movie.json"])

    def test_without_ffmpeg_the_frames_are_all(self):
        movie = gm.Movie(self.folder, {}, [])
        with unittest.mock.patch.dict(os.environ, PATH=self.folder):
            self.assertIsNone(movie.encode("video.mp4", 25))
        self.assertEqual(os.listdir(self.folder), ["movie.json"])

    def test_numbers_that_are_none_are_refused(self):
        for size in ("64", "axb", "0x9"):
            with self.assertRaises(SystemExit) as refused:
                gm.size_of(size)
            self.assertIn(size, str(refused.exception))
        with self.assertRaises(SystemExit):
            gm.times(0)
        for rate in ("0", "-25", "nan", "inf", "x"):
            with self.assertRaises(ValueError):
                gm.positive(rate)

    def test_another_path_starts_over(self):
        camera = {"CameraViewAngle": 30.0}
        image = Image.new("RGB", (2, 2))
        gm.Movie(self.folder, {"scene": 1}, [camera]).draw(lambda: lambda _: image)
        self.assertEqual(gm.Movie(self.folder, {"scene": 1}, [camera]).missing(), [])
        self.assertEqual(gm.Movie(self.folder, {"scene": 2}, [camera]).missing(), [0])
        with open(os.path.join(self.folder, "movie.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["scene"], {"scene": 2})

    def test_a_path_is_smooth_and_meets_its_keys(self):
        places = np.array([[0, 0, 10], [3, 1, 6], [5, 0, 2], [4, -2, 1]], dtype=float)
        keys = [(k / 3, {"CameraPosition": list(place), "CameraFocalPoint": [0, 0, 0],
                         "CameraViewUp": [0, 1, 0], "CameraViewAngle": 30.0})
                for k, place in enumerate(places)]
        for time, key in keys:
            np.testing.assert_allclose(
                gm.along(keys, time)["CameraPosition"], key["CameraPosition"], atol=1e-9)
        steps = np.linspace(0, 1, 601)
        path = np.array([gm.along(keys, t)["CameraPosition"] for t in steps])
        speed = np.linalg.norm(np.diff(path, axis=0), axis=1) / steps[1]
        self.assertLess(np.abs(np.diff(speed)).max(), 0.05 * speed.max())  # no kink at a key

    def test_ahead_is_at_the_front_of_a_dome(self):
        view = gm.dome({"CameraPosition": [0, 0, 5], "CameraFocalPoint": [0, 0, 0],
                        "CameraViewUp": [0, 1, 0], "CameraViewAngle": 30.0}, tilt=60)
        zenith = np.array(view["CameraFocalPoint"]) - view["CameraPosition"]
        ahead = np.array([0, 0, -1.0])
        self.assertAlmostEqual(zenith.dot(ahead) / 5, 0.5)
        self.assertGreater(zenith[1], 0)
        self.assertLess(np.dot(view["CameraViewUp"], ahead), 0)  # ahead is down in the picture


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
