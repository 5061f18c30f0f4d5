# A bulge with another profile: four spheroids of the same light, each in the same linear light.
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cookbook import SCALE, beside, gp, picture
from paraview import simple

PROFILES = {
    "Gaussian": {"Sigma": [0.5, 0.5, 0.5]},
    "Sersic": {"SersicIndex": 4, "EffectiveRadius": 0.7},
    "Hernquist": {"ScaleRadius": 0.4},
    "Plummer": {"ScaleRadius": 0.7},
}
pictures = []
for profile, shape in PROFILES.items():
    bulge = simple.Spheroid(Profile=profile, Luminosity=3, AxisRatios=[1, 0.6], **shape)
    bulge.NumberOfParticles, bulge.Color = int(1e6 * SCALE), [1, 0.8, 0.55]
    bulge.Truncation = 3
    pictures.append(picture(bulge, gp.sky_camera(2.5), profile, 2.5, 0.2, "a model"))
beside(pictures, "bulge.png")
