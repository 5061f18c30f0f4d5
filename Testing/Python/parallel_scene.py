"""Pictures of a view, drawn by as many processes as pvbatch, or a server, has.
Usage: parallel_scene.py FOLDER [PORT]

model.png: a galaxy that each process has, and a ball, before black; before_green.png: before another
background; parts.png: particles of which each process has a part.
"""
import os
import sys

from paraview import simple

import galaxy_testing as gt

PARTS = """
import numpy as np
from vtkmodules.vtkParallelCore import vtkMultiProcessController
processes = vtkMultiProcessController.GetGlobalController()
mine = slice(processes.GetLocalProcessId(), None, processes.GetNumberOfProcesses())
rng = np.random.default_rng(1)
places = rng.uniform(-8, 8, (2000, 3))
light = np.where(np.arange(2000)[:, None] % 2, rng.uniform(0, 1, (2000, 3)), 0)
dust = np.where(np.arange(2000)[:, None] % 2, 0, rng.uniform(0, 0.1, (2000, 3)))
output.Points = places[mine].astype(np.float32)
for name, values in (("Emission", light), ("Absorption", dust), ("SmoothingLength", np.full(2000, 0.8))):
    output.PointData.append(values[mine].astype(np.float32), name)
"""


def main(folder, port=None):
    gt.load_plugin()
    if port:
        simple.Connect("localhost", int(port))
        simple.LoadPlugin(os.environ["GALAXY_PLUGIN"], remote=True, ns=vars(simple))
    model = simple.GalaxyModel(Input=simple.GalaxyReader(FileName=gt.M83), ParticleScale=0.02)
    view = simple.CreateView("RenderView", ViewSize=[200, 200], UseColorPaletteForBackground=0,
                             Background=[0, 0, 0], OrientationAxesVisibility=0)
    view.UseFXAA = 0  # smooths the picture of several processes, of one only what is no particle
    view.RemoteRenderThreshold = 0  # each process draws what it has
    simple.Show(model, view).Exposure = 0.5
    simple.Show(simple.Sphere(Radius=3, Center=[4, 0, 2]), view)
    view.CameraPosition, view.CameraFocalPoint = [0, -25, 25], [0, 0, 0]
    view.CameraViewUp = [0, 1, 1]

    def save(name):
        simple.SaveScreenshot(os.path.join(folder, name), view, ImageResolution=[200, 200])

    save("model.png")
    view.Background = [0.1, 0.3, 0.1]
    save("before_green.png")
    view.Background = [0, 0, 0]
    simple.Hide(model, view)
    parts = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=PARTS)
    display = simple.Show(parts, view)
    display.Representation = "Splats"
    display.Exposure = 0.3
    save("parts.png")


main(*sys.argv[1:])
