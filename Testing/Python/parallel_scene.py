"""Pictures of a view, drawn by as many processes as pvbatch, or a server, has.
Usage: parallel_scene.py FOLDER [PORT]

All with ParaView's default settings. model.png: a galaxy and a ball before black; before_green.png:
before another background; translucent.png: with a ball that one sees through; parts.png: particles
of which each process has a part; copies.png: such that each process has. statistics.txt: what the
display says of model.png.
"""
import os
import sys

from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import galaxy_testing as gt

PARTICLES = """
import numpy as np
from vtkmodules.vtkParallelCore import vtkMultiProcessController
processes = vtkMultiProcessController.GetGlobalController()
mine = slice(processes.GetLocalProcessId(), None, processes.GetNumberOfProcesses()) if %s else slice(None)
rng = np.random.default_rng(1)
places = rng.uniform(-8, 8, (2000, 3))
light = np.where(np.arange(2000)[:, None] & 1, rng.uniform(0, 1, (2000, 3)), 0)
dust = np.where(np.arange(2000)[:, None] & 1, 0, rng.uniform(0, 0.1, (2000, 3)))
output.Points = places[mine].astype(np.float32)
for name, values in (("Emission", light), ("Absorption", dust), ("SmoothingLength", np.full(2000, 0.8))):
    output.PointData.append(values[mine].astype(np.float32), name)
"""


def main(folder, port=None):
    gt.load_plugin()
    processes = vtkMultiProcessController.GetGlobalController()
    if port:
        simple.Connect("localhost", int(port))
        simple.LoadPlugin(os.environ["GALAXY_PLUGIN"], remote=True, ns=vars(simple))
    model = simple.GalaxyModel(Input=simple.GalaxyReader(FileName=gt.M83), ParticleScale=0.02)
    view = simple.CreateView("RenderView", ViewSize=[200, 200], UseColorPaletteForBackground=0,
                             Background=[0, 0, 0], OrientationAxesVisibility=0)
    view.RemoteRenderThreshold = 0  # each process draws what it has
    display = simple.Show(model, view)
    display.Exposure = 0.5
    ball = simple.Show(simple.Sphere(Radius=3, Center=[4, 0, 2]), view)
    view.CameraPosition, view.CameraFocalPoint = [0, -25, 25], [0, 0, 0]
    view.CameraViewUp = [0, 1, 1]

    def save(name):
        simple.SaveScreenshot(os.path.join(folder, name), view, ImageResolution=[200, 200])

    save("model.png")
    display.UpdatePropertyInformation()
    if processes.GetLocalProcessId() == 0:
        with open(os.path.join(folder, "statistics.txt"), "w") as file:
            file.write(f"{display.ActiveEffects}\n{display.RenderStatistics}\n")
    view.Background = [0.1, 0.3, 0.1]
    save("before_green.png")
    ball.Opacity = 0.5
    save("translucent.png")
    ball.Opacity = 1
    view.Background = [0, 0, 0]
    simple.Hide(model, view)
    for name, are_parts in (("parts", True), ("copies", False)):
        parts = simple.ProgrammableSource(OutputDataSetType="vtkPolyData",
                                          Script=PARTICLES % are_parts)
        display = simple.Show(parts, view)
        display.Representation = "Splats"
        display.Exposure = 0.3
        save(name + ".png")
        simple.Hide(parts, view)


main(*sys.argv[1:])
