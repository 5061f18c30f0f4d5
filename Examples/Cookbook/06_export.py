# Takes the model to SPH tools: a Gadget snapshot in HDF5, opened by yt, and a table for others.
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import yt
from cookbook import M83, SCALE, gp
from paraview import simple

model = gp.build_galaxy(M83, SCALE)
model.Velocities = 1
simple.SaveData("m83.hdf5", proxy=model)
simple.ParticleWriter(Input=model, FileName="m83.csv").UpdatePipeline()

yt.set_log_level("error")
snapshot = yt.load("m83.hdf5", unit_base={"length": (1, "kpc"), "velocity": (1, "km/s")})
particles = snapshot.all_data()
with open("export.txt", "w", encoding="utf-8") as report:
    for kind in sorted({field[0] for field in snapshot.field_list if field[0].startswith("Part")}):
        count, light = particles[kind, "Masses"].size, float(particles[kind, "Masses"].v.sum())
        print(f"{kind}: {count} particles of light {light:.6g}", file=report)
print(open("export.txt", encoding="utf-8").read() + "wrote m83.hdf5, m83.csv")
