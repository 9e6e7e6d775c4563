# SPDX-License-Identifier: BSD-3-Clause
"""Arrays of the user, checked, as the compiled part takes them: C-contiguous, in the machine's byte order."""
import numpy


def _shape(array):
    return ' x '.join(map(str, array.shape)) or 'a single value'


def depth_image(depth):
    """H x W of uint16 or float32; other floats are converted."""
    depth = numpy.asarray(depth)
    if depth.dtype.kind == 'f':
        dtype = numpy.float32
    elif depth.dtype.kind == 'u' and depth.dtype.itemsize == 2:
        dtype = numpy.uint16
    else:
        raise TypeError(f'depth is of {depth.dtype}, must be of float (metres) or uint16 (millimetres): '
                        'convert it with depth.astype(numpy.uint16) if it holds whole millimetres')
    if depth.ndim != 2:
        raise ValueError(f'depth is {_shape(depth)}, must be H x W')
    return numpy.ascontiguousarray(depth, dtype)


def color_image(color):
    """H x W x 3 of uint8, RGB; an empty array for None."""
    if color is None:
        return numpy.empty((0, 0, 3), numpy.uint8)
    color = numpy.asarray(color)
    if color.dtype != numpy.uint8:
        raise TypeError(f'color is of {color.dtype}, must be of uint8')
    if color.ndim != 3 or color.shape[2] != 3:
        raise ValueError(f'color is {_shape(color)}, must be H x W x 3 (RGB)')
    if color.size == 0:
        raise ValueError(f'color is {_shape(color)}: it has no pixels')
    return numpy.ascontiguousarray(color)


def _matrix(values, name, size):
    """size x size of float64."""
    values = numpy.asarray(values)
    if values.dtype.kind not in 'fiu':
        raise TypeError(f'{name} is of {values.dtype}, must be of float')
    if values.shape != (size, size):
        raise ValueError(f'{name} is {_shape(values)}, must be {size} x {size}')
    return values.astype(numpy.float64)


def intrinsics(camera_matrix):
    """fx, fy, cx, cy of [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]."""
    k = _matrix(camera_matrix, 'camera_matrix', 3)
    if k[0, 1] != 0 or k[1, 0] != 0 or tuple(k[2]) != (0, 0, 1):
        raise ValueError(f'camera_matrix is {k.tolist()}, must be [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]')
    return [float(k[0, 0]), float(k[1, 1]), float(k[0, 2]), float(k[1, 2])]


def pose(transform, name):
    """The 16 numbers of a rigid 4 x 4 transform, row by row; None for None."""
    if transform is None:
        return None
    t = _matrix(transform, name, 4)
    rotation = t[:3, :3]
    rigid = numpy.allclose(rotation @ rotation.T, numpy.eye(3), atol=1e-4) and numpy.linalg.det(rotation) > 0
    if not (rigid and numpy.isfinite(t).all() and tuple(t[3]) == (0, 0, 0, 1)):
        raise ValueError(f'{name} is no rigid transform: it must be a rotation and a translation over 0, 0, 0, 1')
    return [float(value) for value in t.ravel()]
