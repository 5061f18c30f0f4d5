# A group: M83 and four dwarfs, from Earth and from the North, where their distances show.
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cookbook import GROUP, SCALE, beside, gp, picture
from paraview import simple

# The gaps are drawn at half their length, or the galaxies would be dots.
group = simple.GalaxyGroup(FileName=GROUP, ParticleScale=0.3 * SCALE, Separation=0.5)
group.UpdatePipeline()
print("\n".join(gp.component_names(group)))
north = gp.sky_camera(330.0)
north["CameraPosition"], north["CameraViewUp"] = [0.0, 3300.0, 0.0], [0.0, 0.0, 1.0]
beside([picture(group, gp.sky_camera(110.0), "M83 group from Earth", 110.0),
        picture(group, north, "from the North, Earth above", 330.0)], "group.png")
