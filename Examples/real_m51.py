"""M51 from real images: the views from Earth, face-on, at an angle and edge-on.

Usage: pvpython Examples/real_m51.py DATA_FOLDER [OUTPUT_FOLDER]
DATA_FOLDER holds SDSS9_M51_g.fits, _r, _i, ngc5194_12co21_ii.fits, ngc5194_spire250_gauss21.fits.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import real_sky

if __name__ == "__main__":
    real_sky.main(__doc__, "m51", half_width=13.0, azimuth=80, stretch=8)
