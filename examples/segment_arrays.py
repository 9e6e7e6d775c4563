#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""From a depth image to objects in Python, cell by cell (# %% is a cell of Jupyter, VS Code or Spyder).

    source build/devel/setup.bash
    build/devel/lib/objectness_segmentation/make_scene --demo --out scene
    examples/segment_arrays.py scene        # prints what it finds, and draws it into segments.png
"""
# %% What is needed, and a scene folder: depth.png (16-bit millimetres), color.png and camera.yaml.
import pathlib
import sys

import matplotlib
import numpy
import PIL.Image
import yaml

from objectness_segmentation import SegmentationError, Segmenter, segment

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of where to draw)

scene = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else 'scene')
depth = numpy.asarray(PIL.Image.open(scene / 'depth.png')).astype(numpy.uint16)
color = numpy.asarray(PIL.Image.open(scene / 'color.png').convert('RGB'))
camera = yaml.safe_load((scene / 'camera.yaml').read_text())
camera_matrix = numpy.array(camera['camera_matrix']['data']).reshape(3, 3)

# %% One frame. Everything is in the camera's optical frame: x right, y down, z forward, metres.
found = segment(depth, camera_matrix, color)
print(f"{len(found['objects'])} objects in {found['report']['timings_ms']['total']:.0f} ms")
for item in found['objects']:
    print(f"  {item['label']}: centre {item['position'].round(3)} m, sides {item['size'].round(3)} m, "
          f"objectness {item['objectness']:.2f}, {'round' if item['round'] else 'not round'}")

# %% The points of the best object: its pixels, on the rays of the camera.
best = found['objects'][0]
v, u = numpy.nonzero(found['labels'] == best['label'])
z = 0.001 * depth[v, u]
fx, fy, cx, cy = camera_matrix[0, 0], camera_matrix[1, 1], camera_matrix[0, 2], camera_matrix[1, 2]
points = numpy.column_stack([(u - cx) / fx * z, (v - cy) / fy * z, z])
print(f"{len(points)} points of object {best['label']}, {points[:, 2].min():.3f} to {points[:, 2].max():.3f} m away")

# %% How high each object stands on the table, from the table's plane.
table = found['table']
for item in found['objects']:
    height = table['normal'] @ item['position'] + table['d']
    print(f"  {item['label']}: its centre is {1000 * height:.0f} mm over the table")

# %% Parameters have the names of `segment --list-parameters`. This is the paper's method, on two threads.
paper = segment(depth, camera_matrix, grouping={'enabled': False}, runtime={'threads': 2})
print(f"the paper's method: {len(paper['objects'])} objects of {paper['report']['boxes_scored']} boxes")

# %% What is wrong is said.
for wrong in ({'threads': 2}, {'runtime': {'threads': 'many'}}, {'input': {'min_depth_m': 5, 'max_depth_m': 6}}):
    try:
        segment(depth, camera_matrix, **wrong)
    except SegmentationError as error:
        print(f'{error.status}: {error}')

# %% Frames of a camera, here twice the same one: objects are known again, and depth is averaged while nothing moves.
segmenter = Segmenter(fuse_frames=8)
for k in range(2):
    followed = segmenter.segment(depth, camera_matrix, color, time_s=k / 30)
print('seen in frames:', {item['identity']['id']: item['identity']['age_frames'] for item in followed['objects']})

# %% A picture.
shades = plt.get_cmap('tab20')(found['labels'] % 20)[..., :3]
is_object = (found['labels'] >= 2)[..., None]
plt.imsave('segments.png', numpy.where(is_object, 0.5 * shades + 0.5 * color / 255, color / 255))
