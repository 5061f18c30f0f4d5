# Only the H I: its warp edge-on, three exposures of the same linear light.
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cookbook import M83, SCALE, beside, gp, picture

model = gp.build_galaxy(M83, SCALE)
others = [name for name in gp.component_names(model) if name != "gas"]
camera = gp.orbit_camera(gp.disk_axes(model), 90, 60, 55.0)
beside([picture(model, camera, f"H I, exposure {exposure:g}", 55.0, exposure, hidden=others)
        for exposure in (0.5, 2, 8)], "only_hydrogen.png")
