#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the report of a benchmark and prints its figures.

    benchmark_report.py DIR

DIR is the folder that benchmark_objectness left its results in; scripts/benchmark calls both. Written are
DIR/report.md, DIR/summary.json and DIR/plots/*.svg. Exit status 1 when a benchmark failed.
"""
import json
import pathlib
import sys

sys.dont_write_bytecode = True

import benchmark_figures
import benchmark_plots
from benchmark_results import Results, Value, short

OWN_FRAMES = [("objectness", "none"), ("paper", "tight"), ("paper", "wide"), ("paper_top_k", "tight"),
              ("paper_top_k", "wide"), ("paper_strict", "tight"), ("paper_strict", "wide")]
BASELINES = [("mps", "none"), ("lccp", "none"), ("mps_pcl_normals", "none"), ("lccp_pcl_normals", "none"),
         ("euclidean", "none"), ("organized", "none")]


def table(header, rows):
    lines = ["| %s |" % " | ".join(header), "|%s" % ("---|" * len(header))]
    return "\n".join(lines + ["| %s |" % " | ".join(str(cell) for cell in row) for row in rows])


def named(method, volume):
    name = method.replace("_", " ")
    return name if volume in ("none", "tight") else "%s, %s" % (name, volume)


def figure_tables(results):
    parts = []
    for simulated, title in ((False, "Recorded scenes"), (True, "Simulated scenes")):
        if results.select(simulated=simulated):
            rows = [figure.row() for figure in benchmark_figures.figures(results, simulated)]
            parts += ["### " + title, table(["figure", "to reach", "median", "range", "scenes", "reached"], rows)]
    return "\n\n".join(parts)


def frame_table(results):
    kinds = [k for k in OWN_FRAMES + BASELINES if any(key[:3] == ("frame",) + k for key in results.measured)]
    rows = []
    for scene in results.scenes:
        cells = [results.get("frame", *kind, scene) for kind in kinds]
        rows.append([scene.name, scene.objects] + [Value(c.wall) if c else "" for c in cells])
    return table(["scene", "objects"] + [named(*kind) for kind in kinds], rows)


def stage_tables(results):
    """By size of the picture, medians over scenes of the medians over runs."""
    parts = []
    for kind in OWN_FRAMES + BASELINES:
        columns, stages = {}, []
        for scene in results.scenes:
            found = results.get("frame", *kind, scene)
            if not found:
                continue
            crowd = "2 to 7" if scene.objects <= 7 else "8 to 20" if scene.objects <= 20 else "over 20"
            column = columns.setdefault(("%d x %d" % (scene.width, scene.height), crowd), {})
            for name in found.counters:
                if name.startswith("stage:"):
                    stages += [name] if name not in stages else []
                    column.setdefault(name, []).append(found.counter(name))
        if columns:
            header = ["stage"] + ["%s, %s objects (%d)" % (size, crowd, max(len(v) for v in column.values()))
                                  for (size, crowd), column in columns.items()]
            rows = [[name.split(":")[2]] + [Value(column[name]) if name in column else ""
                                              for column in columns.values()] for name in sorted(stages)]
            parts += ["### " + named(*kind), table(header, rows)]
    return "\n\n".join(parts)


def search_table(results):
    rows = []
    for scene in results.scenes:
        for volume in ("tight", "wide"):
            bounded = results.get("search", "bounded", volume, scene)
            if not bounded:
                continue
            times = {kind: results.wall("search", kind, volume, scene) for kind in ("plain", "scan", "bounded")}
            cells = [short(times[kind]) if times[kind] is not None else "" for kind in ("plain", "scan")]
            against = ["1/%.0f" % (times[kind] / times["bounded"]) if times[kind] else "" for kind in ("plain", "scan")]
            boxes = bounded.counter("boxes")
            spans = (results.get(*part, volume, scene)
                     for part in (("volumes", "all"), ("angles", "all"), ("angles", "strict")))
            rows.append([scene.name, scene.objects, volume, "%.1f" % (boxes / 1e6)] + cells +
                        [Value(bounded.wall)] + against +
                        ["%.2f" % (boxes / times["bounded"] / 1e6), int(bounded.counter("passed"))] +
                        [Value(found.wall) if found else "" for found in spans])
    return table(["scene", "objects", "volume", "million boxes", "nested loop", "scan", "branch and bound",
                  "of the loop", "of the scan", "billion boxes a second", "boxes found", "volumes",
                  "volumes and search, %d threads, wall" % results.run["threads"], "the same, boxes of 0.9 and above"],
                 rows)


def memory_table(results):
    kinds = [k for k in OWN_FRAMES if any(key[:3] == ("frame",) + k and "peak_mib" in found.counters
                                          for key, found in results.measured.items())]
    if not kinds:
        return "Not measured."
    rows = []
    for scene in results.scenes:
        found = [results.get("frame", *kind, scene) for kind in kinds]
        peaks = [f.counter("peak_mib") if f else None for f in found]
        rows.append([scene.name] + [short(peak) if peak else "" for peak in peaks])
    return table(["scene"] + [named(*kind) for kind in kinds], rows)


def conditions(results):
    run, repetitions = results.run, results.run["repetitions"]
    return table(["", ""], [
        ["machine", run["machine"]], ["compiler", run["compiler"]], ["commit", run["commit"]],
        ["load before", "%.2f" % run["load_before"]], ["threads", run["threads"]],
        ["runs", "%d of frames, bounded searches and volumes, %d of the scan, %d of the nested loop"
         % (repetitions["frames"], repetitions["scan"], repetitions["plain"])]])


def write_report(results, plots, folder):
    parts = [
        "# Benchmark", conditions(results),
        "Milliseconds, median (least to largest) of the runs, once a process is warm.",
        "## Figures", "640 x 480; medians and ranges are over scenes, of medians over runs. A time is reached by its "
        "median, a ratio or a memory everywhere.", figure_tables(results),
        *("![%s](%s)" % (caption, path.relative_to(folder)) for caption, path in plots.items()),
        "## Whole frames", "Wall time. MPS and LCCP of PCL come after the package's front end on as many threads: normals (the "
        "package's, or PCL's), table, refined normals, points on the table. Euclidean and organized are PCL alone: "
        "passthrough, a plane by RANSAC, clusters of the rest in space or in the image.",
        frame_table(results),
        "## Searches", "CPU time of one thread over all angles; all searches found the same boxes.",
        search_table(results),
        "## Stages", "Medians (least to largest) over scenes, in brackets how many.", stage_tables(results),
        "## Peak memory", "MiB of a process that reads one scene and segments it once.", memory_table(results)]
    if results.failures:
        parts += ["## Failed", table(["benchmark", "reason"], results.failures)]
    (folder / "report.md").write_text("\n\n".join(parts) + "\n")


def write_summary(results, folder):
    summary = {
        "run": results.run,
        "figures": {name: [f.to_json() for f in benchmark_figures.figures(results, simulated)]
                    for name, simulated in (("recorded", False), ("simulated", True))},
        "measured": {"/".join(key): {"wall_ms": Value(m.wall).to_json(), "cpu_ms": Value(m.cpu).to_json(),
                                     "counters": {name: m.counter(name) for name in m.counters}}
                     for key, m in results.measured.items()},
        "failures": results.failures}
    (folder / "summary.json").write_text(json.dumps(summary, indent=1) + "\n")


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if len(sys.argv) == 2 else 2
    folder = pathlib.Path(sys.argv[1])
    results = Results(folder)
    write_report(results, benchmark_plots.draw(results, folder / "plots"), folder)
    write_summary(results, folder)
    print(figure_tables(results))
    print("\nReport: %s" % (folder / "report.md"))
    for name, reason in results.failures:
        print("benchmark_report.py: %s failed: %s" % (name, reason), file=sys.stderr)
    return 1 if results.failures else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (OSError, KeyError, ValueError) as error:
        sys.exit("benchmark_report.py: %s: %s: %s" % (sys.argv[1], type(error).__name__, str(error)[-300:]))
