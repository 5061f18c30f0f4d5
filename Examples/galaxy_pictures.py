"""What the examples share: loading the plugin, cameras, and PNG pictures with a scale bar.

Pictures come from the filter SplatImage, which needs no display. Light stays linear until
`tone_map`.
"""
import glob
import os
import time

import numpy as np
from paraview import servermanager, simple
from PIL import Image, ImageDraw, ImageFont
from vtkmodules.util.numpy_support import vtk_to_numpy

HERE = os.path.dirname(os.path.abspath(__file__))
FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"


def load_plugin():
    """Loads the plugin: that of GALAXY_PLUGIN, the one built by demo.sh, or the installed one."""
    built = glob.glob(os.path.join(HERE, "..", "build", "lib", "**", "GalaxyReconstruction.so"),
                      recursive=True)
    path = os.environ.get("GALAXY_PLUGIN") or next(iter(built), None)
    if path:
        simple.LoadPlugin(path, ns=vars(simple))
    else:
        simple.LoadDistributedPlugin("GalaxyReconstruction", ns=vars(simple))


def timed(what, work):
    """Runs work() and prints how long it took."""
    start = time.time()
    result = work()
    print(f"  {what}: {time.time() - start:.1f} s", flush=True)
    return result


def build_galaxy(path, particle_scale=1.0):
    """The particles of a .galaxy file, as the proxy GalaxyModel."""
    reader = simple.GalaxyReader(FileName=path)
    timed("reading rings and images", reader.UpdatePipeline)
    model = simple.GalaxyModel(Input=reader, ParticleScale=particle_scale)
    timed("building the model", model.UpdatePipeline)
    model.UpdatePropertyInformation()
    for line in str(model.Report).splitlines():
        print("    " + line)
    return model


def field_values(particles, name):
    """The numbers of a field array of one tuple, such as CameraEarth, without fetching the data."""
    array = particles.FieldData[name]
    return [array.GetRange(k)[0] for k in range(array.GetNumberOfComponents())]


def viewpoint(particles, name):
    """A camera that a GalaxyModel gives with its particles: Earth, FaceOn, EdgeOn or MajorAxis, or
    Earth:r for the field of the image r."""
    c = field_values(particles, "Camera" + name)
    return {
        "CameraPosition": c[:3],
        "CameraFocalPoint": c[3:6],
        "CameraViewUp": c[6:9],
        "CameraViewAngle": c[9],
    }


def disk_axes(model):
    """The inner disc's receding axis a, b at 90 degrees from it and the normal n, arrays of 3.

    `model` is a GalaxyModel; b is a quarter turn on from a in the sense of rotation.
    """
    a, n = (np.array(field_values(model, name)) for name in ("MajorAxis", "DiskNormal"))
    return a, np.cross(n, a), n


def orbit_camera(axes, tilt, azimuth, half_width, view_angle=20.0):
    """A perspective camera about the origin that sees `half_width` kpc to each side.

    `tilt` is 0 face-on and 90 edge-on, `azimuth` where around the disc the eye stands, degrees.
    """
    a, b, n = axes
    if n[2] < 0:  # look from the observer's side
        n = -n
    tilt, azimuth = np.radians(tilt), np.radians(azimuth)
    outward = np.cos(azimuth) * a + np.sin(azimuth) * b
    direction = np.cos(tilt) * n + np.sin(tilt) * outward
    up = np.cos(tilt) * -outward + np.sin(tilt) * n
    distance = half_width / np.tan(np.radians(view_angle / 2))
    return {
        "CameraPosition": list(distance * direction),
        "CameraFocalPoint": [0.0, 0.0, 0.0],
        "CameraViewUp": list(up),
        "CameraViewAngle": view_angle,
    }


def sky_camera(half_width):
    """The view from Earth: parallel projection, North up, East left."""
    return {
        "CameraPosition": [0.0, 0.0, 10 * half_width],
        "CameraFocalPoint": [0.0, 0.0, 0.0],
        "CameraViewUp": [0.0, 1.0, 0.0],
        "CameraParallelProjection": 1,
        "CameraParallelScale": half_width,
    }


def render(particles, camera, size=1024, hidden=()):
    """Radiance of a square picture, float array (size, size, 3), top row first."""
    picture = simple.SplatImage(Input=particles, ImageSize=[size, size], **camera)
    picture.ComponentVisibility = [item for name in hidden for item in (name, "0")]
    picture.UpdatePipeline()
    arrays = servermanager.Fetch(picture).GetPointData()
    radiance = vtk_to_numpy(arrays.GetArray("Radiance")).reshape(size, size, 3)[::-1].copy()
    simple.Delete(picture)
    return radiance


def component_names(particles):
    """The names of the components, as ComponentVisibility and its like take them."""
    names = servermanager.Fetch(particles).GetFieldData().GetAbstractArray("ComponentName")
    return [names.GetValue(i) for i in range(names.GetNumberOfValues())]


def tone_map(radiance, exposure=1.0, stretch=8.0):
    """Linear light to 8 bits: asinh stretch of the mean, hue kept (Lupton et al. 2004)."""
    light = radiance * exposure
    mean = np.maximum(light.mean(axis=2, keepdims=True), 1e-12)
    shown = light * np.arcsinh(stretch * mean) / np.arcsinh(stretch) / mean
    shown /= np.maximum(shown.max(axis=2, keepdims=True), 1.0)
    return Image.fromarray((255 * shown + 0.5).astype(np.uint8))


def exposure_for(radiance, percentile=99.9):
    """The exposure at which that percentile of the lit pixels' brightest channel becomes white."""
    brightest = radiance.max(axis=2)
    lit = brightest[brightest > 0]
    return 1 / np.percentile(lit, percentile) if lit.size else 1.0


def annotate(image, half_width, title, note=""):
    """Draws the title, a note and a scale bar (none where half_width is None) into the picture."""
    draw = ImageDraw.Draw(image)
    size = image.width
    font = ImageFont.truetype(FONT, max(11, size // 48))
    small = ImageFont.truetype(FONT, max(9, size // 72))
    margin = size // 32
    bottom = size - margin
    if half_width:
        kpc = next(k for k in (100, 50, 20, 10, 5, 2, 1, 0.5, 0.2, 0.1) if k < 0.5 * half_width)
        end = margin + kpc / (2 * half_width) * size
        draw.line([(margin, bottom), (end, bottom)], fill="white", width=max(2, size // 400))
        place = (margin, bottom - size // 100)
        draw.text(place, f"{kpc:g} kpc", fill="white", font=font, anchor="ls")
    draw.text((margin, margin), title, fill="white", font=font, anchor="lt")
    draw.text((size - margin, bottom), note, fill=(190, 190, 190), font=small, anchor="rs")
    return image


def contact_sheet(images, columns, path, tile=640):
    """One picture of many, row by row."""
    rows = -(-len(images) // columns)
    sheet = Image.new("RGB", (columns * tile, rows * tile))
    for k, image in enumerate(images):
        place = ((k % columns) * tile, (k // columns) * tile)
        sheet.paste(image.resize((tile, tile), Image.LANCZOS), place)
    sheet.save(path)
