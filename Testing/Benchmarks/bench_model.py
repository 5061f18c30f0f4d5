#!/usr/bin/python3
"""What building the model of a galaxy takes: seconds by component and stage, and memory.

Usage: bench_model.py [FILE.galaxy] [--plugin FILE.so] [--particles 22e6 | --scale S]
         [--threads 1,2] [--scaling 1e6,3e6,10e6,30e6,100e6] [--repeats 3]
         [--pick median] [--json FILE] [--figures FOLDER]
Every run is a pvpython process of its own, whose resident memory is sampled from outside. README.md
says what the numbers mean. B, kB, MB are powers of 1000.
"""
import argparse
import glob
import json
import os
import platform
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
M83 = os.path.join(ROOT, "Examples", "M83", "m83.galaxy")
STAGES = ("images", "light", "seeds", "thickness", "photometry", "smoothing")
PHASES = {"paraview": "Python and ParaView", "plugin": "loading the plugin",
          "read": "reading the galaxy's files", "model": "the model"}
PAGE = os.sysconf("SC_PAGE_SIZE")
SAMPLE_INTERVAL = 0.005  # seconds
CALIBRATION_SCALE = 0.1


# --- Running -------------------------------------------------------------------------------------


def sampled(process):
    """(CLOCK_MONOTONIC, resident bytes) of a process until it ends."""
    samples = []
    with open(f"/proc/{process.pid}/statm", "rb", buffering=0) as statm:
        while process.poll() is None:
            now = time.monotonic()
            fields = os.pread(statm.fileno(), 128, 0).split()
            if fields and int(fields[1]):  # none while the process goes away
                samples.append((now, PAGE * int(fields[1])))
            time.sleep(SAMPLE_INTERVAL)
    return samples


def run(arguments, scale, threads):
    """One model: what model_run.py says of it, and `memory`, the samples."""
    environment = dict(os.environ, GALAXY_PLUGIN=arguments.plugin, OMP_NUM_THREADS=str(threads),
                       PYTHONDONTWRITEBYTECODE="1")
    with tempfile.NamedTemporaryFile(suffix=".json") as answer:
        process = subprocess.Popen(
            ["pvpython", os.path.join(HERE, "model_run.py"), arguments.galaxy, repr(scale),
             answer.name], env=environment)
        samples = sampled(process)
        if process.returncode != 0:
            sys.exit(f"model_run.py ended with {process.returncode}")
        result = json.load(answer)
    result["threads"] = threads
    result["seconds"] = {p["phase"]: p["end"] - p["start"] for p in result["phases"]}
    result["cpu_seconds"] = {p["phase"]: p["cpu"] for p in result["phases"]}
    model = next(p for p in result["phases"] if p["phase"] == "model")
    result["others_cores"] = model["others_cpu"] / (model["end"] - model["start"])
    result["held"] = {p["phase"]: p["memory"] for p in result["phases"]}
    result["baseline"] = result["held"]["plugin"]
    above = result["peak"] - result["baseline"]
    result["peak_above_baseline"] = above
    result["peak_ratio"] = result["peak"] / result["model_bytes"]
    result["peak_above_baseline_ratio"] = above / result["model_bytes"]
    result["memory"] = samples
    return result


def typical(runs, pick):
    """The run of median model time (of an even number, the faster of the two) or of the least."""
    ordered = sorted(runs, key=lambda r: r["seconds"]["model"])
    return ordered[0 if pick == "least" else (len(runs) - 1) // 2]


def series(arguments, cases):
    """A run for each (scale, threads); cases take turns, so that all meet the same noise."""
    runs = [[] for _ in cases]
    for repeat in range(arguments.repeats):
        for case, (scale, threads) in enumerate(cases):
            print(f"repeat {repeat + 1} of {arguments.repeats}: ParticleScale {scale:.4g}, "
                  f"threads {threads}", file=sys.stderr)
            runs[case].append(run(arguments, scale, threads))
    chosen = []
    for of_case in runs:
        chosen.append(typical(of_case, arguments.pick))
        chosen[-1]["model_seconds_of_repeats"] = [r["seconds"]["model"] for r in of_case]
    return chosen


def scale_for(arguments, particles):
    """The ParticleScale that gives about so many particles."""
    if not hasattr(arguments, "per_scale"):
        trial = run(arguments, CALIBRATION_SCALE, arguments.threads[-1])
        arguments.per_scale = trial["particles"] / CALIBRATION_SCALE
    return particles / arguments.per_scale


def copy_bandwidth(threads, size=512 * 1000 * 1000, repeats=5):
    """Bytes per second that are read and written while a large array is copied."""
    parts = [(np.zeros(size // threads, np.uint8), np.ones(size // threads, np.uint8))
             for _ in range(threads)]
    best = float("inf")
    for _ in range(repeats):
        workers = [threading.Thread(target=np.copyto, args=part) for part in parts]
        start = time.monotonic()
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        best = min(best, time.monotonic() - start)
    return 2 * size / best


# --- Tables --------------------------------------------------------------------------------------


def table(heads, rows):
    """Columns as wide as their widest entry, the first flush left."""
    cells = [heads] + rows
    widths = [max(len(row[k]) for row in cells) for k in range(len(heads))]
    for row in cells:
        others = (cell.rjust(width) for cell, width in zip(row[1:], widths[1:]))
        print("  ".join([row[0].ljust(widths[0]), *others]))
    print()


def megabytes(size):
    return f"{size / 1e6:.1f} MB"


def component_rows(components):
    rows = []
    for c in components:
        total = sum(c["seconds"][stage] for stage in STAGES)
        rows.append([c["component"], *(f"{c[key]:,}" for key in (
            "seeds_drawn", "seeds_kept", "particles", "filled")),
            *(f"{c['seconds'][stage]:.3f}" for stage in STAGES), f"{total:.3f}",
            f"{1e9 * total / max(1, c['particles']):.1f}"])
    return rows


def all_components(components):
    total = {key: sum(c[key] for c in components)
             for key in ("seeds_drawn", "seeds_kept", "particles", "filled")}
    total["component"] = "all"
    total["seconds"] = {s: sum(c["seconds"][s] for c in components) for s in STAGES}
    return total


def print_run(r, bandwidth):
    seconds = r["seconds"]
    print(f"{r['particles']:,} particles (ParticleScale {r['scale']:.4g}), threads: "
          f"{r['threads']}\n")
    total = all_components(r["components"])
    table(["component", "seeds", "kept", "particles", "filled", *STAGES, "seconds",
           "ns/particle"], component_rows(r["components"] + [total]))
    outside = seconds["model"] - sum(total["seconds"].values())
    table(["phase", "seconds", "CPU seconds", "memory at its end"], [
        [name, f"{seconds[phase]:.3f}", f"{r['cpu_seconds'][phase]:.3f}",
         megabytes(r["held"][phase])] for phase, name in PHASES.items()]
        + [["  outside the components", f"{outside:.3f}", "", ""]])
    print(f"While the model was built, other processes kept {r['others_cores']:.2f} cores busy.\n")
    model = r["model_bytes"]
    table(["memory", "size", "/ model"], [
        ["the finished model", megabytes(model),
         f"{model / max(1, r['particles']):.2f} B a particle"],
        ["baseline: process with the plugin", megabytes(r["baseline"]), ""],
        ["peak of the process", megabytes(r["peak"]), f"{r['peak_ratio']:.2f}"],
        ["peak - baseline", megabytes(r["peak_above_baseline"]),
         f"{r['peak_above_baseline_ratio']:.2f}"]])
    copy = 2 * model / bandwidth
    print(f"Copying the finished model takes {copy:.4f} s ({bandwidth / 1e9:.1f} GB/s read and "
          f"written); the model {seconds['model'] / copy:.0f} times as long.\n")


TIMES = ("model, s", "CPU, s", "cores of others")


def times(r):
    return (f"{r['seconds']['model']:.3f}", f"{r['cpu_seconds']['model']:.3f}",
            f"{r['others_cores']:.2f}")


def print_threads(runs):
    first = runs[0]["seconds"]["model"]
    table(["threads", *TIMES, "of each repeat, s", "speed-up"], [
        [str(r["threads"]), *times(r),
         " ".join(f"{s:.3f}" for s in r["model_seconds_of_repeats"]),
         f"{first / r['seconds']['model']:.2f}"] for r in runs])


def line_through(runs):
    """The a + b N that misses the runs' seconds by the least relative squares."""
    n = np.array([r["particles"] for r in runs], float)
    t = np.array([r["seconds"]["model"] for r in runs])
    (a, b), *_ = np.linalg.lstsq(np.array([1 / t, n / t]).T, np.ones(len(t)), rcond=None)
    return a, b, (t - (a + b * n)) / (a + b * n)


def print_scaling(runs):
    a, b, misses = line_through(runs)
    table(["particles", *TIMES, "ns/particle", "off the line", "peak / model",
           "(peak - baseline) / model"], [
        [f"{r['particles']:,}", *times(r),
         f"{1e9 * r['seconds']['model'] / r['particles']:.1f}", f"{100 * miss:+.1f} %",
         f"{r['peak_ratio']:.2f}", f"{r['peak_above_baseline_ratio']:.2f}"]
        for r, miss in zip(runs, misses)])
    print(f"The line: {a:.3f} s + {1e9 * b:.1f} ns a particle.\n")
    return {"fixed_seconds": a, "seconds_per_particle": b, "off_the_line": list(misses)}


# --- The command line ----------------------------------------------------------------------------


def numbers(kind):
    return lambda text: [kind(float(part)) for part in text.split(",")]


def found_plugin():
    """The one built last in a build folder of this checkout."""
    pattern = os.path.join(ROOT, "build*", "lib", "**", "GalaxyReconstruction.so")
    files = sorted(glob.glob(pattern, recursive=True), key=os.path.getmtime)
    return files[-1] if files else None


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("galaxy", nargs="?", default=M83, help="a .galaxy file; M83's by default")
    parser.add_argument("--plugin", default=os.environ.get("GALAXY_PLUGIN") or found_plugin(),
                        help="GalaxyReconstruction.so; $GALAXY_PLUGIN or the one built last")
    size = parser.add_mutually_exclusive_group()
    size.add_argument("--particles", type=float, default=22e6, help="about so many")
    size.add_argument("--scale", type=float, help="ParticleScale, instead of --particles")
    parser.add_argument("--threads", type=numbers(int), default=[len(os.sched_getaffinity(0))],
                        help="such as 1,2; the last is used for the tables and figures")
    parser.add_argument("--scaling", type=numbers(float), default=[],
                        help="numbers of particles, such as 1e6,10e6")
    parser.add_argument("--repeats", type=int, default=1, help="of each run")
    parser.add_argument("--pick", choices=("median", "least"), default="median",
                        help="which of the repeats counts, by the model's seconds")
    parser.add_argument("--json", help="file for all results")
    parser.add_argument("--figures", help="folder for model-time.png and model-memory.png")
    arguments = parser.parse_args()
    if not arguments.plugin:
        parser.error("no plugin found: build it or name it with --plugin")
    return arguments


def main():
    arguments = parse()
    if os.path.samefile(arguments.galaxy, M83):
        subprocess.run([os.path.join(os.path.dirname(M83), "images.sh")], check=True,
                       stdout=subprocess.DEVNULL)
    scale = arguments.scale or scale_for(arguments, arguments.particles)
    bandwidth = copy_bandwidth(arguments.threads[-1])
    results = {"machine": platform.platform(), "cores": len(os.sched_getaffinity(0)),
               "copy_bandwidth": bandwidth}

    results["runs"] = series(arguments, [(scale, threads) for threads in arguments.threads])
    print_run(results["runs"][-1], bandwidth)
    if len(arguments.threads) * arguments.repeats > 1:
        print_threads(results["runs"])
    if arguments.scaling:
        results["scaling"] = series(arguments, [
            (scale_for(arguments, n), arguments.threads[-1]) for n in arguments.scaling])
        results["line"] = print_scaling(results["scaling"])

    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(results, file)
    if arguments.figures:
        import model_figures

        os.makedirs(arguments.figures, exist_ok=True)
        for path in model_figures.draw(results["runs"][-1], STAGES, arguments.figures):
            print(path)


if __name__ == "__main__":
    main()
