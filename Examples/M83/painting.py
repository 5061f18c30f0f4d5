"""What make_images.py paints with: sky grids in the disc's coordinates, noise, FITS files."""
import time

import numpy as np
from astropy.io import fits
from astropy.wcs import WCS

RA, DEC = 204.25383, -29.86576  # degrees: the centre of M83


# ---------------------------------------------------------------------------- the sky and the disc
class Grid:
    """Square pixel grid on the sky with each pixel's place in the disc."""

    def __init__(self, size, scale, projection, rings):
        self.size, self.scale, self.projection = size, scale, projection
        self.margin = size // 16
        step = ((np.arange(size) - (size - 1) / 2) * scale).astype(np.float32)
        self.east, self.north = -step[None, :], step[:, None]
        self.r, self.phi, self.cosi = deproject(self.east, self.north, rings)

    def blurred(self, image, fwhm):
        """Convolution with a round Gaussian beam of unit sum; fwhm in arcsec."""
        return self.summed([(image, fwhm)])

    def summed(self, images):
        """Sum of images, each with its own beam."""
        n = self.size + 2 * self.margin
        k2 = np.fft.fftfreq(n)[:, None]**2 + np.fft.rfftfreq(n)[None, :]**2
        total = 0
        for image, fwhm in images:
            beam = np.exp(-2 * (np.pi * fwhm / 2.3548 / self.scale)**2 * k2)
            total = total + np.fft.rfft2(np.pad(image, self.margin)) * beam
        inner = slice(self.margin, self.margin + self.size)
        return np.maximum(np.fft.irfft2(total, s=(n, n))[inner, inner], 0).astype(np.float32)

    def deposit(self, east, north, light):
        """Point sources as light per pixel."""
        column = np.rint((self.size - 1) / 2 - east / self.scale).astype(int)
        row = np.rint((self.size - 1) / 2 + north / self.scale).astype(int)
        inside = (column >= 0) & (column < self.size) & (row >= 0) & (row < self.size)
        pixel = row[inside] * self.size + column[inside]
        return np.bincount(pixel, light[inside], self.size**2).reshape(self.size, self.size)


def deproject(east, north, rings):
    """Radius and angle in the warped disc: the root of |(u, w / cos i(r))| = r, by bisection.
    The angle counts from the innermost ring's axis, however the axis turns outward."""
    step = 4.0  # arcsec; the rings are linear between knots, a fine table looks them up fast
    radius = np.arange(0, 7000, step)
    cosines = np.cos(np.interp(radius, rings[:, 0], np.radians(rings[:, 3]))).astype(np.float32)
    angles = np.interp(radius, rings[:, 0], np.unwrap(np.radians(rings[:, 4])))
    sines, cosPA = np.sin(angles).astype(np.float32), np.cos(angles).astype(np.float32)

    def inDisc(r):
        k = np.minimum((r / step).astype(np.int32), len(radius) - 2)
        f = r / step - k.astype(np.float32)
        s, c, cosi = (t[k] + f * (t[k + 1] - t[k]) for t in (sines, cosPA, cosines))
        return east * s + north * c, (east * c - north * s) / cosi, cosi

    low = np.hypot(east, north)
    high = low / cosines.min()
    for _ in range(14):
        r = (low + high) / 2
        u, w, _ = inDisc(r)
        outside = u * u + w * w > r * r
        low, high = np.where(outside, r, low), np.where(outside, high, r)
    u, w, cosi = inDisc((low + high) / 2)
    r = np.hypot(u, w)
    turn = np.interp(r, radius, angles - angles[0]).astype(np.float32)
    return r, np.arctan2(w, u) + turn, cosi


# ---------------------------------------------------------------------------- noise
class Noise:
    """One octave of smooth noise that repeats after `tile` wavelengths, of unit variance."""
    tile, points = 32, 512

    def __init__(self, random):
        k = np.hypot(*np.meshgrid(*2 * [np.fft.fftfreq(self.points, 1 / self.points)]))
        band = np.exp(-((k / self.tile - 1) / 0.4)**2 / 2)
        field = np.fft.ifft2(np.fft.fft2(random.standard_normal((self.points, ) * 2)) * band).real
        self.field = (field / field.std()).astype(np.float32).ravel()

    def __call__(self, x, y):
        """Bilinear value at x, y in wavelengths."""
        x, y = x * (self.points // self.tile), y * (self.points // self.tile)
        column, row = np.floor(x), np.floor(y)
        fx, fy = x - column, y - row
        column, row = column.astype(np.int32), row.astype(np.int32)
        mask = self.points - 1
        left, right = column & mask, (column + 1) & mask
        below, above = (row & mask) * self.points, ((row + 1) & mask) * self.points
        f = self.field.take
        low, high = f(below + left), f(above + left)
        low += fx * (f(below + right) - low)
        high += fx * (f(above + right) - high)
        return low + fy * (high - low)


def fractal(noise, x, y, octaves, gain=0.55):
    """Octaves of noise, of unit variance: clouds."""
    total, power = 0, 0
    for octave in range(octaves):
        amplitude = np.float32(gain**octave)
        total = total + amplitude * noise(x * 2**octave + 7.3 * octave, y * 2**octave + 3.1 * octave)
        power += amplitude**2
    return total / np.sqrt(power)


def ridged(noise, places, gain=0.62):
    """Crests of noise, each octave stronger upon the crests of the one before: filaments, 0 to 1.
    `places` are the coordinates of each octave, in its wavelengths."""
    total, weight, norm, amplitude = 0, 1, 0, np.float32(1)
    for x, y in places:
        n = noise(x, y)
        crest = weight / (1 + 5 * n * n)
        total = total + amplitude * crest
        norm += amplitude
        amplitude *= np.float32(gain)
        weight = 0.2 + 0.8 * crest
    return total / norm


def smooth(x, low, high):
    """0 below `low`, 1 above `high`, without a kink between."""
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


# ---------------------------------------------------------------------------- files
def write(folder, name, image, grid, unit, notes, beam=None):
    wcs = WCS(naxis=2)
    wcs.wcs.ctype = ["RA---" + grid.projection, "DEC--" + grid.projection]
    wcs.wcs.crval, wcs.wcs.crpix = [RA, DEC], 2 * [(grid.size + 1) / 2]
    wcs.wcs.cdelt = [-grid.scale / 3600, grid.scale / 3600]
    wcs.wcs.cunit = ["deg", "deg"]
    wcs.wcs.radesys, wcs.wcs.equinox = "ICRS", 2000.0
    header = wcs.to_header()
    header["OBJECT"] = "M83 (mock)"
    header["BUNIT"] = unit
    for key, value in (beam or {}).items():
        header[key] = value
    header["MOCK"] = (True, "painted, not observed")
    for line in ["MOCK IMAGE: painted by Examples/M83/make_images.py, not observed."] + notes:
        header.add_comment(line)
    path = folder / name
    fits.PrimaryHDU(image.astype(np.float32), header).writeto(path, overwrite=True)
    return path


class Progress:
    def __init__(self, steps):
        self.steps, self.done, self.start = steps, 0, time.perf_counter()

    def __call__(self, what):
        self.done += 1
        print(f"[{self.done}/{self.steps}] {time.perf_counter() - self.start:5.1f} s  {what}", flush=True)
