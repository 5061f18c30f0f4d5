#!/usr/bin/python3
"""What accuracy costs in time: every level of the renderer and its knobs on five scenes.

Usage: accuracy_cost.py [--particles 1e6] [--size 512] [--repeats 3] [--scene SCENE.f32]
         [--bench PROGRAM] [--json FILE] [--from-json FILE] [--table FILE] [--plot FILE.png]
Runs galaxy_bench_accuracy (built with the tests), which draws every scene at every level and
compares it with the reference: double precision, particle by particle. README.md says what the
numbers mean.
"""
import argparse
import glob
import json
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
EXAMPLES = os.path.join(ROOT, "Examples")
FLOOR = 1e-7  # what is smaller is drawn here
COLORS = {"Sorted": "#0072b2", "Bounded": "#009e73", "Preview": "#e69f00", "Overlapping": "#cc79a7"}
MARKS = {"Sorted": "s", "Bounded": "o", "Preview": "^", "Overlapping": "D"}


def newest_bench():
    programs = glob.glob(os.path.join(ROOT, "build*", "benchmarks", "galaxy_bench_accuracy"))
    if not programs:
        sys.exit("galaxy_bench_accuracy is not built; use Plugin/build.sh --tests")
    return max(programs, key=os.path.getmtime)


def measure(arguments):
    subprocess.run([os.path.join(EXAMPLES, "M83", "images.sh")], check=True, stdout=sys.stderr)
    command = [arguments.bench or newest_bench(), arguments.particles, arguments.size,
               arguments.repeats, os.path.join(EXAMPLES, "M83", "m83.galaxy"),
               os.path.join(EXAMPLES, "M83Group", "m83group.galaxygroup")]
    if arguments.scene:
        command.append(arguments.scene)
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)


# Other values of what is built in (Filters/Splatting/Knobs.h), one at a time.
BUILDS = [[], ["GALAXY_TILE_SIDE=16"], ["GALAXY_TILE_SIDE=64"], ["GALAXY_DEPTH_BITS=24"],
          ["GALAXY_DEPTH_BITS=16"], ["GALAXY_SUM=float"], ["GALAXY_KERNEL_CUT=0.8F"],
          ["GALAXY_KERNEL_CUT=0.6F"]]


def measure_builds(arguments):
    """The runs of programs built with each of BUILDS, in a folder of its own that is removed."""
    runs = []
    for defines in BUILDS:
        with tempfile.TemporaryDirectory() as folder:
            flags = " ".join(f"-D{define}" for define in defines)
            for command in (["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja",
                             "-DGALAXY_BUILD_PLUGIN=OFF", f"-DCMAKE_CXX_FLAGS={flags}"],
                            ["cmake", "--build", folder, "--target", "galaxy_bench_accuracy"]):
                subprocess.run(command, check=True, stdout=sys.stderr)
            program = os.path.join(folder, "benchmarks", "galaxy_bench_accuracy")
            output = subprocess.run([program, arguments.particles, arguments.size,
                                     arguments.repeats], check=True, stdout=subprocess.PIPE)
            runs += json.loads(output.stdout)["runs"]
    return runs


def pareto(runs):
    """The runs that no other beats in both seconds and displayed error, fastest first."""
    front, best = [], float("inf")
    for run in sorted(runs, key=lambda r: (r["seconds"], r["displayed"])):
        if run["displayed"] < best:
            front.append(run)
            best = run["displayed"]
    return front


def scenes_of(runs):
    """Scene by scene, those with an error."""
    scenes = {}
    for run in runs:
        if "error" in run:
            scenes.setdefault(run["scene"], []).append(run)
    return scenes


def table(data):
    lines = ["| scene | level | seconds | of white, at most | displayed, at most | rms | bound | front |",
             "|---|---|---|---|---|---|---|---|"]
    for scene, runs in scenes_of(data["runs"]).items():
        front = pareto([r for r in runs if r["level"] in COLORS])
        for run in runs:
            bound = f"{run['bound']:.2g}" if "bound" in run else ""
            level = f"{run['level']} {run['knob']}".strip()
            lines.append(f"| {scene} | {level} | {run['seconds']:.3f} | {run['error']:.1e} | "
                         f"{run['displayed']:.1e} | {run['rms']:.1e} | {bound} | "
                         f"{'*' if run in front else ''} |")
    lines += ["", "| what the scene calls for | | seconds |", "|---|---|---|"]
    lines += [f"| {r['scene']} | {r['knob']} | {r['seconds']:.3f} |"
              for r in data["runs"] if "error" not in r]
    return "\n".join(lines) + "\n"


def broken(data):
    """Runs whose displayed error is above their bound, rounding (1e-5) apart."""
    return [r for r in data["runs"] if "bound" in r and r["displayed"] > r["bound"] + 1e-5]


def plot(data, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from matplotlib.ticker import NullFormatter

    scenes = {scene: runs for scene, runs in scenes_of(data["runs"]).items()
              if any(run["level"] in COLORS for run in runs)}
    figure, grid = plt.subplots(2, (len(scenes) + 1) // 2, figsize=(13, 6.4), layout="constrained",
                                sharey=True)
    for axes, (scene, runs) in zip(grid.flat, scenes.items()):
        front = pareto([r for r in runs if r["level"] in COLORS])
        axes.plot([r["seconds"] for r in front], [max(FLOOR, r["displayed"]) for r in front],
                  color="#bbbbbb", linewidth=6, solid_capstyle="round", zorder=0)
        for level, color in COLORS.items():
            some = [r for r in runs if r["level"] == level]
            axes.plot([r["seconds"] for r in some], [max(FLOOR, r["displayed"]) for r in some],
                      MARKS[level], color=color, label=level, markersize=6)
        axes.axhline(1 / 512, color="#999999", linewidth=0.8, linestyle=":")
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.xaxis.set_minor_formatter(NullFormatter())
        axes.set_title(scene, loc="left", fontsize=10)
        for side in ("top", "right"):
            axes.spines[side].set_visible(False)
    for axes in grid.flat[len(scenes):]:
        axes.set_visible(False)
    for axes in grid[-1]:
        axes.set_xlabel("seconds a picture")
    for axes in grid[:, 0]:
        axes.set_ylabel("largest displayed error (white is 1)")
    handles = {}
    for axes in grid.flat:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            if len(handle.get_xdata()):
                handles[label] = handle
    grid.flat[0].legend(handles.values(), handles.keys(), loc="center left", frameon=False)
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--particles", default="1e6")
    parser.add_argument("--size", default="512")
    parser.add_argument("--repeats", default="3")
    parser.add_argument("--scene", help="of nine float32 arrays, see BenchScenes.h")
    parser.add_argument("--bench", help="galaxy_bench_accuracy; default: the one built last")
    parser.add_argument("--builds", action="store_true",
                        help="also build with other tile sizes, depths and sums: a minute each")
    parser.add_argument("--from-json", help="draw what was measured before")
    parser.add_argument("--json")
    parser.add_argument("--table")
    parser.add_argument("--plot")
    arguments = parser.parse_args()
    if arguments.from_json:
        with open(arguments.from_json, encoding="utf-8") as file:
            data = json.load(file)
    else:
        data = measure(arguments)
        if arguments.builds:
            data["runs"] += measure_builds(arguments)
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(data, file, indent=1)
    text = table(data)
    if arguments.table:
        with open(arguments.table, "w", encoding="utf-8") as file:
            file.write(text)
    else:
        print(text)
    if arguments.plot:
        plot(data, arguments.plot)
    for run in broken(data):
        print(f"BOUND BROKEN: {run}", file=sys.stderr)
    return 1 if broken(data) else 0


if __name__ == "__main__":
    sys.exit(main())
