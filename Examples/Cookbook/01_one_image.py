# A galaxy from one FITS image and its tilted rings: seen from Earth, and from the side.
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cookbook import M83_FOLDER, SCALE, beside, gp, image, picture

with open("one_image.galaxy", "w", encoding="utf-8") as file:
    file.write(f"""
[galaxy]
name = "M83 in R"
ra = 204.25383
dec = -29.86576
distance = 4.9
rings = "{M83_FOLDER}/m83.rings"
spin = "Clockwise"
[image.red]
file = "{image('r')}"
[[component]]
name = "stars"
particles = 600000
layers = [{{ image = "red", color = [1.0, 0.8, 0.55], clip = [0.0, 9.0], stretch = "Asinh" }}]
thickness = {{ model = "Tapered", law = "Sech2", children = 6, sigma = 0.03, scale_height = 0.25 }}
""")
model = gp.build_galaxy("one_image.galaxy", SCALE)
side = gp.orbit_camera(gp.disk_axes(model), 80, 60, 10.0)
beside([picture(model, gp.sky_camera(10.0), "M83 from Earth", 10.0),
        picture(model, side, "from the side", 10.0)], "one_image.png")
