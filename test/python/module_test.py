# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the Python module share: the demo scene, the tool `segment`, and when results are the same."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy
import PIL.Image
import yaml

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
TOOL_DIR = pathlib.Path(os.environ['OBJECTNESS_TOOL_DIR'])


def read_png(path):
    """A 16-bit picture as uint16, others as they are."""
    array = numpy.asarray(PIL.Image.open(path))
    return array if array.dtype == numpy.uint8 else array.astype(numpy.uint16)


def without_times(result):
    """A result as the text of all but its times: equal texts are results that are equal to the bit."""
    def plain(value):
        if isinstance(value, dict):
            return {name: plain(item) for name, item in value.items() if name != 'timings_ms'}
        if isinstance(value, list):
            return [plain(item) for item in value]
        return value.tolist() if isinstance(value, numpy.ndarray) else value

    return json.dumps(plain(result), sort_keys=True)


class ModuleTest(unittest.TestCase):
    """Has the demo scene at 320 x 240: `depth` (uint16), `color` (RGB), `camera_matrix`, and its folder, `scene`."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.scene = cls.make_scene('scene', '--size', '320x240')
        cls.depth, cls.color, cls.camera_matrix = cls.read_scene(cls.scene)

    @classmethod
    def make_scene(cls, name, *options):
        cls.run_tool('make_scene', '--demo', *options, '--out', cls.folder / name)
        return cls.folder / name

    @staticmethod
    def read_scene(scene):
        camera = yaml.safe_load((scene / 'camera.yaml').read_text())
        matrix = numpy.array(camera['camera_matrix']['data']).reshape(3, 3)
        return read_png(scene / 'depth.png'), read_png(scene / 'color.png'), matrix

    @staticmethod
    def run_tool(tool, *arguments, ok=True):
        """What the tool says on standard error."""
        done = subprocess.run([TOOL_DIR / tool, *arguments], capture_output=True, text=True, check=False)
        if (done.returncode == 0) != ok:
            raise AssertionError(f'{tool} {arguments}: exit status {done.returncode}: {done.stderr}')
        return done.stderr

    def segment_by_tool(self, *options):
        """objects.json with labels.png in it, as segment() returns them."""
        self.run_tool('segment', *options, '--out', self.folder / 'out', self.scene)
        folder = self.folder / 'out' / 'scene'
        result = json.loads((folder / 'objects.json').read_text())
        del result['input'], result['status']
        return {'labels': read_png(folder / 'labels.png'), **result}
