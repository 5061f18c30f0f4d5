#!/usr/bin/env python3
"""Paints mock images of M83 in the bands that the paper used, as FITS files with coordinates.

    python3 make_images.py OUTPUT_FOLDER

They are paintings, not observations: arms, bar and dust lanes follow the real galaxy's outline,
everything finer is noise from a fixed seed. They hold no star, no sky and no background, as
cleaned images do. Needs numpy and astropy.

Every structure is painted in the disc's own coordinates: r (arcsec) and phi, the angle in the
disc from the receding major axis in the sense North through East. Tilted rings (m83.rings) carry
them to the sky. M83 turns clockwise, its arms trail: they wind outward with increasing phi.
"""
import os
import sys
import warnings
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

# Functions that numpy has for AVX-512 alone round in their own way, and where clusters are born a
# last digit decides: without them the images are the same on every machine.
os.environ.setdefault("NPY_DISABLE_CPU_FEATURES", "AVX512F AVX512CD AVX512_SKX AVX512_CLX "
                                                  "AVX512_CNL AVX512_ICL")
with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # numpy says which of them a machine has not
    import numpy as np

from painting import Grid, Noise, Progress, fractal, ridged, smooth, write

SEED = 5236
HERE = Path(__file__).resolve().parent

BAR_ANGLE = np.radians(50 - 227)  # the bar's position angle 50, counted from the major axis

# The ridges of the two arms: position angle (unwound) and radius in arcsec, from the bar's ends.
NORTH_EAST_ARM = [(20, 96), (50, 107), (90, 121), (140, 139), (174, 156), (200, 182), (235, 220),
                  (265, 264), (312, 352), (345, 425), (380, 505), (430, 640), (480, 790)]
SOUTH_WEST_ARM = [(200, 96), (230, 107), (270, 124), (320, 148), (360, 178), (390, 206),
                  (420, 229), (450, 249), (480, 271), (510, 305), (537, 345), (570, 410),
                  (610, 500), (660, 640), (710, 800)]
# Branches, fainter: north of the bar's western end, and in the south.
BRANCHES = [[(318, 148), (332, 185), (350, 232), (372, 300), (395, 380)],
            [(150, 142), (172, 185), (193, 236), (218, 310), (240, 380)],
            [(30, 205), (62, 262), (95, 330), (120, 400)]]
# In the H I only: the arms go on, and a long tail leaves in the south-west for the north.
HI_ARMS = [([(290, 330), (320, 395), (350, 480), (385, 610), (425, 800), (465, 1030), (505, 1300),
             (545, 1650)], 1.0),
           ([(520, 330), (555, 415), (590, 540), (630, 720), (665, 930), (700, 1180),
             (730, 1420)], 0.8),
           ([(200, 900), (235, 1180), (268, 1560), (296, 2050), (318, 2600), (334, 3200),
             (346, 3900)], 1.3),
           ([(40, 900), (85, 1150), (130, 1500), (170, 1950), (200, 2400)], 0.5)]


# ---------------------------------------------------------------------------- the galaxy's anatomy
class Anatomy:
    """What a point of the disc is made of; all fields are dimensionless, about 0 to 1."""

    def __init__(self, grid, noise):
        self.noise = noise
        self.r, self.phi = grid.r, grid.phi
        x, y = self.sheared(0.9)
        wobble = 0.045 * fractal(noise, x / 200, y / 200, 4)
        wobble += 0.06 * smooth(self.r, 350, 1100) * fractal(noise, x / 1100 + 2, y / 1100, 4)
        self.logR = np.log(self.r + 1e-3) + wobble
        self.warpedPhi = self.phi + 0.10 * fractal(noise, x / 240 + 9, y / 240 + 5, 3)
        self.along, self.across = (self.r * f(self.phi - BAR_ANGLE) for f in (np.cos, np.sin))
        self.ridges = {}
        self.web = self.filaments()
        self.clumps = self.clouds(46)

    def sheared(self, winding):
        """Plane coordinates wound up by rotation: round noise in them becomes trailing spurs."""
        angle = self.phi - np.float32(winding) * np.log(self.r + 25)
        return self.r * np.cos(angle), self.r * np.sin(angle)

    def ridge(self, knots):
        """Of the arm's nearest turn: the distance in ln r and the degrees from the arm's root."""
        if id(knots) not in self.ridges:
            angle, radius = np.radians([p[0] - 227 for p in knots]), np.log([p[1] for p in knots])
            nearest, place = np.full_like(self.r, 9), np.zeros_like(self.r)
            for turn in range(-1, 3):
                phi = self.warpedPhi + np.float32(2 * np.pi * turn)
                inside = np.flatnonzero((phi > angle[0]) & (phi < angle[-1]))
                phi = phi.ravel()[inside]
                d = self.logR.ravel()[inside] - np.interp(phi, angle, radius).astype(np.float32)
                closer = np.abs(d) < np.abs(nearest.ravel()[inside])
                nearest.ravel()[inside[closer]] = d[closer]
                place.ravel()[inside[closer]] = np.degrees(phi[closer] - np.float32(angle[0]))
            self.ridges[id(knots)] = nearest, place
        return self.ridges[id(knots)]

    def arm(self, knots, width, offset=0, fadeIn=30, fadeOut=(300, 400)):
        """Crest of an arm; width and offset (outward positive) as fractions of the radius."""
        d, t = self.ridge(knots)
        return (smooth(t, 0, fadeIn) * (1 - smooth(t, *fadeOut))
                * np.exp(-0.5 * ((d - offset) / width)**2))

    def arms(self, width, offset=0, fadeOut=(255, 345)):
        """Both arms, the south-western one the longer, and the branches."""
        main = np.maximum(self.arm(NORTH_EAST_ARM, width, offset, fadeOut=fadeOut),
                          0.9 * self.arm(SOUTH_WEST_ARM, width, offset,
                                         fadeOut=(fadeOut[0] + 60, fadeOut[1] + 60)))
        for knots in BRANCHES:
            main = np.maximum(main, 0.55 * self.arm(knots, 0.8 * width, offset, 20, (45, 88)))
        return main

    def bar(self):
        boxy = (np.abs(self.along / 104)**2.2 + np.abs(self.across / 36)**2.2)**(1 / 2.2)
        return np.exp(-2.0 * boxy**1.7)

    def barLanes(self, width=4.0):
        """Dust along the bar's leading edges, from the nuclear ring to the roots of the arms."""
        wiggle = 5 * fractal(self.noise, self.along / 50, self.across / 50, 3)
        reach = np.abs(self.along)
        lane = -np.sign(self.along) * (14 * np.tanh(reach / 25) + (reach / 95)**4 * 5) + wiggle
        ends = smooth(reach, 4, 14) * (1 - smooth(reach, 88, 118))
        return np.exp(-0.5 * ((self.across - lane) / width)**2) * ends

    def strands(self, count, pitch, bend, sharpness):
        """Spiral fringes, `count` around the disc, bent by clouds until they branch and break."""
        phase = count * (self.phi - np.log(self.r + 18) / np.tan(np.radians(pitch)))
        return (0.5 + 0.5 * np.cos(phase + bend))**sharpness

    def filaments(self):
        """A web between and across the arms: the cold gas as 8 micron sees it."""
        x, y = self.sheared(0.8)
        bend = fractal(self.noise, x / 150 + 3, y / 150 + 11, 4, 0.45)
        other = fractal(self.noise, x / 80 + 21, y / 80 + 6, 4, 0.45)
        patches = np.exp(0.7 * fractal(self.noise, x / 95 + 8, y / 95 + 15, 3, 0.6) - 0.25)
        fine = ridged(self.noise, [(x * f / 50 + 0.5 * bend, y * f / 50 - 0.5 * other)
                                   for f in np.float32([1, 2, 4, 8])])
        strands = (self.strands(6, 20, 2.6 * bend, 5) * patches
                   + 0.7 * self.strands(13, 30, 2.8 * other, 5)
                   + 0.35 * self.strands(27, 42, 3.5 * bend + 2 * other, 4) * patches
                   * smooth(self.r, 70, 200))
        return 0.55 * strands * (0.55 + 0.9 * fine) + 0.12 * fine

    def clouds(self, scale, winding=1.0, octaves=5):
        x, y = self.sheared(winding)
        return fractal(self.noise, x / scale + 1.7, y / scale + 4.2, octaves, 0.75)


def dustOpacity(anatomy):
    """Optical depth in V through the disc."""
    r, web = anatomy.r, anatomy.web
    lanes = np.maximum(anatomy.arms(0.045, -0.07), 0.8 * anatomy.arms(0.020, 0.03))
    disc = np.exp(-r / 190) * smooth(r, 20, 130) * (1 - smooth(r, 300, 480))
    ragged = (0.15 + 2.6 * web) * np.exp(0.5 * anatomy.clumps - 0.12)
    nucleus = 0.3 * np.exp(-0.5 * (r / 8)**2)
    return (2.6 * web**1.3 * disc + 1.7 * lanes * ragged * np.exp(-(r / 340)**2)
            + 1.9 * anatomy.barLanes() * (0.3 + 1.8 * web) + nucleus)


def starFormation(anatomy):
    """Where stars form now: beads on the arms, spurs, bar ends, the nucleus, the outer arms."""
    r, web = anatomy.r, anatomy.web
    clumps = np.exp(1.3 * anatomy.clumps - 0.8)
    gas = 0.1 + 2.5 * web
    arms = anatomy.arms(0.045, 0.02) + 0.25 * anatomy.arms(0.15, 0.06)
    outer = anatomy.arms(0.08, 0.0, fadeOut=(400, 490)) * smooth(r, 260, 420)
    disc = 0.07 * smooth(r, 90, 170) * np.exp(-r / 150)
    return (clumps * gas * (arms * np.exp(-r / 230) * np.exp(-(r / 400)**6) + disc
                            + 0.022 * outer * (1 - smooth(r, 480, 740)))
            + 1.0 * np.exp(-0.5 * (r / 8)**2))


# ---------------------------------------------------------------------------- young clusters
class Clusters:
    """H II regions and associations: places drawn from the star formation, power-law luminosities.
    Each is a handful of knots; where little forms, none is bright."""

    def __init__(self, grid, formation, random, count=14000, knots=4, slope=1.75):
        odds = np.cumsum(formation.ravel(), dtype=float)
        pixel = np.searchsorted(odds, random.random(count) * odds[-1])
        power, brightest = 1 - slope, 500.0
        light = (1 + random.random(count) * (brightest**power - 1))**(1 / power)
        crowd = np.sqrt(formation.ravel()[pixel] / np.percentile(formation, 99))
        light = light**np.clip(0.45 + 0.55 * crowd, 0, 1)
        spread = 1.0 * light**0.33  # arcsec
        share = random.dirichlet(np.full(knots, 0.8), count)
        east = grid.east[0, pixel % grid.size] + (random.random(count) - 0.5) * grid.scale
        north = grid.north[pixel // grid.size, 0] + (random.random(count) - 0.5) * grid.scale
        self.east = (east[:, None] + spread[:, None] * random.standard_normal((count, knots))).ravel()
        self.north = (north[:, None] + spread[:, None] * random.standard_normal((count, knots))).ravel()
        self.light = (light[:, None] * share).ravel()
        self.ionised = np.repeat(random.random(count) < 0.6, knots)

    def image(self, grid, light, smallest, growth):
        """The knots as Gaussians whose width grows with their light; surface brightness."""
        fwhm = smallest * np.maximum(self.light / np.median(self.light), 1)**growth
        classes = np.rint(np.log(fwhm / smallest) / np.log(1.6)).astype(int)
        return grid.summed([(grid.deposit(self.east[classes == k], self.north[classes == k],
                                          light[classes == k]), smallest * 1.6**k)
                            for k in np.unique(classes)]) / grid.scale**2


# ---------------------------------------------------------------------------- the bands
def redContinuum(grid, anatomy, opacity, clusters):
    """Old stars: exponential disc with a break, bulge, bar, broad arms, behind half the dust."""
    r = anatomy.r
    disc = np.exp(-r / 115) * np.exp(-(r / 440)**5)
    patches = np.exp(0.25 * anatomy.clouds(210, 1.5, 3))
    arms = 0.80 * anatomy.arms(0.14, 0.04) + 0.40 * anatomy.arms(0.055, 0.02)
    stars = disc * (0.45 + 0.4 * smooth(r, 30, 140) + arms * patches) * np.exp(0.08 * anatomy.clumps)
    bulge = 8 * np.exp(-(r / 5.5)**0.75) + 1.5 * np.exp(-r / 20)
    light = stars + 2.0 * anatomy.bar() + bulge
    young = clusters.image(grid, clusters.light, 2.0, 0.2)
    return grid.blurred((light + 0.12 * young) * throughDust(0.84 * opacity), 1.6)


def throughDust(tau):
    """Stars before, in and behind a sheet of dust in the mid-plane."""
    return 0.35 + 0.65 * np.exp(-tau)


def hAlpha(grid, anatomy, opacity, formation, clusters):
    """H II regions and the diffuse ionised gas around them."""
    ionising = clusters.light * clusters.ionised
    regions = clusters.image(grid, ionising, 1.7, 0.17)
    haloes = clusters.image(grid, ionising, 6.0, 0.2)
    texture = 0.15 + 2.8 * anatomy.web
    light = regions + (0.6 * haloes + 0.9 * grid.blurred(formation, 8)) * texture
    light = light * (1 - smooth(anatomy.r, 400, 480)) * (0.25 + 0.75 * np.exp(-0.82 * opacity))
    return grid.blurred(light, 1.6)


def ultraviolet(grid, anatomy, opacity, formation, clusters, near):
    """Young associations; the near-UV smoother, redder and less extinguished than the far-UV."""
    r = anatomy.r
    knots = clusters.image(grid, clusters.light**0.9, 3.0, 0.15)
    aged = np.exp(-r / 125) * np.exp(-(r / 420)**4) * (0.5 + 1.6 * anatomy.arms(0.12, 0.06))
    light = 0.7 * knots + 2.0 * grid.blurred(formation, 9) + (0.40 if near else 0.15) * aged
    light = light * (0.2 + 0.8 * np.exp(-(1.3 if near else 1.2) * opacity))
    return grid.blurred(light, 5.3 if near else 4.3)


def eightMicron(grid, anatomy, opacity, formation, clusters):
    """PAH dust: the web of filaments, lit by the star formation, brightest along the arms."""
    heated = 0.4 + 1.6 * grid.blurred(formation, 18)
    knots = clusters.image(grid, clusters.light, 2.4, 0.2)
    r = anatomy.r
    light = opacity * heated + 0.25 * knots + 0.04 * np.exp(-r / 110) + 1.2 * np.exp(-0.5 * (r / 5)**2)
    return grid.blurred(light, 2.0)


def neutralHydrogen(anatomy):
    """Face-on H I surface density, Msun/pc^2, to the last wisp."""
    r = anatomy.r
    inner = (7.0 * smooth(r, 10, 120) + 1.4) * np.exp(-(r / 420)**3)
    clumps = np.exp(0.35 * anatomy.clumps - 0.06)
    inner = inner * clumps * (0.25 + 0.7 * anatomy.arms(0.10, 0.0, fadeOut=(330, 420)) + 1.6 * anatomy.web)
    x, y = anatomy.sheared(2.0)
    bend = fractal(anatomy.noise, x / 600, y / 600, 4, 0.5)
    strands = (anatomy.strands(4, 15, 2.6 * bend, 3)
               + 0.6 * anatomy.strands(9, 22, 3.2 * bend, 4)) * np.exp(0.4 * bend)
    ragged = np.exp(0.6 * anatomy.clouds(420, 1.6, 4) - 0.18) * (0.25 + 1.2 * strands)
    outer = 2.4 * np.exp(-r / 600) * smooth(r, 180, 450) + 0.10 * np.exp(-(r / 2300)**2)
    arms = 0
    for knots, strength in HI_ARMS:
        span = knots[-1][0] - knots[0][0]
        crest = anatomy.arm(knots, 0.06, 0, 50, (0.6 * span, span))
        skirt = anatomy.arm(knots, 0.16, 0.04, 50, (0.6 * span, span))
        arms = arms + strength * (crest + 0.3 * skirt)
    lit = outer * ragged + 4.4 * arms * np.exp(-r / 1500) * (0.45 + 0.6 * ragged)
    halo = 0.05 * np.exp(-(r / 3300)**2) * np.exp(0.6 * anatomy.clouds(1500, 1.5, 4) - 0.18)
    return (inner + lit + halo) * (1 - smooth(r, 4300, 5230))


# ---------------------------------------------------------------------------- files
def paintDisc(folder, rings, noise, random, progress):
    wide = Grid(768, 2.0, "TAN", rings)
    wideAnatomy = Anatomy(wide, noise)
    wideFormation = starFormation(wideAnatomy)
    clusters = Clusters(wide, wideFormation, random)
    clusters.light *= wideFormation.sum() * wide.scale**2 / clusters.light.sum()
    opacity = dustOpacity(wideAnatomy)
    progress(f"young clusters: {len(clusters.light)}")
    for band, near in (("nuv", True), ("fuv", False)):
        image = ultraviolet(wide, wideAnatomy, opacity, wideFormation, clusters, near)
        write(folder, f"m83_{band}.fits", image, wide, "count/s", ["After a GALEX image, cleaned."])
        progress(f"m83_{band}.fits")

    fine = Grid(1024, 0.95, "TAN", rings)
    anatomy = Anatomy(fine, noise)
    formation, opacity = starFormation(anatomy), dustOpacity(anatomy)
    progress("dust and star formation")
    bands = {
        "r": (redContinuum(fine, anatomy, opacity, clusters), "count/s", "After a SINGG R image, cleaned."),
        "halpha": (hAlpha(fine, anatomy, opacity, formation, clusters), "count/s",
                   "After a SINGG continuum-subtracted H alpha image, cleaned."),
        "8um": (20 * eightMicron(fine, anatomy, opacity, formation, clusters), "MJy/sr",
                "After a Spitzer IRAC 8 micron image, cleaned."),
    }
    for band, (image, unit, note) in bands.items():
        write(folder, f"m83_{band}.fits", image, fine, unit, [note])
        progress(f"m83_{band}.fits")


def paintHydrogen(folder, rings, noise, progress):
    """The three weightings: the sharper the beam, the less of the faint gas it holds."""
    for name, scale, beam, floor in (("low", 22, 130, 0.004), ("medium", 10, 48, 0.08),
                                     ("high", 4.7, 16, 0.45)):
        grid = Grid(512, scale, "SIN", rings)
        density = neutralHydrogen(Anatomy(grid, noise)) / grid.cosi
        density = grid.blurred(density, beam)
        half = grid.size * scale / 2
        field = 1 - smooth(np.hypot(grid.east, grid.north), 0.75 * half, 0.98 * half)
        density = np.maximum(density * field - floor, 0)
        # 1 Msun/pc^2 is 1.249e20 atoms/cm^2; N = 1.104e21 I[Jy/beam m/s] / (beam in arcsec)^2
        image = density * 1.249e20 * beam**2 / 1.104e21
        axes = {"BMAJ": beam / 3600, "BMIN": beam / 3600, "BPA": 0.0, "RESTFRQ": 1420405751.77}
        write(folder, f"m83_hi_{name}.fits", image, grid, "Jy/beam m/s",
              ["After an ATCA H I intensity map, cleaned."], axes)
        flux = image.sum() * scale**2 / (1.1331 * beam**2) / 1000
        progress(f"m83_hi_{name}.fits: {flux:.0f} Jy km/s")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    rings, random = np.loadtxt(HERE / "m83.rings"), np.random.default_rng(SEED)
    noise, progress = Noise(random), Progress(11)
    progress("noise")
    with ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(paintDisc, folder, rings, noise, random, progress),
                pool.submit(paintHydrogen, folder, rings, noise, progress)]
        for job in jobs:
            job.result()


if __name__ == "__main__":
    main()
