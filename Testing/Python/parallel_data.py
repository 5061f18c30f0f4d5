"""What as many processes as pvbatch has make of particles, in all. Usage: parallel_data.py FOLDER

data.json: points, rows and counts by their names; image.fits, particles.g2: what the writers make.
"""
import json
import os
import sys

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import galaxy_testing as gt

GROUP = os.path.join(gt.ROOT, "Examples", "M83Group", "m83group.galaxygroup")
RINGS = os.path.join(gt.ROOT, "Examples", "M83", "m83.rings")
# A cloud of which each process has a part, of composite data.
PARTS = """
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkParallelCore import vtkMultiProcessController
processes = vtkMultiProcessController.GetGlobalController()
places = np.random.default_rng(1).normal(0, 1, (900, 3)).astype(np.float32)
mine = np.array_split(places, processes.GetNumberOfProcesses())[processes.GetLocalProcessId()]
output = self.GetOutputDataObject(0)
for k, block in enumerate(np.array_split(mine, 2)):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(block, deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    light = numpy_to_vtk(1 + block[:, 0] ** 2, deep=True)
    light.SetName("Intensity")
    data.GetPointData().AddArray(light)
    output.SetBlock(k, data)
"""


def main(folder):
    gt.load_plugin()
    results = {}
    sources = {"galaxy": simple.GalaxyReader(FileName=gt.M83)}
    seeds = simple.DiskSeeds(Input=sources["galaxy"], Component="gas", ParticleScale=0.002)
    model = simple.GalaxyModel(Input=sources["galaxy"], ParticleScale=0.002)
    parts = simple.ProgrammableSource(OutputDataSetType="vtkMultiblockDataSet", Script=PARTS)
    lengths = simple.SmoothingLength(Input=parts)
    image = simple.SplatImage(Input=model, ImageSize=[60, 50], CameraPosition=[0, -25, 25])
    sources.update(
        rings=simple.TiltedRingReader(FileName=RINGS),
        seeds=seeds, particles=simple.DiskThickness(Input=seeds), model=model,
        dust=simple.DustFilaments(Input=seeds, Model="Fractal"),
        spheroid=simple.Spheroid(NumberOfParticles=1000),
        group=simple.GalaxyGroup(FileName=GROUP, ParticleScale=0.0005), parts=parts,
        lengths=lengths, image=image,
        parts_image=simple.SplatImage(Input=lengths, ImageSize=[20, 20], CameraPosition=[0, 0, 9]))
    for name, proxy in sources.items():
        proxy.UpdatePipeline()
        results[name] = proxy.GetDataInformation().GetNumberOfPoints()
    for name in ("model", "image"):
        array = "Intensity" if name == "model" else "Radiance"
        histogram = simple.Histogram(Input=sources[name], SelectInputArray=["POINTS", array])
        histogram.UpdatePipeline()
        table = servermanager.Fetch(histogram)
        if table.GetNumberOfRows():
            counts = table.GetRowData().GetArray("bin_values")
            results[name + " histogram"] = int(vtk_to_numpy(counts).sum())
    simple.SaveData(os.path.join(folder, "model.csv"), proxy=model)
    simple.SaveData(os.path.join(folder, "image.fits"), proxy=image)
    simple.SaveData(os.path.join(folder, "parts.fits"), proxy=sources["parts_image"])
    simple.SaveData(os.path.join(folder, "particles.g2"), proxy=model)
    simple.SaveData(os.path.join(folder, "parts.g2"), proxy=lengths)
    if vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 0:
        with open(os.path.join(folder, "model.csv")) as table:
            results["rows"] = len(table.readlines()) - 1
        with open(os.path.join(folder, "data.json"), "w") as file:
            json.dump(results, file)


main(*sys.argv[1:])
