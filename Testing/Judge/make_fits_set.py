"""Writes a small set of FITS images of every kind that the reader must know.

Usage: python3 make_fits_set.py FOLDER
"""
import gzip
import os
import shutil
import sys

import numpy as np
from astropy.io import fits

RNG = np.random.default_rng(83)
SHAPE = (24, 31)


def image(dtype=np.float32):
    """A smooth blob on noise, in the range of the type."""
    y, x = np.indices(SHAPE)
    values = 90 * np.exp(-((x - 15) ** 2 + (y - 11) ** 2) / 40) + RNG.normal(0, 3, SHAPE) + 20
    return values.astype(dtype)


def sky(projection="TAN", **cards):
    """A header with celestial coordinates."""
    header = fits.Header()
    header["CTYPE1"], header["CTYPE2"] = f"RA---{projection}", f"DEC--{projection}"
    header["CRVAL1"], header["CRVAL2"] = 204.25, -29.87
    header["CRPIX1"], header["CRPIX2"] = 14.5, 12.25
    header["CDELT1"], header["CDELT2"] = -0.01, 0.01
    for key, value in cards.items():
        header[key] = value
    return header


def bitpix(save):
    for name, dtype in (("u8", np.uint8), ("i16", np.int16), ("i32", np.int32), ("i64", np.int64),
                        ("f32", np.float32), ("f64", np.float64)):
        save(f"bitpix_{name}", fits.PrimaryHDU(image(dtype)))
    for name, dtype in (("u16", np.uint16), ("u32", np.uint32), ("i8", np.int8)):
        save(f"unsigned_{name}", fits.PrimaryHDU(image(dtype)))
    wide = image(np.int64) * 10**12
    save("bitpix_i64_wide", fits.PrimaryHDU(wide))


def blanks(save):
    values = image()
    values[3, 4], values[5, 6], values[7, 8] = np.nan, np.inf, -np.inf
    save("nan_and_inf", fits.PrimaryHDU(values))
    hdu = fits.PrimaryHDU(image(np.int16))
    hdu.header["BLANK"] = int(hdu.data[2, 3])
    save("blank_i16", hdu)
    scaled = fits.PrimaryHDU(image(np.int16))
    save("scaled_i16", scaled, BSCALE=0.0125, BZERO=-7.5)
    save("all_nan", fits.PrimaryHDU(np.full(SHAPE, np.nan, np.float32)))


def structures(save):
    save("extensions", fits.HDUList([
        fits.PrimaryHDU(), fits.BinTableHDU.from_columns([fits.Column("A", "E", array=[1.0])]),
        fits.ImageHDU(image(), name="SCI"), fits.ImageHDU(image(np.int16), name="DQ")]))
    save("cube", fits.PrimaryHDU(RNG.normal(size=(5, *SHAPE)).astype(np.float32)))
    radio = fits.PrimaryHDU(RNG.normal(size=(1, 4, *SHAPE)).astype(np.float32), sky("SIN"))
    radio.header.update(CTYPE3="FREQ", CRVAL3=1.42e9, CRPIX3=1.0, CDELT3=1e4, CUNIT3="Hz",
                        CTYPE4="STOKES", CRVAL4=1.0, CRPIX4=1.0, CDELT4=1.0)
    save("radio_4d", radio)
    swapped = fits.PrimaryHDU(RNG.normal(size=(31, 3, 24)).astype(np.float32))
    swapped.header.update(CTYPE1="DEC--TAN", CRVAL1=41.0, CRPIX1=10.0, CDELT1=0.01,
                          CTYPE2="FREQ", CRVAL2=1.4e9, CRPIX2=1.0, CDELT2=1e4,
                          CTYPE3="RA---TAN", CRVAL3=10.0, CRPIX3=16.0, CDELT3=-0.01)
    save("dec_freq_ra", swapped)


def compressed(save):
    for kind in ("RICE_1", "GZIP_1", "GZIP_2", "HCOMPRESS_1", "PLIO_1"):
        hdu = fits.CompImageHDU(image(np.int16), sky(), compression_type=kind, tile_size=None)
        save(f"compressed_{kind.lower()}", fits.HDUList([fits.PrimaryHDU(), hdu]))
    for name, method in (("none", -1), ("dither1", 1), ("dither2", 2)):
        values = image()
        values[4, 4:9] = 0
        values[6, 6] = np.nan
        hdu = fits.CompImageHDU(values, compression_type="RICE_1", quantize_level=8,
                                quantize_method=method, dither_seed=42)
        save(f"quantised_{name}", fits.HDUList([fits.PrimaryHDU(), hdu]))


def projections(save):
    zenithal = ("AZP", "SZP", "TAN", "STG", "SIN", "ARC", "ZPN", "ZEA", "AIR")
    others = ("CYP", "CEA", "CAR", "MER", "SFL", "PAR", "MOL", "AIT", "COP", "COE", "COD", "COO",
              "BON", "PCO", "TSC", "CSC", "QSC", "HPX", "XPH")
    for code in zenithal + others:
        header = sky(code)
        if code in zenithal:
            header["CRVAL2"] = 35.0
        if code in ("COP", "COE", "COD", "COO"):
            header["PV2_1"], header["CRVAL2"] = 45.0, 45.0
        if code == "BON":
            header["PV2_1"] = 45.0
        if code == "ZPN":
            header["PV2_1"], header["PV2_3"] = 1.0, -0.05
        save(f"projection_{code.lower()}", fits.PrimaryHDU(image(), header))


def orientations(save):
    angle = np.radians(25)
    c, s = np.cos(angle), np.sin(angle)
    cd = sky(CD1_1=-0.01 * c, CD1_2=0.01 * s, CD2_1=0.01 * s, CD2_2=0.01 * c)
    del cd["CDELT1"], cd["CDELT2"]
    save("cd_matrix", fits.PrimaryHDU(image(), cd))
    pc = sky(PC1_1=c, PC1_2=-s, PC2_1=s, PC2_2=c)
    save("pc_matrix", fits.PrimaryHDU(image(), pc))
    save("crota2", fits.PrimaryHDU(image(), sky(CROTA2=25.0)))
    save("mirrored", fits.PrimaryHDU(image(), sky(CDELT1=0.01)))
    save("ra_wraps", fits.PrimaryHDU(image(), sky(CRVAL1=0.02)))
    save("negative_crval", fits.PrimaryHDU(image(), sky(CRVAL1=-155.75)))
    save("north_pole", fits.PrimaryHDU(image(), sky(CRVAL2=89.98)))
    save("south_pole", fits.PrimaryHDU(image(), sky("SIN", CRVAL2=-90.0)))
    sip = sky("TAN-SIP", A_ORDER=2, B_ORDER=2, A_2_0=2e-4, B_1_1=-3e-4, A_0_2=1e-4)
    save("sip", fits.PrimaryHDU(image(), sip))
    tpv = sky("TPV", PV1_0=0.0, PV1_1=1.0, PV1_4=0.02, PV2_0=0.0, PV2_1=1.0, PV2_5=-0.03)
    save("tpv", fits.PrimaryHDU(image(), tpv))
    save("ncp", fits.PrimaryHDU(image(), sky("NCP", CRVAL2=60.0)))


def frames(save):
    save("icrs", fits.PrimaryHDU(image(), sky(RADESYS="ICRS")))
    save("fk5_2000", fits.PrimaryHDU(image(), sky(RADESYS="FK5", EQUINOX=2000.0)))
    save("fk5_1975", fits.PrimaryHDU(image(), sky(RADESYS="FK5", EQUINOX=1975.0)))
    save("fk4_1950", fits.PrimaryHDU(image(), sky(RADESYS="FK4", EQUINOX=1950.0)))
    save("fk4_1900", fits.PrimaryHDU(image(), sky(RADESYS="FK4", EQUINOX=1900.0)))
    save("epoch_1950", fits.PrimaryHDU(image(), sky(EPOCH=1950.0)))
    save("plate_date", fits.PrimaryHDU(image(), sky(EPOCH=1955.3)))
    galactic = sky()
    galactic["CTYPE1"], galactic["CTYPE2"] = "GLON-CAR", "GLAT-CAR"
    galactic["CRVAL1"], galactic["CRVAL2"] = 314.58, 0.0
    save("galactic", fits.PrimaryHDU(image(), galactic))


def main(folder):
    os.makedirs(folder, exist_ok=True)

    def save(name, hdus, **cards):
        path = os.path.join(folder, name + ".fits")
        hdus.writeto(path, overwrite=True)
        if cards:  # after writing, so that astropy does not scale the values by them
            with fits.open(path, mode="update", do_not_scale_image_data=True) as file:
                file[0].header.update(cards)

    for make in (bitpix, blanks, structures, compressed, projections, orientations, frames):
        make(save)
    plain = os.path.join(folder, "bitpix_f32.fits")
    with open(plain, "rb") as source, gzip.open(plain + ".gz", "wb") as target:
        shutil.copyfileobj(source, target)
    with open(plain, "rb") as source:
        whole = source.read()
    with open(os.path.join(folder, "truncated.fits"), "wb") as target:
        target.write(whole[:3000])
    with open(os.path.join(folder, "not_fits.fits"), "wb") as target:
        target.write(b"SIMPLE as that\n" * 300)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1])
