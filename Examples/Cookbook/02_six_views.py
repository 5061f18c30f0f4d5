# The six views: the whole galaxy with its hydrogen and the disc without, face-on to edge-on.
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cookbook import M83, SCALE, beside, gp, picture

model = gp.build_galaxy(M83, SCALE)
axes = gp.disk_axes(model)
pictures = []
for half_width, hidden in ((55.0, ()), (9.0, ("gas",))):  # kpc to each side
    for name, tilt in (("face-on", 0), ("angled", 60), ("edge-on", 90)):
        camera = gp.orbit_camera(axes, tilt, 60, half_width)
        pictures.append(picture(model, camera, name, half_width, hidden=hidden))
beside(pictures, "six_views.png", columns=3)
