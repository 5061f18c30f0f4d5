"""The main job: reconstructs M83 and draws the six views of the paper's figure.

Usage: pvpython Examples/m83.py OUTPUT_FOLDER [PARTICLE_SCALE]
(Examples/demo.sh makes the images, builds the plugin and runs this.)
"""
import os
import resource
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import galaxy_pictures as gp

HERE = os.path.dirname(os.path.abspath(__file__))
FAR, CLOSE = 55.0, 9.0  # kpc from the middle to the picture's edge
TILTS = (("face-on", 0), ("angled", 60), ("edge-on", 90))
AZIMUTH = 60  # degrees from the receding axis: shows the warp


def main(output, particle_scale):
    start = time.time()
    os.makedirs(output, exist_ok=True)
    gp.load_plugin()
    print("M83 from the embedded mock images", flush=True)
    model = gp.build_galaxy(os.path.join(HERE, "M83", "m83.galaxy"), particle_scale)
    axes = gp.disk_axes(model)

    pictures, files = [], []
    for half_width, hidden, content in ((FAR, (), "with H I"), (CLOSE, ("gas",), "without H I")):
        for name, tilt in TILTS:
            camera = gp.orbit_camera(axes, tilt, AZIMUTH, half_width)
            radiance = gp.timed(
                f"{content}, {name}", lambda: gp.render(model, camera, hidden=hidden)
            )
            image = gp.tone_map(radiance, gp.exposure_for(radiance))
            gp.annotate(image, half_width, f"M83 {content}, {name}", "mock data")
            distance = "far" if half_width == FAR else "close"
            files.append(os.path.join(output, f"m83-{distance}-{name}.png"))
            image.save(files[-1])
            pictures.append(image)

    sheet = [pictures[k] for k in (0, 3, 1, 4, 2, 5)]  # far left, close right, as in the paper
    files.append(os.path.join(output, "m83-contact-sheet.png"))
    gp.contact_sheet(sheet, 2, files[-1])
    particles = model.GetDataInformation().GetNumberOfPoints() / 1e6
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024**2
    print(f"Done in {time.time() - start:.0f} s: {particles:.1f} M particles, "
          f"peak memory {memory:.1f} GB. Pictures:")
    for file in files:
        print("  " + file)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 1.0)
