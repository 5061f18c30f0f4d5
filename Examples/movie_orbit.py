"""A movie around M83: once around the disc, from face-on down to edge-on and up again.

Usage: pvbatch Examples/movie_orbit.py OUTPUT_FOLDER [--frames 300] [--size 1280x720] ...
Needs the mock images of M83: Examples/M83/images.sh makes them. Stopped, it goes on when run again.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import galaxy_movie as gm
import galaxy_pictures as gp
import numpy as np

M83 = os.path.join(gm.HERE, "M83")
EXPOSURE = 0.5
HALF_HEIGHT = 9.0  # kpc


def cameras(axes, frames):
    """The last frame is the one before the first, so that the video runs in a circle."""
    result = []
    for k in range(frames):
        turn = k / frames
        tilt = 45 - 45 * np.cos(2 * np.pi * turn)  # 0 face-on, 90 edge-on
        result.append(gp.orbit_camera(axes, tilt, 60 + 360 * turn, HALF_HEIGHT))
    return result


def main():
    options = gm.arguments(__doc__, 300, "1280x720").parse_args()
    size = gm.size_of(options.size)
    gp.load_plugin()
    model = gp.build_galaxy(os.path.join(M83, "m83.galaxy"), options.particle_scale)
    path = cameras(gp.disk_axes(model), len(gm.times(options.frames)))
    scene = {"size": size, "particle scale": options.particle_scale,
             "files": gm.digest(M83, __file__)}
    movie = gm.Movie(options.folder, scene, path)
    movie.draw(lambda: gm.Painter(model, size, EXPOSURE, hidden=("gas",)))
    movie.encode("m83-orbit.mp4", options.rate)


if __name__ == "__main__":
    main()
