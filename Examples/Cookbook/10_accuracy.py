# What accuracy costs for this scene: seconds and the largest error on the screen, level by level.
import os
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import numpy as np
from cookbook import M83, SCALE, SIZE, gp
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

model = gp.build_galaxy(M83, SCALE)
camera = gp.orbit_camera(gp.disk_axes(model), 75, 60, 9.0)
white = 1 / gp.exposure_for(gp.render(model, camera, SIZE))
exact, rows = None, []
for level in ("Sorted", "Bounded", "Preview"):  # and Overlapping, for thousands of particles
    picture = simple.SplatImage(Input=model, ImageSize=[SIZE, SIZE], Accuracy=level, White=white,
                                PreviewTime=0.02, **camera)
    start = time.time()
    picture.UpdatePipeline()
    seconds = time.time() - start
    light = vtk_to_numpy(servermanager.Fetch(picture).GetPointData().GetArray("Radiance")) / white
    exact = light if exact is None else exact
    error = np.abs(np.minimum(light, 1) - np.minimum(exact, 1)).max()
    rows.append(f"{level},{seconds:.3f},{error:.2e}")
with open("accuracy.csv", "w", encoding="utf-8") as file:
    file.write("\n".join(["level,seconds,largest error (of white)"] + rows) + "\n")
print("\n".join(rows))
