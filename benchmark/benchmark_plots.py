# SPDX-License-Identifier: BSD-3-Clause
"""Plots of time against objects and against boxes."""
import matplotlib

matplotlib.use("Agg")  # no display needed
import matplotlib.pyplot as plt

matplotlib.rcParams["svg.fonttype"] = "none"  # text as text: a fraction of the size
matplotlib.rcParams["svg.hashsalt"] = "benchmark"  # the same figures, the same file
COLORS = ["#1f77b4", "#d62728", "#2ca02c", "#ff7f0e", "#9467bd", "#7f7f7f", "#8c564b"]
# (part, kind, volume) with its name in the legend
FRAMES = [(("frame", "objectness", "none"), "objectness"), (("frame", "paper", "tight"), "paper"),
          (("frame", "paper", "wide"), "paper, wide"), (("frame", "paper_top_k", "tight"), "paper, best boxes"),
          (("frame", "mps", "none"), "MPS"), (("frame", "lccp", "none"), "LCCP"),
          (("frame", "lccp_pcl_normals", "none"), "LCCP, PCL's normals")]
SEARCHES = [("plain", "nested loop"), ("scan", "vectorized scan"), ("bounded", "branch and bound")]


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def finish(axes, x, y):
    axes.set(xlabel=x, ylabel=y)
    axes.set_yscale("log")
    axes.grid(True, which="both", color="#eeeeee")
    if axes.get_legend_handles_labels()[0]:
        axes.legend(fontsize=7)


def draw_objects(results, axes, keys, simulated):
    """A line for simulated scenes, which differ in nothing but their number of objects; points for recorded ones."""
    for (key, name), color in zip(keys, COLORS):
        for is_simulated in (True, False) if simulated is None else (simulated,):
            points = sorted((s.objects, results.wall(*key, s)) for s in results.select(simulated=is_simulated)
                            if results.wall(*key, s) is not None)
            if points:
                axes.plot([p[0] for p in points], [p[1] for p in points], "o-" if is_simulated else "x", color=color,
                          markersize=4, label=name if is_simulated else name + ", recorded")
    finish(axes, "Objects", "Milliseconds a frame, %d threads" % results.run["threads"])


def draw_boxes(results, axes, simulated):
    for (kind, name), color in zip(SEARCHES, COLORS):
        points = []
        for volume in ("tight", "wide"):
            for scene in results.select(simulated=simulated):
                found = results.get("search", kind, volume, scene)
                if found:
                    points.append((found.counter("boxes") / 1e6, results.wall("search", kind, volume, scene)))
        if points:
            axes.plot([p[0] for p in points], [p[1] for p in points], "o", color=color, markersize=4, label=name)
    axes.set_xscale("log")
    finish(axes, "Million boxes", "Milliseconds of one thread")


def draw(results, folder):
    """Returns {caption: path}. growth.svg holds simulated scenes only."""
    folder.mkdir(parents=True, exist_ok=True)
    paths = {}
    for name, simulated, caption in (("growth", True, "simulated scenes"), ("all_scenes", None, "all scenes")):
        if not results.select(simulated=simulated):
            continue
        figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8))
        draw_objects(results, left, FRAMES, simulated)
        draw_boxes(results, right, simulated)
        path = folder / (name + ".svg")
        save(figure, path)
        paths["Time against objects and against boxes, %s" % caption] = path
    return paths
