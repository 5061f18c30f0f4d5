"""A movie from the whole M83 group into M83: every second nearer by the same factor.

Usage: pvbatch Examples/movie_zoom.py OUTPUT_FOLDER [--frames 300] [--size 1280x720] ...
Needs the mock images of M83: Examples/M83/images.sh makes them. Stopped, it goes on when run again.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import galaxy_movie as gm
import galaxy_pictures as gp
import numpy as np
from paraview import simple

GROUP = os.path.join(gm.HERE, "M83Group")
GAPS = 0.6  # factor on the distances between the galaxies
EXPOSURE = 0.5
HALF_HEIGHTS = 300.0, 7.0  # kpc, at the beginning and at the end
DIRECTIONS = (1.0, 0.15, 0.35), (0.25, -0.55, 0.8)  # of the eye (X West, Y North, Z to Earth)
VIEW_ANGLE = 30.0


def camera(t):
    """At the time t, from 0 to 1."""
    near = gm.ease(t)
    half_height = HALF_HEIGHTS[0] * (HALF_HEIGHTS[1] / HALF_HEIGHTS[0]) ** near
    direction = (1 - near) * np.array(DIRECTIONS[0]) + near * np.array(DIRECTIONS[1])
    distance = half_height / np.tan(np.radians(VIEW_ANGLE / 2))
    return {
        "CameraPosition": list(distance * direction / np.linalg.norm(direction)),
        "CameraFocalPoint": [0.0, 0.0, 0.0],
        "CameraViewUp": [0.0, 1.0, 0.0],
        "CameraViewAngle": VIEW_ANGLE,
    }


def build(particle_scale):
    group = simple.GalaxyGroup(FileName=os.path.join(GROUP, "m83group.galaxygroup"),
                               Separation=GAPS, ParticleScale=particle_scale)
    gp.timed("building five galaxies", group.UpdatePipeline)
    return group


def main():
    options = gm.arguments(__doc__, 300, "1280x720").parse_args()
    size = gm.size_of(options.size)
    gp.load_plugin()
    path = [camera(t) for t in gm.times(options.frames)]
    scene = {"size": size, "particle scale": options.particle_scale,
             "files": gm.digest(GROUP, os.path.join(gm.HERE, "M83"), __file__)}
    movie = gm.Movie(options.folder, scene, path)
    movie.draw(lambda: gm.Painter(build(options.particle_scale), size, EXPOSURE, stretch=12))
    movie.encode("m83-group-zoom.mp4", options.rate)


if __name__ == "__main__":
    main()
