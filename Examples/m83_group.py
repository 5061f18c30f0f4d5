"""The M83 group: M83 and four dwarfs at their places in the sky and their distances.

Usage: pvpython Examples/m83_group.py OUTPUT_FOLDER
Needs the mock images of M83: Examples/M83/images.sh makes them.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import galaxy_pictures as gp
from paraview import simple

HERE = os.path.dirname(os.path.abspath(__file__))
GAPS = 0.6  # factor on the distances between the galaxies
VIEWS = (  # title, eye direction (X West, Y North, Z toward the observer), half width kpc, gas
    ("from Earth, stars", (0, 0, 1), 125.0, False),
    ("from Earth, with H I", (0, 0, 1), 125.0, True),
    ("from the West", (1, 0.1, 0.3), 370.0, True),
    ("from the North", (0.3, 1, 0.2), 370.0, True),
)


def camera(direction, half_width):
    return {
        "CameraPosition": [1000.0 * d for d in direction],
        "CameraFocalPoint": [0.0, 0.0, 0.0],
        "CameraViewUp": [0.0, 1.0, 0.0] if abs(direction[1]) < 0.9 else [0.0, 0.0, 1.0],
        "CameraParallelProjection": 1,
        "CameraParallelScale": half_width,
    }


def main(output):
    os.makedirs(output, exist_ok=True)
    gp.load_plugin()
    group = simple.GalaxyGroup(
        FileName=os.path.join(HERE, "M83Group", "m83group.galaxygroup"),
        Separation=GAPS,
        ParticleScale=0.3,
    )
    gp.timed("building five galaxies", group.UpdatePipeline)
    gas = [name for name in gp.component_names(group) if name.endswith(("/gas", "/H I"))]
    images = []
    for title, direction, half_width, with_gas in VIEWS:
        view, hidden = camera(direction, half_width), () if with_gas else gas
        radiance = gp.timed(title, lambda: gp.render(group, view, hidden=hidden))
        image = gp.tone_map(radiance, gp.exposure_for(radiance, 99.5), stretch=30)
        note = f"mock data; dwarfs enlarged 5 x, gaps x {GAPS:g}"
        images.append(gp.annotate(image, None, "M83 group " + title, note))
    path = os.path.join(output, "m83-group.png")
    gp.contact_sheet(images, 2, path)
    print("  " + path)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1])
