"""What the real galaxies' examples share: a .galaxy of RealSky/ with the data folder put in."""
import os
import re
import sys

import galaxy_pictures as gp

HERE = os.path.dirname(os.path.abspath(__file__))
VIEWS = (("face-on", 0), ("angled", 60), ("edge-on", 90))


def described(name, data, output):
    """Writes OUTPUT/NAME.galaxy, the description with DATA replaced by the folder."""
    with open(os.path.join(HERE, "RealSky", name + ".galaxy"), encoding="utf-8") as file:
        text = file.read()
    path = os.path.join(output, name + ".galaxy")
    missing = [n for n in re.findall(r'"DATA/([^"]*)"', text) if not os.path.exists(f"{data}/{n}")]
    if missing:
        sys.exit(f"{data} lacks {', '.join(missing)}; add what RealSky/{name}.galaxy names")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.replace('"DATA/', f'"{os.path.abspath(data)}/'))
    return path


def main(usage, name, half_width, azimuth, stretch, exposure=1.0):
    if len(sys.argv) < 2:
        sys.exit(usage)
    data = sys.argv[1]
    if not os.path.isdir(data):
        sys.exit(f"{data} is no folder; give the one with the images")
    output = sys.argv[2] if len(sys.argv) > 2 else os.path.join(HERE, "output")
    os.makedirs(output, exist_ok=True)
    gp.load_plugin()
    model = gp.build_galaxy(described(name, data, output))
    axes = gp.disk_axes(model)
    cameras = [("from Earth", gp.sky_camera(half_width))]
    cameras += [(view, gp.orbit_camera(axes, tilt, azimuth, half_width)) for view, tilt in VIEWS]
    images = []
    for view, camera in cameras:
        radiance = gp.timed(view, lambda: gp.render(model, camera))
        image = gp.tone_map(radiance, exposure * gp.exposure_for(radiance), stretch)
        title = f"{name.upper()} {view}"
        images.append(gp.annotate(image, half_width, title, "real data"))
        path = os.path.join(output, f"real-{name}-{view.replace(' ', '-').lower()}.png")
        image.save(path)
        print("  " + path, flush=True)
    gp.contact_sheet(images, 2, os.path.join(output, f"real-{name}.png"))
