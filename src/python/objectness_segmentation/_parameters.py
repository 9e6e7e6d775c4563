# SPDX-License-Identifier: BSD-3-Clause
"""Parameters as Python has them, as the text that the library reads."""
import collections.abc
import math
import numbers

import numpy


def _text(value):
    """A value as YAML has it. What is none of its kinds stays as it is written in Python, for the library to name."""
    if isinstance(value, (bool, numpy.bool_)):
        return 'true' if value else 'false'
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        value = float(value)
        if math.isnan(value):
            return '.nan'
        if math.isinf(value):
            return '.inf' if value > 0 else '-.inf'
        return repr(value)
    return str(value)


def assignments(parameters):
    """The list of 'group.field=value' of {'group.field': value} or, as in a preset, {'group': {'field': value}}."""
    flat = {}
    for name, value in parameters.items():
        if isinstance(value, collections.abc.Mapping):
            flat.update({f'{name}.{field}': field_value for field, field_value in value.items()})
        else:
            flat[name] = value
    return [f'{name}={_text(value)}' for name, value in flat.items()]
