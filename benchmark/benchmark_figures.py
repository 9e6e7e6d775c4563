# SPDX-License-Identifier: BSD-3-Clause
"""The figures that the package is to reach, from the results of one run."""
import statistics

from benchmark_results import short

# Who is how crowded, by the true number of objects.
FEW, SOME, MANY, MOST = (2, 3), (2, 7), (14, 16), (14, 20)


class Figure:
    """A row of the table: `values` by scene; every one, and with median_target their median, is to be small enough."""

    def __init__(self, name, unit, target, values, median_target=None):
        self.name, self.unit, self.target, self.median_target = name, unit, target, median_target
        self.values = {scene: value for scene, value in values.items() if value is not None}

    def median(self):
        return statistics.median(self.values.values())

    def worst(self):
        return max(self.values.values())

    def is_reached(self):
        # A figure of times is a median over scenes, as it is over runs; a ratio or a memory is to hold everywhere.
        if self.median_target is not None:
            return self.worst() <= self.target and self.median() <= self.median_target
        return (self.median() if self.unit == "ms" else self.worst()) <= self.target

    def text(self, number):
        return "1/%.0f" % (1 / number) if self.unit == "share" else short(number) + (" " + self.unit).rstrip()

    def target_text(self):
        text = "at most " + self.text(self.target)
        if self.median_target is not None:
            text += " everywhere, %s in the median" % self.text(self.median_target)
        return text

    def row(self):
        if not self.values:
            return [self.name, self.target_text(), "not measured", "", "", ""]
        return [self.name, self.target_text(), self.text(self.median()),
                "%s to %s" % (self.text(min(self.values.values())), self.text(self.worst())), len(self.values),
                "yes" if self.is_reached() else "no"]

    def to_json(self):
        if not self.values:
            return {"name": self.name, "target": self.target_text(), "scenes": 0}
        return {"name": self.name, "target": self.target_text(), "unit": self.unit, "median": self.median(),
                "least": min(self.values.values()), "largest": self.worst(), "scenes": len(self.values),
                "reached": self.is_reached()}


def ratio(results, one, other):
    """By scene; nothing where one of the two was not measured."""
    def of(scene):
        a, b = results.wall(*one, scene), results.wall(*other, scene)
        return a / b if a is not None and b else None
    return of


def figures(results, simulated):
    """Of recorded or of simulated scenes."""
    def over(value, least=1, most=10**9):
        return {s.name: value(s) for s in results.select(least, most, simulated=simulated)}

    def wall(*key):
        return lambda scene: results.wall(*key, scene)

    def peak(method, volume):
        def of(scene):
            found = results.get("frame", method, volume, scene)
            return found.counter("peak_mib") if found else None
        return of

    bounded, scan, plain = (("search", kind, "wide") for kind in ("bounded", "scan", "plain"))
    default, paper = ("frame", "objectness", "none"), ("frame", "paper", "tight")
    best, strict = ("frame", "paper_top_k", "tight"), ("frame", "paper_strict", "tight")
    lccp, lccp_pcl = ("frame", "lccp", "none"), ("frame", "lccp_pcl_normals", "none")
    euclidean, organized = ("frame", "euclidean", "none"), ("frame", "organized", "none")
    angles, strict_angles = wall("angles", "all", "wide"), wall("angles", "strict", "wide")
    return [
        Figure("exact search, wide, against the nested loop, CPU time", "share", 1 / 40,
               over(ratio(results, bounded, plain)), 1 / 100),
        Figure("the same against the vectorized scan", "share", 1 / 8, over(ratio(results, bounded, scan))),
        Figure("volumes and search, wide, 2 to 7 objects", "ms", 25, over(angles, *SOME)),
        Figure("the same, 14 to 16 objects", "ms", 50, over(angles, *MANY)),
        Figure("volumes and search, wide, `cfg/strict.yaml`, 2 to 7 objects", "ms", 25, over(strict_angles, *SOME)),
        Figure("the same, 14 to 16 objects", "ms", 50, over(strict_angles, *MANY)),
        Figure("frame, `paper`, 2 to 3 objects", "ms", 33, over(wall(*paper), *FEW)),
        Figure("frame, `paper`, `cfg/strict.yaml`, 2 to 3 objects", "ms", 33, over(wall(*strict), *FEW)),
        Figure("the same, 14 to 16 objects", "ms", 66, over(wall(*strict), *MANY)),
        Figure("frame, `paper`, 14 to 16 objects, every box over the threshold", "ms", 66, over(wall(*paper), *MANY)),
        Figure("frame, `paper`, 14 to 16 objects, the 1000 best boxes", "ms", 33, over(wall(*best), *MANY)),
        Figure("frame, `objectness`, 2 to 3 objects", "ms", 33, over(wall(*default), *FEW)),
        Figure("frame, `objectness`, 14 to 20 objects", "ms", 50, over(wall(*default), *MOST)),
        Figure("frame, `objectness`, against LCCP after the same front end, 2 to 3 objects", "", 0.5,
               over(ratio(results, default, lccp), *FEW)),
        Figure("the same, 14 to 20 objects", "", 1.0, over(ratio(results, default, lccp), *MOST)),
        Figure("frame, `objectness`, against LCCP after the same front end with PCL's normals, 2 to 3 objects", "", 0.5,
               over(ratio(results, default, lccp_pcl), *FEW)),
        Figure("the same, 14 to 20 objects", "", 1.0, over(ratio(results, default, lccp_pcl), *MOST)),
        Figure("frame, `paper`, against LCCP after the same front end, 2 to 3 objects", "", 0.5,
               over(ratio(results, paper, lccp), *FEW)),
        Figure("the same, 14 to 20 objects", "", 1.0, over(ratio(results, paper, lccp), *MOST)),
        Figure("frame, `paper`, against LCCP after the same front end with PCL's normals, 2 to 3 objects", "", 0.5,
               over(ratio(results, paper, lccp_pcl), *FEW)),
        Figure("the same, 14 to 20 objects", "", 1.0, over(ratio(results, paper, lccp_pcl), *MOST)),
        Figure("frame, `objectness`, against RANSAC's plane and Euclidean clusters, PCL alone, 2 to 3 objects", "", 1.0,
               over(ratio(results, default, euclidean), *FEW)),
        Figure("the same, 14 to 20 objects", "", 1.0, over(ratio(results, default, euclidean), *MOST)),
        Figure("frame, `objectness`, against RANSAC's plane and organized clusters, PCL alone, 2 to 3 objects", "", 1.0,
               over(ratio(results, default, organized), *FEW)),
        Figure("the same, 14 to 20 objects", "", 1.0, over(ratio(results, default, organized), *MOST)),
        Figure("peak memory, `objectness`", "MiB", 300, over(peak("objectness", "none"))),
        Figure("peak memory, `paper`", "MiB", 300, over(peak("paper", "tight"))),
        Figure("peak memory, `paper`, wide", "MiB", 300, over(peak("paper", "wide"))),
    ]
