"""Compares where the project puts the pixels of headers with where astropy puts them.

Usage: python3 judge_coordinates.py DUMP_PROGRAM [COUNT [SEED]]
Makes COUNT good headers of every projection, form of the matrix, distortion and frame, and judges 25
pixels of each: positions within 1e-3 arcsec; none lost that astropy finds the way back from, none
refused. Prints those that differ and ends with 1 where there is any.
"""
import json
import logging
import math
import random
import subprocess
import sys
import warnings

import numpy as np
from astropy.coordinates import SkyCoord
from astropy.io import fits
from astropy.wcs import WCS
from astropy.wcs.utils import wcs_to_celestial_frame

warnings.simplefilter("ignore")
logging.disable(logging.CRITICAL)
TOLERANCE = 1e-3  # arcsec
NEAR = 0.1  # pixel

CONIC = {"PV2_1": 45.0, "PV2_2": 25.0}
PROJECTIONS = {
    "AZP": {"PV2_1": 2.0, "PV2_2": 30.0}, "SZP": {"PV2_1": 2.0, "PV2_2": 180.0, "PV2_3": 60.0},
    "TAN": {}, "STG": {}, "SIN": {}, "NCP": {}, "ARC": {}, "ZPN": {"PV2_1": 1.0, "PV2_3": -0.04},
    "ZEA": {}, "AIR": {"PV2_1": 45.0}, "CYP": {"PV2_1": 1.0, "PV2_2": 0.7}, "CEA": {"PV2_1": 0.8},
    "CAR": {}, "MER": {}, "COP": CONIC, "COE": CONIC, "COD": CONIC, "COO": CONIC, "SFL": {},
    "GLS": {}, "PAR": {}, "MOL": {}, "AIT": {}, "BON": {"PV2_1": 45.0}, "PCO": {}, "TSC": {},
    "CSC": {}, "QSC": {}, "HPX": {}, "XPH": {},
}


def matrix(rng, step):
    """CD, PC or CROTA of an image turned by any angle."""
    angle = math.radians(rng.uniform(-180, 180))
    c, s = math.cos(angle), math.sin(angle)
    form = rng.choice(["CD", "PC", "PC00", "CROTA", ""])
    if form == "CD":
        return {"CD1_1": -1.01 * step * c, "CD1_2": step * s, "CD2_1": step * s, "CD2_2": step * c}
    cards = {"CDELT1": rng.choice([-1, 1]) * step, "CDELT2": rng.choice([1, 1.1]) * step}
    if form == "CROTA":
        cards["CROTA2"] = math.degrees(angle)
    if form.startswith("PC"):
        names = ("PC1_1", "PC1_2", "PC2_1", "PC2_2")
        if form == "PC00":
            names = ("PC001001", "PC001002", "PC002001", "PC002002")
        cards.update(zip(names, (c, -s, 0.98 * s, c)))
    return cards


def distortion(rng, longitude, latitude):
    """What may stand beside TAN: nothing, SIP, TPV, or TPV under the name of TAN."""
    kind = rng.choice(["", "SIP", "TPV", "TAN"])
    cards = {}
    if kind == "SIP":
        cards = {"CTYPE1": longitude + "TAN-SIP", "CTYPE2": latitude + "TAN-SIP"}
        for root in "AB":
            order = cards[root + "_ORDER"] = rng.choice([2, 3, 4])
            for p in range(order + 1):
                for q in range(order + 1 - p):
                    if p + q > 1:
                        cards[f"{root}_{p}_{q}"] = rng.gauss(0, 3) * 100.0 ** (-p - q)
    elif kind:
        cards = {"CTYPE1": longitude + kind, "CTYPE2": latitude + kind, "PV1_1": 1.01,
                 "PV2_1": 0.99, "PV1_0": 1e-4, "PV1_4": rng.gauss(0, 0.02),
                 "PV2_7": rng.gauss(0, 0.05), "PV1_10": rng.gauss(0, 0.05)}
    return cards


def some_header(rng):
    code = rng.choice(list(PROJECTIONS))
    galactic = rng.random() < 0.25
    longitude, latitude = ("GLON-", "GLAT-") if galactic else ("RA---", "DEC--")
    header = {"CTYPE1": longitude + code, "CTYPE2": latitude + code,
              "CRPIX1": rng.choice([50.5, 50.0, rng.uniform(-50, 150)]),
              "CRPIX2": rng.choice([50.5, 50.0, rng.uniform(-50, 150)]),
              "CRVAL1": rng.uniform(0, 360),
              "CRVAL2": rng.choice([rng.uniform(-89, 89), 0.0, 90.0, -90.0])}
    if code == "NCP":
        header["CRVAL2"] = rng.uniform(20, 89)
    header.update(matrix(rng, rng.choice([1e-4, 1e-3, 1e-2, 1e-1, 1.0])))
    header.update(PROJECTIONS[code])
    if rng.random() < 0.15:
        header["LONPOLE"] = rng.uniform(0, 360)
    if not galactic and rng.random() < 0.6:
        header["RADESYS"] = rng.choice(["FK4", "FK5", "ICRS", "FK4-NO-E"])
        if header["RADESYS"] != "ICRS":
            header["EQUINOX"] = rng.choice([1950.0, 2000.0, 1975.0])
    if code == "TAN":
        header.update(distortion(rng, longitude, latitude))
    return header


def card(keyword, value):
    text = f"'{value:8s}'" if isinstance(value, str) else repr(value).upper()
    return f"{keyword:8s}= {text:>20s}".ljust(80)


def judge(cards, ours):
    """What is wrong with our positions; empty where nothing is. None where astropy has none."""
    axis = 1 + np.arange(5) * 24.75
    y, x = (a.ravel() for a in np.meshgrid(axis, axis, indexing="ij"))
    try:
        wcs = WCS(fits.Header.fromstring(cards))
        lon, lat = wcs.all_pix2world(x, y, 1)
        frame = wcs_to_celestial_frame(wcs)
    except Exception:  # whatever it is, it is no judge of this header
        return None
    if isinstance(ours, str):
        return "refused: " + ours
    known = np.isfinite(lon) & np.isfinite(lat)
    found = np.array([p is not None for p in ours])
    both = known & found
    if both.any():
        places = np.array([p for p, is_in in zip(ours, both) if is_in])
        sky = SkyCoord(lon[both], lat[both], unit="deg", frame=frame).icrs
        apart = sky.separation(SkyCoord(places[:, 0], places[:, 1], unit="deg")).arcsec.max()
        if apart > TOLERANCE:
            return f"{apart} arcsec apart"
    lost = known & ~found
    if lost.any():
        try:
            back = wcs.all_world2pix(lon[lost], lat[lost], 1, quiet=True)
        except Exception:
            return ""
        if (np.hypot(back[0] - x[lost], back[1] - y[lost]) < NEAR).any():
            return "a pixel is lost"
    return ""


def main():
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 300
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    size = {"NAXIS": 2, "NAXIS1": 100, "NAXIS2": 100}
    headers = ["".join(card(k, v) for k, v in {**size, **some_header(rng)}.items())
               for _ in range(count)]
    done = subprocess.run([sys.argv[1]], input="\n".join(headers) + "\n", capture_output=True,
                          text=True, timeout=240, check=True)
    verdicts = [judge(h, json.loads(line)) for h, line in zip(headers, done.stdout.splitlines())]
    for header, verdict in zip(headers, verdicts):
        if verdict:
            print(verdict, *(header[i:i + 80].rstrip() for i in range(0, len(header), 80)), sep="\n  ")
    judged = sum(v is not None for v in verdicts)
    bad = sum(bool(v) for v in verdicts)
    print(f"{judged} of {count} headers judged, {bad} differ")
    return 1 if bad or judged < 0.9 * count or len(verdicts) != count else 0


if __name__ == "__main__":
    sys.exit(main())
