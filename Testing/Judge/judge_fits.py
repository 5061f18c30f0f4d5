"""Compares what the project reads of FITS images with what astropy reads.

Usage: python3 judge_fits.py DUMP_PROGRAM FOLDER...
Prints a row for every file: agrees, refused (with the message), or differs; ends with 1 where any
file differs without saying so. Values must be equal to the last bit, blanks at the same pixels,
positions of the corners and the middle within 1e-3 arcsec.
"""
import json
import os
import subprocess
import sys
import tempfile
import warnings

import numpy as np
from astropy.coordinates import ICRS, SkyCoord
from astropy.io import fits
from astropy.wcs import WCS
from astropy.wcs.utils import wcs_to_celestial_frame

warnings.simplefilter("ignore")
TOLERANCE = 1e-3  # arcsec
ENDINGS = (".fits", ".fit", ".fts", ".fits.gz", ".fits.fz", ".gz")


def ours(program, path, values):
    """The project's reading: the printed facts and the values, or None."""
    done = subprocess.run([program, path, values], capture_output=True, text=True, timeout=120)
    if done.returncode != 0:
        return {"crashed": done.stderr[-200:] or f"exit {done.returncode}"}, None
    facts = json.loads(done.stdout)
    if "refused" in facts:
        return facts, None
    return facts, np.fromfile(values).reshape(facts["height"], facts["width"])


def plane_axes(header):
    """The zero-based FITS axes of the image plane: the celestial ones, else the first two."""
    try:
        wcs = WCS(header)
        if wcs.has_celestial and wcs.naxis >= 2:
            return sorted((wcs.wcs.lng, wcs.wcs.lat)), wcs
        return [0, 1], wcs
    except Exception:
        return [0, 1], None


def physical(hdu):
    """All values in float64 from the stored ones; integers are scaled here, in float64."""
    header = hdu.header
    stored = hdu.data
    if stored.dtype.kind not in "iu":
        values = stored.astype(np.float64)
        scale, zero = header.get("BSCALE", 1.0), header.get("BZERO", 0.0)
        if (scale, zero) != (1.0, 0.0) and hdu._bzero == zero:
            values = values * scale + zero
    else:
        scale, zero = header.get("BSCALE", 1.0), header.get("BZERO", 0.0)
        values = stored.astype(np.float64) * scale + zero
        if "BLANK" in header:
            values[stored == header["BLANK"]] = np.nan
    values[~np.isfinite(values)] = np.nan
    return values


def astropys(path):
    """Astropy's first image: float64 values of its first plane and its header, or None and why."""
    try:
        with fits.open(path, do_not_scale_image_data=True, memmap=False) as file:
            for hdu in file:
                compressed = isinstance(hdu, fits.CompImageHDU)
                if not (hdu.is_image or compressed) or hdu.header.get("NAXIS", 0) < 2:
                    continue
                if isinstance(hdu, fits.GroupsHDU) or hdu.data is None:
                    continue
                header = hdu.header.copy()
                values = physical(hdu)
                axes, wcs = plane_axes(header)
                keep = [values.ndim - 1 - axis for axis in axes]
                index = tuple(slice(None) if k in keep else 0 for k in range(values.ndim))
                return values[index], header, wcs
        return None, "no image with two axes", None
    except Exception as error:
        return None, f"{type(error).__name__}: {error}"[:90], None


def positions(header, wcs, width, height):
    """ICRS positions of the corners and the middle, or None where astropy has none."""
    if wcs is None or not wcs.has_celestial:
        return None
    try:
        celestial = wcs.celestial
        x = np.array([1, width, 1, width, (width + 1) / 2])
        y = np.array([1, 1, height, height, (height + 1) / 2])
        world = celestial.all_pix2world(np.column_stack([x, y]), 1)
        if celestial.wcs.lng > celestial.wcs.lat:
            world = world[:, ::-1]
        frame = wcs_to_celestial_frame(celestial)
        epoch = header.get("EPOCH")
        if epoch and not {"EQUINOX", "RADESYS", "RADECSYS"} & set(header) and epoch % 25:
            frame = ICRS()  # the date a plate was taken, not an equinox
        return SkyCoord(world[:, 0], world[:, 1], unit="deg", frame=frame).icrs
    except Exception:
        return None


def without_plate(header):
    """The header without the plate solution of the Digitized Sky Survey.

    Programs that cut, bin or turn a plate's image rewrite its axes and leave the solution as it was;
    then the axes are right and the solution, which astropy follows, is not.
    """
    stale = ("AMDX", "AMDY", "PLT", "PPO", "CNPIX", "XPIXELSZ", "YPIXELSZ")
    rest = header.copy()
    for key in [key for key in rest if key.startswith(stale)]:
        del rest[key]
    return rest


def farthest(facts, sky):
    """The largest distance in arcsec between the positions of both, None where none is on the sky."""
    found = [k for k, p in enumerate(facts["positions"]) if p and np.isfinite(sky[k].ra.deg)]
    if not found:
        return None
    here = SkyCoord([facts["positions"][k] for k in found], unit="deg")
    return here.separation(sky[found]).arcsec.max()


def verdict(program, path, values_file):
    """(class, remark) of one file; class is agrees, refused or differs."""
    facts, mine = ours(program, path, values_file)
    if "crashed" in facts:
        return "differs", "crashed: " + facts["crashed"]
    theirs, header, wcs = astropys(path)
    if mine is None:
        return "refused", facts["refused"].replace(path, os.path.basename(path))
    if theirs is None:
        return "agrees", "read here only; astropy: " + header
    if theirs.shape != mine.shape:
        return "differs", f"shape {mine.shape}, astropy {theirs.shape}"
    if not np.array_equal(np.isnan(theirs), np.isnan(mine)):
        return "differs", "other pixels are blank"
    if not np.array_equal(theirs, mine, equal_nan=True):
        worst = np.nanmax(np.abs(theirs - mine) / np.maximum(np.abs(theirs), 1e-300))
        return "differs", f"values differ by {worst:.1e}"
    sky = positions(header, wcs, mine.shape[1], mine.shape[0])
    if "no_positions" in facts:
        remark = "no positions: " + facts["no_positions"].split(": ", 1)[-1]
        return "agrees", remark + ("" if sky is None else " (astropy has some)")
    if sky is None:
        return "agrees", "values; astropy has no positions"
    worst = farthest(facts, sky)
    if worst is None:
        return "agrees", "values; the corners are off the sky"
    remark = ""
    if worst > TOLERANCE and "AMDX1" in header and "CTYPE1" in header:
        axes = without_plate(header)
        worst = farthest(facts, positions(axes, WCS(axes), mine.shape[1], mine.shape[0]))
        remark = ", by the axes beside a stale plate solution"
    return ("agrees" if worst <= TOLERANCE else "differs"), f"values, {worst:.1e} arcsec{remark}"


def main(program, folders):
    if not any(os.path.isdir(folder) for folder in folders):
        print("SKIPPED: no such folder: " + ", ".join(folders))
        sys.exit(77)
    counts = {"agrees": 0, "refused": 0, "differs": 0}
    with tempfile.TemporaryDirectory() as scratch:
        for folder in folders:
            for root, _, names in sorted(os.walk(folder)):
                for name in sorted(names):
                    if name.endswith(ENDINGS):
                        path = os.path.join(root, name)
                        result, remark = verdict(program, path, os.path.join(scratch, "values"))
                        counts[result] += 1
                        print(f"{result:8} {os.path.relpath(path, folder):60} {remark}", flush=True)
    print(", ".join(f"{count} {name}" for name, count in counts.items()))
    if counts["agrees"] == 0 or counts["differs"]:
        sys.exit("some file differs, or none was read")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
