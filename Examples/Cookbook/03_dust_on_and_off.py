# Dust on and off, side by side in two render views (needs a display, or xvfb-run).
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cookbook import M83, SCALE, SIZE, gp
from paraview import simple

model = gp.build_galaxy(M83, SCALE)
camera = gp.orbit_camera(gp.disk_axes(model), 75, 60, 7.0)
layout = simple.CreateLayout("dust on and off")
views = []
for k, hidden in enumerate((["gas", "0"], ["gas", "0", "dust", "0"])):
    view = simple.CreateView("RenderView", UseColorPaletteForBackground=0, Background=[0, 0, 0],
                             OrientationAxesVisibility=0)
    display = simple.Show(model, view)  # opens as Splats
    display.ComponentVisibility = hidden
    display.Exposure = 0.3
    for name, value in camera.items():
        view.SetPropertyWithName(name, value)
    views.append(view)
layout.SplitHorizontal(0, 0.5)
layout.AssignView(1, views[0])
layout.AssignView(2, views[1])
layout.SetSize(2 * SIZE, SIZE)
simple.SaveScreenshot("dust_on_and_off.png", layout, ImageResolution=[2 * SIZE, SIZE])
print("wrote dust_on_and_off.png")
