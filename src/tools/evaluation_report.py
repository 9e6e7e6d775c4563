#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the plots of an evaluation and writes its report.html.

    evaluation_report.py DIR

DIR is a report folder of the tool `evaluate`, which calls this at its end. Written are DIR/plots/*.png and
DIR/report.html, one file with all pictures in it.
"""
import base64
import csv
import html
import io
import json
import os
import sys

import matplotlib

matplotlib.use("Agg")  # no display needed
import matplotlib.pyplot as plt
from PIL import Image

WORST_SCENES = 10
SCORES = ["P", "R", "OvP", "OvR", "OvF", "BdP", "BdR", "BdF", "F75", "extra", "F_os", "F_us", "WO"]
CAMERA_SCORES = ["P", "R", "OvF", "BdF", "F75", "extra"]
PICTURE_BOXES = ["objects", "found", "tight", "merged", "segments", "stray"]
MEANING = {
    "P": "mean over objects of shared / segment pixels, of the segment that shares most pixels with the object",
    "R": "mean over objects of shared / object pixels",
    "OvP": "overlap precision of one-to-one pairs", "OvR": "overlap recall", "OvF": "overlap F",
    "BdP": "boundary precision of the same pairs", "BdR": "boundary recall", "BdF": "boundary F",
    "F75": "share of objects whose pair has a Dice over 0.75", "extra": "segments without an object, a scene",
    "F_os": "over-segmentation: share of an object's pixels outside its segment",
    "F_us": "under-segmentation: pixels of its segment outside the object / pixels of the object",
    "WO": "best intersection over union, objects weighted by size",
    "ms": "milliseconds a scene, median", "peak_mib": "peak memory of a scene in MiB, largest",
}
STYLE = """
body { font-family: sans-serif; margin: 2em auto; max-width: 78em; padding: 0 1em; color: #222; }
table { border-collapse: collapse; margin: 0.5em 0 1.5em; font-variant-numeric: tabular-nums; }
th, td { padding: 0.2em 0.6em; text-align: right; border-bottom: 1px solid #ddd; }
th:first-child, td:first-child, td.text { text-align: left; }
tr.all td { font-weight: bold; }
th { border-bottom: 2px solid #888; }
.plots img { width: 23em; margin: 0.3em; }
.pair { display: inline-block; margin: 0 1em 1em 0; }
.pair img { width: 34em; max-width: 48%; }
pre { background: #f4f4f4; padding: 0.8em; overflow-x: auto; }
dt { float: left; width: 5em; font-weight: bold; } dd { margin-left: 5em; }
"""


class Report:
    """The files of a report folder."""

    def __init__(self, folder):
        self.folder = folder
        with open(self.path("run.json")) as f:
            self.run = json.load(f)
        with open(self.path("summary.json")) as f:
            self.summary = json.load(f)
        with open(self.path("scenes.csv"), newline="") as f:
            self.rows = list(csv.DictReader(f))
        self.cameras = self.table("cameras.csv")
        self.boxes = self.table("boxes.csv")
        self.methods = [method["name"] for method in self.run["methods"]]
        self.levels = self.run["levels"]

    def table(self, name):
        """The rows of a table; none in a report of an earlier version."""
        if not os.path.exists(self.path(name)):
            return []
        with open(self.path(name), newline="") as f:
            return list(csv.DictReader(f))

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    def scenes(self, method, level):
        return [row for row in self.rows if row["method"] == method and row["level"] == level]

    def results(self, method):
        """The result files of a method, those of scenes that were not counted, too."""
        for scene in self.run["scenes"]:
            with open(self.path("results", method, scene["name"] + ".json")) as f:
                yield json.load(f)


def scatter(points, title, path):
    """Precision against recall as in Fig. 4 of the paper: one point a scene, both axes from 0 to 1."""
    figure, axes = plt.subplots(figsize=(4.6, 4.4))
    axes.scatter([p for p, _ in points], [r for _, r in points], s=28, facecolors="none", edgecolors="#1f77b4",
                 linewidths=1.2, clip_on=False, zorder=3)
    axes.set(xlim=(0, 1), ylim=(0, 1), xlabel="Precision", ylabel="Recall", title=title)
    axes.set_aspect("equal")
    axes.grid(True, color="#dddddd")
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def draw_plots(report):
    """Returns (caption, path) of every plot."""
    os.makedirs(report.path("plots"), exist_ok=True)
    plots = []
    for level in report.levels:
        for method in report.methods:
            rows = report.scenes(method, level)
            if not rows:
                continue
            suffix = "" if level == "object" else "_" + level
            path = report.path("plots", "precision_recall_%s%s.png" % (method, suffix))
            title = method if level == "object" else "%s, parts" % method
            scatter([(float(row["P"]), float(row["R"])) for row in rows], title, path)
            plots.append(("%s: precision against recall, one point a scene (%d)" % (title, len(rows)), path))
    for method in report.methods:
        rows = [row for row in report.scenes(method, "object") if row["boxed_objects"]]
        if not rows:
            continue
        path = report.path("plots", "best_box_%s.png" % method)
        scatter([(float(row["best_P"]), float(row["best_R"])) for row in rows], "best box of %s" % method, path)
        plots.append(("%s: the single box of highest objectness, one point a scene (%d)" % (method, len(rows)), path))
        path = report.path("plots", "proposals_%s.png" % method)
        draw_recall(report.summary[method]["object"]["ALL"], method, path)
        plots.append(("%s: recall of true objects against the number of boxes kept" % method, path))
    return plots


def kept_boxes(figures):
    """The numbers of boxes for which there is a recall."""
    return [int(name.split("_")[1]) for name in figures if name.startswith("box50_")]


def draw_recall(figures, title, path):
    """Recall of true boxes against the number of boxes kept, beside a list that knows nothing of the scene."""
    figure, axes = plt.subplots(figsize=(4.6, 4.4))
    kept = kept_boxes(figures)
    for name, label, style in (("box50", "overlap 0.5", "o-"), ("box70", "overlap 0.7", "s-"),
                               ("fixed50", "fixed list, 0.5", "o--"), ("fixed70", "fixed list, 0.7", "s--")):
        color = "#1f77b4" if name.startswith("box") else "#999999"
        axes.plot(kept, [figures["%s_%d" % (name, n)] for n in kept], style, color=color, label=label, clip_on=False)
    axes.set_xscale("log")
    axes.set_xticks(kept)
    axes.set_xticklabels([str(n) for n in kept])
    axes.minorticks_off()
    axes.set(ylim=(0, 1), xlabel="Boxes kept", ylabel="Recall of true objects", title=title)
    axes.grid(True, color="#dddddd")
    axes.legend(loc="upper left", fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def embedded(path, jpeg=False):
    """The picture as the text of an img's src."""
    if jpeg:  # photographs are a tenth the size
        buffer = io.BytesIO()
        Image.open(path).convert("RGB").save(buffer, "JPEG", quality=85)
        data, kind = buffer.getvalue(), "jpeg"
    else:
        with open(path, "rb") as f:
            data, kind = f.read(), "png"
    return "data:image/%s;base64,%s" % (kind, base64.b64encode(data).decode())


def table(header, rows):
    """Rows are lists of cells; one whose first cell ends in ALL is stressed."""
    lines = ["<table><tr>" + "".join("<th>%s</th>" % html.escape(cell) for cell in header) + "</tr>"]
    for row in rows:
        stressed = ' class="all"' if str(row[0]).endswith("ALL") else ""
        lines.append("<tr%s>" % stressed + "".join("<td>%s</td>" % html.escape(str(cell)) for cell in row) + "</tr>")
    return "\n".join(lines + ["</table>"])


def score_tables(report):
    parts = []
    for level in report.levels:
        parts.append("<h2>Level: %s</h2>" % level)
        columns = ["scenes"] + SCORES + ["ms", "peak_mib"]
        by_method = {m: report.summary.get(m, {}).get(level, {}) for m in report.methods}
        groups = ["ALL"] + sorted({group for found in by_method.values() for group in found if group != "ALL"})
        for group in groups:
            rows = []
            for method, found in by_method.items():
                if group in found:
                    rows.append([method] + [cell(name, found[group][name]) for name in columns])
            if rows:
                parts.append("<h3>%s</h3>" % html.escape("All scenes" if group == "ALL" else group))
                parts.append(table(["method"] + columns, rows))
    meaning = "".join("<dt>%s</dt><dd>%s</dd>" % item for item in MEANING.items())
    return "\n".join(parts) + "<h3>Columns</h3><p>Means over scenes.</p><dl>%s</dl>" % meaning


def shortened(text):
    """Fractions of tables with three digits."""
    return "%.3f" % float(text) if "." in text else text


def camera_table(report):
    """A row a method and data set; those of its groups stand before it."""
    if not report.cameras:
        return ""
    columns = ["scenes"] + CAMERA_SCORES + PICTURE_BOXES + ["ms"]
    rows = []
    for row in report.cameras:
        camera = row["camera"] + (": " + row["group"] if row["group"] else "")
        rows.append([row["method"], camera] + [shortened(row[column]) for column in columns])
    note = ("<p>A camera is a data set. Scores are means over its scenes with labels, object level. Of scenes with boxes "
            "in the picture: objects, those found (bounding boxes of object and segment overlap by 0.5) and tight (by "
            "0.7), those merged (in a segment with another object), segments, and stray ones (that overlap no object by "
            "0.1). ms: median.</p>")
    return "<h2>By camera</h2>" + note + table(["method", "camera"] + columns, rows)


def box_table(report):
    """Boxes in space, where objects.yaml has them."""
    if not report.boxes:
        return ""
    columns = [column for column in report.boxes[0] if column not in ("method", "by", "name")]
    rows = [[row["method"], "ALL" if row["by"] == "all" else row["by"] + " " + row["name"]] +
            [shortened(row[column]) for column in columns] for row in report.boxes]
    note = ("<p>The boxes of segments against the true ones. segmented: objects whose segment has a Dice over 0.75; "
            "IoU_all: mean intersection over union of all objects, 0 where there is no segment. The rest is of those "
            "segmented: IoU, share over 0.5 and 0.7, the same of the upright box around the visible points, errors of "
            "the centre, the yaw (none of round things), the longer, the shorter and the upright side, and the share "
            "of objects of which all sides are within 10 mm.</p>")
    return "<h2>Boxes in space</h2>" + note + table(["method", "of"] + columns, rows)


def proposal_tables(report):
    parts = []
    for method in report.methods:
        found = report.summary.get(method, {}).get("object", {})
        if not found or "boxed_objects" not in found["ALL"]:
            continue
        kept = kept_boxes(found["ALL"])
        for overlap in ("50", "70"):
            header = ["group", "objects"] + ["%s %d" % (name, n) for name in ("boxes", "fixed") for n in kept]
            rows = [[group, "%d" % figures["boxed_objects"]] + [
                "%.3f" % figures["%s%s_%d" % (name, overlap, n)] for name in ("box", "fixed") for n in kept]
                for group, figures in found.items()]
            parts.append("<h3>%s, overlap of at least 0.%s</h3>" % (html.escape(method), overlap) + table(header, rows))
        rows = [[group, "%.3f" % figures["best_P"], "%.3f" % figures["best_R"], "%.1f" % figures["proposals"]]
                for group, figures in found.items()]
        parts.append("<h3>%s, the single box of highest objectness</h3>" % html.escape(method) +
                     table(["group", "precision", "recall", "boxes a scene"], rows))
    if not parts:
        return ""
    return ("<h2>Proposals</h2><p>Share of the true objects that one of the first 1, 5, ... boxes overlaps in space, "
            "of the method's boxes by objectness and of a fixed list that knows only the table.</p>") + "\n".join(parts)


def cell(name, value):
    return "%d" % round(value) if name in ("scenes", "ms", "peak_mib") else "%.3f" % value


def median(values):
    values = sorted(values)
    half = len(values) // 2
    return values[half] if len(values) % 2 else (values[half - 1] + values[half]) / 2


def stage_table(report):
    rows = []
    for method in report.methods:
        times = {}  # in the order of the stages
        for result in report.results(method):
            for stage, ms in result["timings_ms"].items():
                times.setdefault(stage, []).append(ms)
        rows += [[method, stage, "%.1f" % median(ms), "%.1f" % max(ms)] for stage, ms in times.items()]
    jobs = report.run["jobs"]
    note = "" if jobs == 1 else "<p>%d scenes were computed at a time, which makes each slower.</p>" % jobs
    return "<h2>Milliseconds of each stage</h2>" + note + table(["method", "stage", "median", "largest"], rows)


def problem_list(report):
    problems = []
    for method in report.methods:
        for result in report.results(method):
            if result["state"] in ("failed", "unusable"):
                counted = "counts as nothing found" if result["state"] == "failed" else "not counted"
                problems.append([result["scene"], method, result["problem"], counted])
    if not problems:
        return ""
    return "<h2>Problems</h2>" + table(["scene", "method", "problem", ""], problems)


def worst_scenes(report):
    method, level = report.methods[0], report.levels[0]
    if "objectness" in report.methods:
        method = "objectness"
    rows = sorted(report.scenes(method, level), key=lambda row: (float(row["OvF"]), row["scene"]))[:WORST_SCENES]
    parts = ["<h2>The worst scenes of %s</h2><p>Lowest OvF first; left what was found, right the truth.</p>" % method]
    for row in rows:
        text = "%s (%s): OvF %.3f, P %.3f, R %.3f, F75 %.3f" % (
            row["scene"], row["group"], float(row["OvF"]), float(row["P"]), float(row["R"]), float(row["F75"]))
        parts.append("<h3>%s</h3>" % html.escape(text))
        found = report.path("results", method, row["scene"], "overlay.png")
        truth = report.path("truth", row["scene"] + ".png")
        pictures = [(path, name) for path, name in ((found, "found"), (truth, "truth")) if os.path.exists(path)]
        if row["state"] == "failed":
            parts.append("<p>The method failed here.</p>")
        parts.append('<div class="pair">' + "".join(
            '<img alt="%s" src="%s"> ' % (name, embedded(path, jpeg=True)) for path, name in pictures) + "</div>")
    return "\n".join(parts)


def write_html(report, plots):
    run = report.run
    origin = [["commit", run["commit"]], ["machine", "; and ".join(run["machines"])],
              ["scenes", len(run["scenes"])], ["at a time", run["jobs"]]]
    if run["shards"] > 1:
        origin.append(["shard", "%d of %d: only these scenes" % (run["shard"], run["shards"])])
    pictures = "".join('<img alt="%s" title="%s" src="%s">' % (html.escape(c), html.escape(c), embedded(p))
                       for c, p in plots)
    settings = "".join("<details><summary><b>%s</b>: %s</summary><pre>%s</pre></details>" % (
        html.escape(m["name"]), html.escape(m["description"]), html.escape(m["settings"])) for m in run["methods"])
    text = "\n".join([
        "<!DOCTYPE html>", '<html lang="en"><head><meta charset="utf-8"><title>Evaluation</title>',
        "<style>%s</style></head><body>" % STYLE, "<h1>Evaluation</h1>", table(["evaluated", ""], origin),
        camera_table(report), score_tables(report), '<h2>Plots</h2><div class="plots">%s</div>' % pictures,
        box_table(report), proposal_tables(report), stage_table(report), problem_list(report), worst_scenes(report),
        "<h2>Methods and their settings</h2>", settings, "</body></html>", ""])
    unfinished = report.path("report.html.part")
    with open(unfinished, "w", encoding="utf-8") as f:
        f.write(text)
    os.replace(unfinished, report.path("report.html"))


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if len(sys.argv) == 2 else 2
    report = Report(sys.argv[1])
    write_html(report, draw_plots(report))
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (OSError, KeyError, ValueError) as error:
        sys.exit("evaluation_report.py: %s: %r" % (sys.argv[1], error))
