# SPDX-License-Identifier: BSD-3-Clause
"""What users call: segment(), Segmenter and their error."""
import json
import math
import warnings

import numpy

from . import _arrays, _core, _parameters

# The fields of objects.json that are arrays, by name: dtype and shape.
_ARRAYS = {
    'normal': (float, (3,)),
    'position': (float, (3,)),
    'orientation': (float, (4,)),
    'size': (float, (3,)),
    'hull': (float, (-1, 2)),
    'hull_measured': (bool, (-1,)),
    'outline': (float, (-1, 3)),
}


class SegmentationError(ValueError):
    """A parameter, a camera or a frame that nothing can be segmented with.

    str() is a sentence that says what would help.

    status: its kind, as in objects.json and the messages: 'bad_config', 'bad_camera', 'bad_input', 'size_mismatch',
        'no_valid_points', 'no_table', 'volume_too_large', 'internal_error'.
    """

    def __init__(self, message, status):
        super().__init__(message, status)  # both: an exception is pickled by its arguments
        self.status = status

    def __str__(self):
        return self.args[0]


def _check(status):
    name, message = status
    if name != 'ok':
        raise SegmentationError(message, name)


def _config(parameters):
    config = _core.Config()
    status, replaced = config.set(_parameters.assignments(parameters))
    _check(status)
    for sentence in replaced:
        warnings.warn(sentence, FutureWarning, stacklevel=3)
    return config


def _with_arrays(fields):
    for name in fields.keys() & _ARRAYS.keys():
        dtype, shape = _ARRAYS[name]
        fields[name] = numpy.array(fields[name], dtype).reshape(shape)
    return fields


def _result(status, labels, text):
    _check(status)
    result = {'labels': labels, **json.loads(text, object_hook=_with_arrays)}
    del result['input'], result['status']  # no file, and always 'ok'
    return result


def segment(depth, camera_matrix, color=None, **parameters):
    """Finds and segments the objects on a table.

    Everything is in the camera's optical frame (x right, y down, z forward), in metres; quaternions are x, y, z, w.
    Other Python threads run while it computes. The same input gives the same result whatever runtime.threads is.

    depth: H x W, rectified. Of float: metres, where NaN, infinite, 0 and less are pixels without depth. Of uint16:
        millimetres (or input.depth_unit_m), 0 without depth.
    camera_matrix: 3 x 3, [[fx, 0, cx], [0, fy, cy], [0, 0, 1]], pixels, of the depth image; the first pixel's centre is
        (0, 0).
    color: H x W x 3 of uint8, RGB, registered to depth, or None. It is checked; objects are found by depth alone.
    parameters: by their full names, **{'runtime.threads': 4}, or by group as in a YAML preset, runtime={'threads': 4}:
        **yaml.safe_load(open('cfg/paper.yaml')) is a preset. `segment --list-parameters` lists them.

    Returns a dict with the names of objects.json:
      labels   H x W of uint16: 0 nothing, 1 table, 2 and above one object each
      objects  a list of dicts, largest objectness first:
        label               int, its pixels in `labels`
        position, orientation, size   (3,) centre, (4,) axes, (3,) sides of the box of the whole object: z away from the
                            table, x along the longer side
        visible_box         the box of what is seen: {position, orientation, size}
        objectness          float: expected overlap with one whole object, 0 to 1 (paper's method: Eq. 6)
        cues                {edge_density, outer_edges, straddling, free_space}, floats
        points              int, number of its measured pixels
        round               bool, a thing of revolution about the box's z axis
        supported_by        int, label of what it stands on: 1 the table, 0 something that is no object
        base_height         float, of the surface it stands on, over the table
        supports            list of int, labels of what stands on it
      table    dict: normal (3,) towards the camera and d of the plane normal . p + d = 0; frame {position (3,),
               orientation (4,)}; hull (N, 2), its outline in that frame; hull_measured (N,) of bool, whether the side
               from a corner to the next is the edge as it was seen
      unmeasured  things without depth, a list of dicts: outline (N, 3) on the table, which holds the thing's foot;
               points and area of the hole in the picture; table_share and noise_ratio, how surely it is one; box
               {position, orientation, size}, or None where its height cannot be told
      remarks  list of str: what is unusual about the input, or makes the result doubtful
      report   dict: counts and values of the stages, and timings_ms, a dict of milliseconds

    No object on the table is a valid result. Raises SegmentationError where there is none, also for unknown parameters
    and bad values; TypeError and ValueError for arrays of another type or shape.
    """
    config = _config(parameters)
    images = _arrays.depth_image(depth), _arrays.intrinsics(camera_matrix), _arrays.color_image(color)
    return _result(*_core.segment(*images, config))


class Segmenter:
    """Segments the frames of one camera, one after the other: results of a scene that stands still do, too.

    While camera and scene stand still depth is averaged over the last frames. Objects keep their identity from frame to
    frame, and the boxes of those that do not move settle. Threads may share one: their frames come one by one.

    fuse_frames: over how many frames depth is averaged, 1 to 100; 1: every frame for itself.
    parameters: as in segment(); the group `tracking` says how objects are known again.
    """

    def __init__(self, fuse_frames=_core.FUSE_FRAMES, **parameters):
        if fuse_frames not in range(1, _core.MAX_FUSE_FRAMES + 1):
            raise ValueError(f'fuse_frames is {fuse_frames!r}, must be 1 to {_core.MAX_FUSE_FRAMES}')
        self._config = _config(parameters)
        self._sequence = _core.Sequence(int(fuse_frames))

    def segment(self, depth, camera_matrix, color=None, *, time_s, T_fixed_camera=None):
        """segment() of the frame that follows.

        time_s: the frame's stamp, seconds. One a second or more before the last forgets everything first.
        T_fixed_camera: 4 x 4, maps points of the camera to a frame in which the table stands still. None: not known,
            and whether the camera stands still is told by the picture.

        Returns what segment() returns; `labels` and objects[i]['label'] are those of this frame, by rank. Each object
        has also, unless tracking.enabled is off,
          identity  dict: label (int, 2 and above, keeps to the object while it stays), id (int, never used again),
                    age_frames (int), age_s (float), confidence (float, 0 to 1: how well it agreed with itself lately)
        """
        images = _arrays.depth_image(depth), _arrays.intrinsics(camera_matrix), _arrays.color_image(color)
        pose = _arrays.pose(T_fixed_camera, 'T_fixed_camera')
        time_s = float(time_s)
        if not math.isfinite(time_s):
            raise ValueError(f'time_s is {time_s}, must be finite')
        *found, identities = self._sequence.next(*images, self._config, time_s, pose)
        result = _result(*found)
        for item, identity in zip(result['objects'], identities):
            item['identity'] = identity
        return result
