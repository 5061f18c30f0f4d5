"""Opens the M83 scene in ParaView's window: Examples/demo.sh --gui runs it there.

By hand, from the clone: paraview --script=Examples/m83_window.py
"""
import os

from paraview import simple

simple._DisableFirstRenderCameraReset()
HERE = os.environ.get("GALAXY_EXAMPLES", os.path.abspath("Examples"))  # no __file__ in the window

plugin = os.environ.get("GALAXY_PLUGIN")
if plugin:
    simple.LoadPlugin(plugin, ns=globals())
else:
    simple.LoadDistributedPlugin("GalaxyReconstruction", ns=globals())

galaxy = GalaxyReader(registrationName="M83", FileName=os.path.join(HERE, "M83", "m83.galaxy"))
model = GalaxyModel(registrationName="M83 particles", Input=galaxy)
model.ParticleScale = float(os.environ.get("GALAXY_PARTICLE_SCALE", "1"))
view = simple.GetActiveViewOrCreate("RenderView")
view.UseColorPaletteForBackground = 0
view.Background = [0, 0, 0]
view.OrientationAxesVisibility = 0
display = simple.Show(model, view)
display.Exposure = 0.7
view.CameraPosition = [0, -45, 45]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 0.7, 0.7]
simple.Render(view)
