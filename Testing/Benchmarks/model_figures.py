"""The two figures of bench_model.py: time by component and stage, memory over the life of a run."""
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLORS = ("#999999", "#e69f00", "#56b4e9", "#0072b2", "#d55e00", "#009e73")  # Okabe and Ito's
PHASES = {"paraview": "Python and ParaView", "plugin": "plugin", "read": "files", "model": "model"}
NARROW, NARROWEST = 0.09, 0.015  # of the width: narrower phases have upright labels, none


def plain(axes):
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def draw_time(run, stages, path):
    """A bar for each component, and one for reading the files that all share."""
    components = run["components"]
    names = [f"{c['component']}\n{c['particles']:,} particles" for c in components]
    names.append("reading the files\nof all components")
    rows = range(len(components))
    figure, axes = plt.subplots(figsize=(8, 1.3 + 0.62 * len(names)), layout="constrained")
    left = [0.0] * len(components)
    for stage, color in zip(stages, COLORS):
        widths = [c["seconds"][stage] for c in components]
        axes.barh(rows, widths, left=left, color=color, label=stage, height=0.62)
        left = [a + b for a, b in zip(left, widths)]
    axes.barh(len(components), run["seconds"]["read"], color="#333333", height=0.62)
    for row, total in enumerate([*left, run["seconds"]["read"]]):
        axes.annotate(f"{total:.2f} s", (total, row), xytext=(4, 0), textcoords="offset points",
                      va="center")
    axes.set_yticks(range(len(names)), names)
    axes.tick_params(axis="y", length=0)
    axes.invert_yaxis()
    axes.margins(x=0.08)
    axes.set_xlabel("seconds")
    axes.set_title(f"{run['particles']:,} particles in {sum(left):.2f} s", loc="left")
    axes.legend(frameon=False, loc="upper center", bbox_to_anchor=(0.45, -0.14), ncols=len(stages))
    plain(axes)
    figure.savefig(path, dpi=150)
    plt.close(figure)


def component_ends(run, stages):
    """When each component was done: the last with the model, the others counted back from it."""
    end, ends = run["components_end"], []
    for component in reversed(run["components"]):
        ends.append((component["component"], end))
        end -= sum(component["seconds"][stage] for stage in stages)
    return end, ends[::-1]


def draw_memory(run, stages, path):
    start = run["memory"][0][0]
    times = [t - start for t, _ in run["memory"]]
    figure, axes = plt.subplots(figsize=(9, 4.6), layout="constrained")
    axes.plot(times, [size / 1e6 for _, size in run["memory"]], color="#0072b2", lw=1.4)
    top, right = 1.22 * run["peak"] / 1e6, 1.02 * times[-1]
    axes.set(xlim=(0, right), ylim=(0, top), xlabel="seconds", ylabel="resident memory, MB")

    def mark(since, until, name, style, height):
        axes.axvline(until, color="#999999", lw=0.7, ls=style, zorder=0)
        width = (until - since) / right
        if width > NARROWEST:
            axes.text((since + until) / 2, height * top, name, ha="center", va="top", fontsize=8.5,
                      rotation=0 if width > NARROW else 90)

    since = 0
    for phase in run["phases"]:
        mark(since, phase["end"] - start, PHASES[phase["phase"]], "-", 0.985)
        since = phase["end"] - start
    began, ends = component_ends(run, stages)
    since = began - start
    for name, end in ends:
        mark(since, end - start, name, ":", 0.925)
        since = end - start

    base, model, peak = (run[key] / 1e6 for key in ("baseline", "model_bytes", "peak"))
    for height, name in (
        (base, f"process with the plugin: {base:.0f} MB"),
        (base + model, f"and the finished model of {model:.0f} MB"),
        (peak, f"peak: {run['peak_above_baseline_ratio']:.2f} models above the process"),
    ):
        axes.axhline(height, color="#d55e00", lw=0.8, ls="--", zorder=0)
        axes.annotate(name, (right, height), xytext=(-2, 2), textcoords="offset points",
                      ha="right", fontsize=8.5, color="#d55e00")
    plain(axes)
    figure.savefig(path, dpi=150)
    plt.close(figure)


def draw(run, stages, folder):
    """Writes the figures; their paths."""
    paths = [os.path.join(folder, name) for name in ("model-time.png", "model-memory.png")]
    draw_time(run, stages, paths[0])
    draw_memory(run, stages, paths[1])
    return paths
