#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""embed_model.py MODEL.json OUT.cpp: writes a learned model as constants, so that nothing is parsed at run time."""
import json
import struct
import sys

FOREST = """const char* const k{name}Cues[] = {{{cues}}};
constexpr int k{name}TreeSizes[] = {{{sizes}}};
constexpr Forest::Node k{name}Nodes[] = {{
{nodes}}};
"""

FILE = """// SPDX-License-Identifier: BSD-3-Clause
// Written at build time from {source}.
#include <iterator>

#include "learning/default_model.hpp"

namespace objectness {{
namespace {{

{forests}
}}  // namespace

const EmbeddedModel kDefaultModel{{
    {trained_on},
    {members}}};

}}  // namespace objectness
"""


def text(value):
    return '"' + json.dumps(value)[1:-1] + '"'


def single(value):
    """The nearest float, exactly."""
    return float.hex(struct.unpack("f", struct.pack("f", value))[0]) + "f"


def node(fields):
    if len(fields) == 1:
        return "{-1, 0, 0, 0, %s}" % single(fields[0])
    cue, threshold, left, right = fields
    return "{%d, %s, %d, %d, 0}" % (cue, single(threshold), left, right)


def forest(name, model):
    trees = model["trees"]
    return FOREST.format(name=name, cues=", ".join(map(text, model["cues"])), sizes=", ".join(str(len(t)) for t in trees),
                         nodes="".join(node(n) + ",\n" for t in trees for n in t))


def member(name):
    arrays = [name + "Cues", name + "TreeSizes"]
    return "{%s, k%sNodes}" % (", ".join("k{0}, std::size(k{0})".format(a) for a in arrays), name)


def main(source, target):
    with open(source, encoding="utf-8") as file:
        model = json.load(file)
    parts = ["contact", "gap", "group"]
    names = [part.capitalize() for part in parts]
    with open(target, "w", encoding="ascii") as file:
        file.write(FILE.format(source=source.rsplit("/", 1)[-1], trained_on=text(model["trained_on"]),
                               forests="".join(forest(n, model[p]) for n, p in zip(names, parts)),
                               members=",\n    ".join(map(member, names))))


if __name__ == "__main__":
    main(*sys.argv[1:])
