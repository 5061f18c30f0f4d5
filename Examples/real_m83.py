"""M83 from a real plate and ring model: from Earth, face-on, at an angle and edge-on.

Usage: pvpython Examples/real_m83.py DATA_FOLDER [OUTPUT_FOLDER]
DATA_FOLDER holds m83_dss1_J_671.fits and M_83.rotcur.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import real_sky

if __name__ == "__main__":
    real_sky.main(__doc__, "m83", half_width=9.0, azimuth=60, stretch=0.5)
