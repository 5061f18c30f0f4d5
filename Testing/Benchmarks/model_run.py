"""Builds the model of a galaxy once and writes, as JSON, what it took.

Usage: GALAXY_PLUGIN=PLUGIN.so pvpython model_run.py FILE.galaxy PARTICLE_SCALE RESULT.json
Run by bench_model.py. Times are seconds of CLOCK_MONOTONIC, which other processes share; memory is
in bytes.
"""
import json
import os
import sys
import time

START = time.monotonic()


def memory(entry):
    """An entry of /proc/self/status: VmRSS, the resident memory, or VmHWM, its peak."""
    with open("/proc/self/status", encoding="ascii") as file:
        for line in file:
            if line.startswith(entry + ":"):
                return 1024 * int(line.split()[1])
    raise KeyError(entry)


def machine_cpu():
    """CPU seconds that all processes, and other guests of the hardware, have had since boot."""
    with open("/proc/stat", encoding="ascii") as file:
        user, nice, system, _idle, _waiting, *others = map(int, file.readline().split()[1:9])
    return (user + nice + system + sum(others)) / os.sysconf("SC_CLK_TCK")


class Phases:
    """When each phase began and ended, its CPU seconds and those of everything else that runs on
    the machine, and the memory held at its end."""

    def __init__(self):
        self.list = []
        self.last = START
        self.last_cpu = time.process_time()
        self.last_machine = machine_cpu()

    def done(self, name):
        now, cpu, machine = time.monotonic(), time.process_time(), machine_cpu()
        own = cpu - self.last_cpu
        self.list.append({"phase": name, "start": self.last, "end": now, "cpu": own,
                          "others_cpu": max(0, machine - self.last_machine - own),
                          "memory": memory("VmRSS")})
        self.last, self.last_cpu, self.last_machine = now, cpu, machine


def size_of(array):
    return array.GetNumberOfValues() * array.GetDataTypeSize()


def arrays_of(particles):
    """Bytes by point array."""
    attributes = particles.GetPointData()
    arrays = [attributes.GetArray(k) for k in range(attributes.GetNumberOfArrays())]
    sizes = {array.GetName(): size_of(array) for array in arrays}
    if particles.GetPoints():
        sizes["Points"] = size_of(particles.GetPoints().GetData())
    return sizes


def run(galaxy, scale):
    phases = Phases()
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Python"))
    import galaxy_testing
    from paraview import simple

    phases.done("paraview")
    galaxy_testing.load_plugin()
    phases.done("plugin")

    reader = simple.GalaxyReader(FileName=galaxy)
    reader.UpdatePipeline()
    phases.done("read")

    model = simple.GalaxyModel(Input=reader, ParticleScale=scale)
    ended = []
    filter = model.GetClientSideObject()
    filter.AddObserver("EndEvent", lambda *_: ended.append(time.monotonic()))
    model.UpdatePipeline()
    phases.done("model")

    particles = filter.GetOutputDataObject(0)
    arrays = arrays_of(particles)
    model.UpdatePropertyInformation()
    return {
        "galaxy": os.path.abspath(galaxy),
        "scale": scale,
        "threads": os.environ.get("OMP_NUM_THREADS"),
        "particles": particles.GetNumberOfPoints(),
        "arrays": arrays,
        "model_bytes": sum(arrays.values()),
        "components": json.loads(model.SMProxy.GetProperty("ReportJSON").GetElement(0)),
        "phases": phases.list,
        "components_end": ended[-1],  # the rest of the phase "model" is ParaView's
        "peak": memory("VmHWM"),
    }


if __name__ == "__main__":
    result = run(sys.argv[1], float(sys.argv[2]))
    with open(sys.argv[3], "w", encoding="utf-8") as file:
        json.dump(result, file)
