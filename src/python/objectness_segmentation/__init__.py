# SPDX-License-Identifier: BSD-3-Clause
"""Finds and segments the objects on a table in one depth image by their 3D objectness.

    segment(depth, camera_matrix, color=None, **parameters)   one frame
    Segmenter(fuse_frames=8, **parameters)                    the frames of one camera, one after the other
    SegmentationError                                         why a frame could not be segmented, in a sentence

The messages and services of the ROS package of the same name are in its submodules msg and srv.
"""
__all__ = ['SegmentationError', 'Segmenter', 'segment']


def __getattr__(name):
    # Only when asked for: whoever imports the messages alone does without NumPy, OpenCV and the library.
    if name in __all__:
        from . import _segmentation
        return getattr(_segmentation, name)
    raise AttributeError(f'module {__name__!r} has no attribute {name!r}')


def __dir__():
    return sorted([*globals(), *__all__])
