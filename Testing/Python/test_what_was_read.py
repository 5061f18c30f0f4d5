"""What GalaxyReader has read travels: whatever then becomes of the files, nothing downstream reads
them again, here or on a server."""
import os
import shutil
import unittest

import numpy as np
from astropy.io import fits
from paraview import simple

import galaxy_testing as gt

gt.load_plugin()

# Every key that names a file.
GALAXY = """
[galaxy]
name = "made"
ra = 10
dec = 20
distance = 5
rings = "g.rings"
[image.r]
file = "r.fits"
mask = "bad.fits"
regions = "bad.reg"
[image.wide]
file = "wide.fits"
[image.both]
combine = ["r", "wide"]
signal_above = 0
[[component]]
name = "gas"
particles = 3000
layers = [{ image = "r", clip = [0, 2] }]
[component.thickness]
model = "Flared"
profile_table = "widths.txt"
[[component]]
name = "stars"
particles = 2000
layers = [{ image = "both", clip = [0, 2] }]
[[component]]
name = "clusters"
type = "Spheroid"
particles = 500
[component.spheroid]
luminosity = 1
cluster_list = "clusters.csv"
[[component]]
name = "halo"
type = "Spheroid"
particles = 500
[component.spheroid]
profile = "Plummer"
shells = "shells.csv"
"""
TABLES = {
    "g.rings": "# r vrot Z0 i PA\n0 0 2 30 40\n300 200 2 30 60\n",
    "widths.txt": "0 0.3\n10 0.9\n",
    "clusters.csv": "x,y,z\n1,2,3\n-1,0,2\n",
    "shells.csv": "semi_major,axis_ratio_b,axis_ratio_c,position_angle\n1,1,0.5,20\n9,0.8,0.5,60\n",
    "bad.reg": "image\ncircle(20,30,3)\n",
}


def write_image(path, values, pixel=10.0):
    header = fits.Header()
    size = values.shape[0]
    header.update(CTYPE1="RA---TAN", CTYPE2="DEC--TAN", CRVAL1=10.0, CRVAL2=20.0,
                  CRPIX1=(size + 1) / 2, CRPIX2=(size + 1) / 2, CDELT1=-pixel / 3600,
                  CDELT2=pixel / 3600, BMAJ=pixel * 2 / 3600, BMIN=pixel * 2 / 3600, BPA=0.0)
    fits.PrimaryHDU(values.astype(np.float32), header).writeto(path, overwrite=True)


class WhatWasRead(gt.FolderTest):
    def setUp(self):
        super().setUp()
        for name, text in {**TABLES, "g.galaxy": GALAXY}.items():
            with open(self.path(name), "w", encoding="ascii") as file:
                file.write(text)
        y, x = np.mgrid[0:60, 0:60]
        light = np.exp(-np.hypot(x - 29.5, y - 29.5) / 10)
        write_image(self.path("r.fits"), light)
        write_image(self.path("wide.fits"), light[::2, ::2], 20.0)
        write_image(self.path("bad.fits"), (np.hypot(x - 40, y - 20) < 3) * 1.0)

    def pipelines(self, reader):
        """What the plugin makes of a galaxy, before anything has been built."""
        seeds = simple.DiskSeeds(Input=reader, Component="gas")
        return {
            "model": simple.GalaxyModel(Input=reader),
            "thickness": simple.DiskThickness(Input=seeds),
            "dust": simple.DustFilaments(Input=simple.DiskSeeds(Input=reader, Component="stars")),
        }

    @staticmethod
    def made(pipelines):
        made = {}
        for name, proxy in pipelines.items():
            proxy.UpdatePipeline()
            made[name] = np.column_stack([gt.points_of(proxy), gt.light_of(proxy)])
        return made

    def gone(self):
        shutil.rmtree(self.folder)
        os.mkdir(self.folder)

    def judge(self, change):
        reader = simple.GalaxyReader(FileName=self.path("g.galaxy"))
        expected = self.made(self.pipelines(reader))
        simple.Delete(reader)
        reader = simple.GalaxyReader(FileName=self.path("g.galaxy"))
        reader.UpdatePipeline()
        change()
        found = self.made(self.pipelines(reader))
        for name, values in expected.items():
            self.assertGreater(len(values), 500, name)
            np.testing.assert_array_equal(found[name], values, name)

    def test_files_may_go(self):
        self.judge(self.gone)

    def test_files_may_change(self):
        def change():
            for name in os.listdir(self.folder):
                with open(self.path(name), "w", encoding="ascii") as file:
                    file.write("changed\n")

        self.judge(change)

    def test_files_may_go_on_a_server(self):
        with gt.server():
            self.judge(self.gone)

    def test_files_may_go_after_a_state_was_loaded(self):
        reader = simple.GalaxyReader(registrationName="galaxy", FileName=self.path("g.galaxy"))
        simple.GalaxyModel(registrationName="model", Input=reader).UpdatePipeline()
        state = self.path("state.pvsm")
        simple.SaveState(state)
        simple.ResetSession()
        simple.LoadState(state)
        model = simple.FindSource("model")
        model.UpdatePipeline()
        self.gone()
        with gt.Messages() as messages:
            model.RandomSeed = 2
            model.UpdatePipeline()
        self.assertEqual(messages.text, "")
        self.assertGreater(gt.count_of(model), 3000)

    def test_a_group_reads_no_member_again(self):
        with open(self.path("g.galaxygroup"), "w", encoding="ascii") as file:
            file.write("[group]\n[[member]]\ngalaxy = 'g.galaxy'\n")
        group = simple.GalaxyGroup(FileName=self.path("g.galaxygroup"))
        group.UpdatePipeline()
        self.gone()
        with gt.Messages() as messages:
            picture = simple.SplatImage(Input=group, ImageSize=[32, 32])
            picture.UpdatePipeline()
        self.assertEqual(messages.text, "")
        self.assertGreater(gt.array(picture, "Radiance").sum(), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
