"""What the movies share: a smooth path of the camera, frames that survive an interruption, a video.

Frames are PNG files in a folder. One that is there is not drawn again, and none is there by half,
so that a script that was stopped goes on where it was. What the frames show is kept beside them in
movie.json: where the scene, the path or the script is another, all are drawn anew.
"""
import argparse
import glob
import hashlib
import json
import os
import shutil
import subprocess
import time

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkCamera, vtkCameraInterpolator

import galaxy_pictures as gp

HERE = os.path.dirname(os.path.abspath(__file__))
CAMERA = {  # a camera's properties as SplatImage and ParaView's views name them, and as VTK does
    "CameraPosition": "Position",
    "CameraFocalPoint": "FocalPoint",
    "CameraViewUp": "ViewUp",
    "CameraViewAngle": "ViewAngle",
}


def arguments(documentation, frames, size):
    """The command line of a movie: its folder and how many frames of what size."""
    parser = argparse.ArgumentParser(
        description=documentation, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="where the frames and the video go")
    parser.add_argument("--frames", type=int, default=frames, help=f"default {frames}")
    parser.add_argument("--size", default=size, help=f"WIDTHxHEIGHT in pixels, default {size}")
    parser.add_argument("--rate", type=positive, default=25, help="frames a second, default 25")
    parser.add_argument("--particle-scale", type=float, default=1, help="default 1")
    return parser


def positive(text):
    """A finite number above 0, for argparse."""
    number = float(text)
    if not 0 < number < float("inf"):
        raise ValueError(text)
    return number


def size_of(text):
    """[width, height] of WIDTHxHEIGHT."""
    try:
        width, height = (int(number) for number in text.lower().split("x"))
    except ValueError:
        width = height = 0
    if width < 1 or height < 1:
        raise SystemExit(f"--size {text}: must be WIDTHxHEIGHT, such as 1280x720")
    return [width, height]


def times(frames):
    """The time of each frame, from 0 to 1."""
    if frames < 1:
        raise SystemExit(f"--frames {frames}: must be at least 1")
    return [k / max(1, frames - 1) for k in range(frames)]


def ease(t):
    """From 0 to 1, slow at both ends."""
    return t * t * (3 - 2 * t)


def along(keys, t):
    """The camera at the time t of a path through `keys`, pairs of a time and a camera.

    The interpolation is that of ParaView's camera animations: splines through position, focal point,
    view up and view angle.
    """
    path = vtkCameraInterpolator()
    path.SetInterpolationTypeToSpline()
    for time_of_key, key in keys:
        camera = vtkCamera()
        for name, method in CAMERA.items():
            getattr(camera, "Set" + method)(key[name])
        path.AddCamera(time_of_key, camera)
    camera = vtkCamera()
    path.InterpolateCamera(t, camera)
    result = {name: getattr(camera, "Get" + method)() for name, method in CAMERA.items()}
    return {name: list(v) if isinstance(v, tuple) else v for name, v in result.items()}


def dome(camera, tilt=60.0):
    """The fulldome view of a camera, for SplatImage's Projection Dome.

    Ahead lies `tilt` degrees from the zenith toward the bottom of the picture, the dome's front.
    """
    eye, at = np.array(camera["CameraPosition"]), np.array(camera["CameraFocalPoint"])
    ahead = (at - eye) / np.linalg.norm(at - eye)
    up = np.array(camera["CameraViewUp"])
    up = up - up.dot(ahead) * ahead
    up /= np.linalg.norm(up)
    zenith = np.cos(np.radians(tilt)) * ahead + np.sin(np.radians(tilt)) * up
    return {
        "CameraPosition": list(eye),
        "CameraFocalPoint": list(eye + np.linalg.norm(at - eye) * zenith),
        "CameraViewUp": list(-ahead),
        "Projection": "Dome",
    }


def digest(*paths):
    """What files hold, folders with all that is in them, as a short text."""
    total = hashlib.sha256()
    for path in paths:
        inside = sorted(glob.glob(os.path.join(glob.escape(path), "**"), recursive=True))
        for file in inside if os.path.isdir(path) else [path]:
            if os.path.isfile(file) and "__pycache__" not in file:
                with open(file, "rb") as stream:
                    total.update(os.path.basename(file).encode() + hashlib.sha256(
                        stream.read()).digest())
    return total.hexdigest()[:16]


class Painter:
    """Draws particles by one SplatImage, which keeps its memory from frame to frame."""

    def __init__(self, particles, size, exposure, stretch=8.0, hidden=()):
        self.size, self.exposure, self.stretch = size, exposure, stretch
        self.picture = simple.SplatImage(Input=particles, ImageSize=size, White=1 / exposure)
        self.picture.ComponentVisibility = [item for name in hidden for item in (name, "0")]

    def __call__(self, camera):
        for name, value in camera.items():
            self.picture.SetPropertyWithName(name, value)
        self.picture.UpdatePipeline()
        arrays = servermanager.Fetch(self.picture).GetPointData()
        radiance = vtk_to_numpy(arrays.GetArray("Radiance"))
        radiance = radiance.reshape(self.size[1], self.size[0], 3)[::-1]
        return gp.tone_map(radiance, self.exposure, self.stretch)


class Movie:
    """Frames in a folder."""

    def __init__(self, folder, scene, cameras):
        """`scene` says, with what JSON knows, all that the frames show besides the cameras."""
        self.folder, self.cameras = folder, cameras
        scripts = digest(__file__, gp.__file__)
        self.about = {"scene": scene, "cameras": cameras, "shared scripts": scripts}
        os.makedirs(folder, exist_ok=True)
        for part in glob.glob(os.path.join(glob.escape(folder), ".*.part")):
            os.remove(part)  # of a script that was killed
        self._start_over_where_changed()

    def frame(self, k):
        return os.path.join(self.folder, f"frame-{k:05d}.png")

    def missing(self):
        return [k for k in range(len(self.cameras)) if not os.path.exists(self.frame(k))]

    def draw(self, painter):
        """Draws the frames that are missing. `painter()` makes what turns a camera into a picture;
        it is not called where all frames are there."""
        missing = self.missing()
        count = len(self.cameras)
        print(f"{count - len(missing)} of {count} frames are there already", flush=True)
        if not missing:
            return
        self._try_encoder()
        paint = painter()
        start = time.time()
        for done, k in enumerate(missing, 1):
            began = time.time()
            _whole(self.frame(k), lambda path, k=k: paint(self.cameras[k]).save(path, "PNG"))
            left = (time.time() - start) / done * (len(missing) - done)
            print(f"  frame {k + 1} of {count}: {time.time() - began:.1f} s, "
                  f"{left // 60:.0f} min {left % 60:.0f} s left", flush=True)

    def encode(self, name, rate):
        """A video of the frames by ffmpeg; its path, or None where there is no ffmpeg."""
        video = os.path.join(self.folder, name)
        if not shutil.which("ffmpeg"):
            print("No video: ffmpeg is not installed (apt install ffmpeg, then run this again).")
            return None
        frames = ["-framerate", str(rate), "-i", "file:frame-%05d.png"]
        _whole(video, lambda path: self._ffmpeg(frames, path))
        print("Video: " + video)
        return video

    def _ffmpeg(self, source, path):
        """Encodes what ffmpeg's options `source` say. It runs in the folder, so that no name of
        a folder can look to it like a pattern or a protocol."""
        even = "scale=trunc(iw/2)*2:trunc(ih/2)*2"  # what H.264 asks for
        subprocess.run(
            [os.path.abspath(shutil.which("ffmpeg")), "-y", "-v", "error", *source, "-vf", even,
             "-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-f", "mp4",
             "file:" + os.path.basename(path)],
            check=True, stdin=subprocess.DEVNULL, cwd=self.folder)

    def _try_encoder(self):
        """Says before the frames are drawn that no video of them can be made."""
        if not shutil.which("ffmpeg"):
            print("There will be no video: ffmpeg is not installed (apt install ffmpeg).")
            return
        trial = os.path.join(self.folder, ".trial.mp4.part")
        try:
            self._ffmpeg(["-f", "lavfi", "-i", "color=size=64x64:duration=0.1"], trial)
        except subprocess.CalledProcessError as error:
            raise SystemExit("ffmpeg cannot make a video (see above); install one that has libx264, "
                             "or take it from PATH for frames without a video") from error
        finally:
            if os.path.exists(trial):
                os.remove(trial)

    def _start_over_where_changed(self):
        path = os.path.join(self.folder, "movie.json")
        text = json.dumps(self.about, indent=1, sort_keys=True)
        frames = glob.glob(os.path.join(glob.escape(self.folder), "frame-*.png"))
        try:
            with open(path, encoding="utf-8") as file:
                same = file.read() == text
        except OSError:
            same = False
        if same:
            return
        if frames:
            print(f"The scene or the path has changed: {len(frames)} frames are drawn anew")
        for frame in frames:
            os.remove(frame)
        _whole(path, lambda part: _write_text(part, text))


def _write_text(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def _whole(path, write):
    """Writes a file under another name and puts it in its place when it is whole."""
    folder, name = os.path.split(path)
    part = os.path.join(folder, f".{name}.part")
    try:
        write(part)
        os.replace(part, path)
    finally:
        if os.path.exists(part):
            os.remove(part)
