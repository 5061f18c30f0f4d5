"""NGC 2903 from its real H I map and tilted rings: from Earth, face-on, at an angle and edge-on.

Usage: pvpython Examples/real_ngc2903.py DATA_FOLDER [OUTPUT_FOLDER]
DATA_FOLDER holds NGC_2903_HI_mom0.fits and NGC_2903.def.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import real_sky

if __name__ == "__main__":
    real_sky.main(__doc__, "ngc2903", half_width=42.0, azimuth=0, stretch=7,
                  exposure=0.7)  # of one colour: its bright channel is white before the mean is
