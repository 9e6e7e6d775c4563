#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Objects of a scene folder: segment_scene.py FOLDER"""
import sys
import numpy
import PIL.Image
from objectness_segmentation import segment

depth = numpy.asarray(PIL.Image.open(sys.argv[1] + '/depth.png')).astype(numpy.uint16)  # mm; metres: float
camera_matrix = [[525, 0, 319.5], [0, 525, 239.5], [0, 0, 1]]
found = segment(depth, camera_matrix, runtime={'threads': 4})  # keys as in objects.json
for item in found['objects']:
    print(item['label'], item['position'], item['size'], item['objectness'])
