"""What the recipes share: the plugin, the mock images of M83, and how many particles and pixels.

GALAXY_PARTICLE_SCALE and GALAXY_PICTURE_SIZE make them quicker or finer.
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
import galaxy_pictures as gp

M83_FOLDER = os.path.join(os.path.dirname(HERE), "M83")
M83 = os.path.join(M83_FOLDER, "m83.galaxy")
GROUP = os.path.join(os.path.dirname(HERE), "M83Group", "m83group.galaxygroup")
SCALE = float(os.environ.get("GALAXY_PARTICLE_SCALE", "0.3"))
SIZE = int(os.environ.get("GALAXY_PICTURE_SIZE", "640"))

if not os.path.exists(os.path.join(M83_FOLDER, "images", "complete")):
    sys.exit("First paint the mock images: " + os.path.join(M83_FOLDER, "images.sh"))
gp.load_plugin()


def image(name):
    """The path of a mock image, as a .galaxy file may name it."""
    return os.path.join(M83_FOLDER, "images", f"m83_{name}.fits")


def picture(particles, camera, title, half_width, exposure=None, note="mock data", **settings):
    """A titled picture of particles; the exposure is chosen where none is given."""
    radiance = gp.render(particles, camera, SIZE, **settings)
    shown = gp.tone_map(radiance, exposure or gp.exposure_for(radiance))
    return gp.annotate(shown, half_width, title, note)


def beside(pictures, path, columns=None):
    """Saves pictures in rows of so many, or all in one row."""
    gp.contact_sheet(pictures, columns or len(pictures), path, SIZE)
    print("wrote " + path)
