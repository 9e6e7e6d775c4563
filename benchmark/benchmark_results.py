# SPDX-License-Identifier: BSD-3-Clause
"""The results of benchmark_objectness: run.json and benchmark.json of a report folder."""
import collections
import json
import pathlib
import statistics

Scene = collections.namedtuple("Scene", "name objects width height simulated")
COMPARED_WIDTH_PX = 640  # of the pictures that the figures are about


class Value:
    """What was measured several times: median and range, in the unit of the numbers."""

    def __init__(self, numbers):
        self.numbers = sorted(numbers)
        self.median = statistics.median(numbers)
        self.least, self.largest = self.numbers[0], self.numbers[-1]

    def __str__(self):
        spread = "" if len(self.numbers) == 1 else " (%s to %s)" % (short(self.least), short(self.largest))
        return short(self.median) + spread

    def to_json(self):
        return {"median": self.median, "least": self.least, "largest": self.largest, "runs": len(self.numbers)}


def short(number):
    """Three digits."""
    return "%.0f" % number if abs(number) >= 100 else "%.1f" % number if abs(number) >= 10 else "%.2f" % number


class Measurement:
    """The runs of one benchmark PART/KIND/VOLUME/SCENE."""

    def __init__(self):
        self.wall, self.cpu, self.counters = [], [], collections.defaultdict(list)

    def add(self, entry):
        self.wall.append(entry["real_time"])
        self.cpu.append(entry["cpu_time"])
        for name, value in entry.items():
            if name.startswith(("stage:", "count:")) or name in ("boxes", "scored", "nodes", "passed", "peak_mib"):
                self.counters[name].append(value)

    def counter(self, name):
        """The median, nothing when it was not counted."""
        return statistics.median(self.counters[name]) if name in self.counters else None


class Results:
    """Everything of one run; times in ms. `failures` are the benchmarks that gave no result, with the reason."""

    def __init__(self, folder):
        folder = pathlib.Path(folder)
        self.run = json.loads((folder / "run.json").read_text())
        self.scenes = [Scene(s["name"], s["objects"], s["width"], s["height"], s["name"].startswith("sim"))
                       for s in self.run["scenes"]]
        self.measured, self.failures = {}, []
        for entry in json.loads((folder / "benchmark.json").read_text())["benchmarks"]:
            if entry.get("run_type") == "aggregate":
                continue
            key = tuple(entry["name"].split("/")[:4])
            if entry.get("error_occurred"):
                self.failures.append(("/".join(key), entry.get("error_message", "")))
            else:
                self.measured.setdefault(key, Measurement()).add(entry)

    def get(self, part, kind, volume, scene):
        return self.measured.get((part, kind, volume, scene.name))

    def wall(self, part, kind, volume, scene):
        """Median in ms, nothing when it was not measured. Searches and volumes: CPU time of one thread."""
        found = self.get(part, kind, volume, scene)
        return statistics.median(found.wall) if found else None

    def select(self, least=0, most=10**9, width=COMPARED_WIDTH_PX, simulated=None):
        """Scenes by their number of objects and kind."""
        return [s for s in self.scenes if least <= s.objects <= most and (width is None or s.width == width)
                and (simulated is None or s.simulated == simulated)]
