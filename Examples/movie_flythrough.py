"""A movie through M83: down to its disc, along an arm past the middle, and out on the other side.

Usage: pvbatch Examples/movie_flythrough.py OUTPUT_FOLDER [--frames 400] [--size 1280x720] [--dome] ...
With --dome it is for a planetarium: round frames, 180 degrees, ahead toward the lower edge.
Needs the mock images of M83: Examples/M83/images.sh makes them. Stopped, it goes on when run again.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import galaxy_movie as gm
import galaxy_pictures as gp
import numpy as np

M83 = os.path.join(gm.HERE, "M83")
EXPOSURE = 0.4
# Time, place of the eye and what it looks at: kpc along the disc's receding axis, at a right angle
# to it in the disc, and above the disc.
PATH = (
    (0.00, (0.0, -24.0, 17.0), (0.0, 0.0, 0.0)),
    (0.25, (2.5, -11.0, 4.5), (0.0, 0.0, 0.0)),
    (0.45, (4.2, -4.0, 1.0), (0.5, 1.0, 0.0)),
    (0.60, (3.4, 0.5, 0.5), (-1.0, 3.0, 0.0)),
    (0.75, (0.2, 3.6, 0.9), (-5.0, 1.5, 0.0)),
    (0.88, (-4.5, 3.5, 2.4), (-5.0, -2.0, 0.0)),
    (1.00, (-10.0, -1.0, 6.0), (0.0, 0.0, 0.0)),
)


def keys(axes):
    """The path's cameras in the galaxy's frame, up being the side of the disc that faces us."""
    a, b, n = axes
    if n[2] < 0:
        n = -n

    def place(p):
        return list(p[0] * a + p[1] * b + p[2] * n)

    return [(time, {"CameraPosition": place(eye), "CameraFocalPoint": place(at),
                    "CameraViewUp": list(n), "CameraViewAngle": 50.0}) for time, eye, at in PATH]


def main():
    parser = gm.arguments(__doc__, 400, "1280x720")
    parser.add_argument("--dome", action="store_true", help="fulldome frames; make --size square")
    options = parser.parse_args()
    size = gm.size_of(options.size)
    gp.load_plugin()
    model = gp.build_galaxy(os.path.join(M83, "m83.galaxy"), options.particle_scale)
    through = keys(gp.disk_axes(model))
    path = [gm.along(through, gm.ease(t)) for t in gm.times(options.frames)]
    if options.dome:
        path = [gm.dome(camera) for camera in path]
    scene = {"size": size, "particle scale": options.particle_scale,
             "files": gm.digest(M83, __file__)}
    movie = gm.Movie(options.folder, scene, path)
    movie.draw(lambda: gm.Painter(model, size, EXPOSURE, hidden=("gas",)))
    movie.encode("m83-dome.mp4" if options.dome else "m83-flythrough.mp4", options.rate)


if __name__ == "__main__":
    main()
