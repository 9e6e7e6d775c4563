#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the commands of README.md, CONTRIBUTING.md and doc/*.md: commands.py TOOL_DIR (the folder of the built tools).

Every option that is shown of a tool or script is in its --help, every argument that is shown of a launch file is one of its
own. The README's commands of tools are run as they stand, on a simulated scene.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import numpy
from PIL import Image

REPO = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = [REPO / "README.md", REPO / "CONTRIBUTING.md", *sorted((REPO / "doc").glob("*.md"))]
TOOL_PREFIX = "build/devel/lib/objectness_segmentation/"
TOOLS = ("segment", "segment_bag", "make_scene", "evaluate", "learn_objectness")

FENCED = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]+")


def commands(text):
    """What is indented by four, its continuations by more, and the `code` within lines; without comments."""
    found = []
    for line in FENCED.sub("", text).splitlines():
        block = re.match(r"^ {4}( *)(\S.*)$", line)
        if block and block[1] and found:
            found[-1] += " " + block[2]
        elif block:
            found.append(block[2])
        found += re.findall(r"`([^`]+)`", line)
    return [re.sub(r"\s+#.*$", "", command).strip() for command in found]


def program(command, tools):
    """The file that a command begins with, None if it is none of ours."""
    words = re.split(r"[\s|\[]+", command)
    for word in words[1:2] if words[0] == "parallel" else words[:1]:
        name = word[len(TOOL_PREFIX):] if word.startswith(TOOL_PREFIX) else word
        if word.startswith(TOOL_PREFIX) or name in TOOLS:
            return tools / name
        if re.fullmatch(r"(scripts|test/repository)/[\w.]+", word):
            return REPO / word
    return None


def help_of(path, cache={}):
    if path not in cache:
        done = subprocess.run([path, "--help"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        cache[path] = done.stdout if done.returncode == 0 else None
    return cache[path]


def option_problems(command, tools):
    path = program(command, tools)
    if path is None:
        return
    if not path.exists():
        yield "there is no such program"
    elif OPTION.search(command):
        text = help_of(path)
        if text is None:
            yield f"{path.name} --help fails"
            return
        for option in OPTION.findall(command):
            if option != "--help" and option not in OPTION.findall(text):
                yield f"{path.name} --help does not know {option}"


def launch_problems(command):
    match = re.match(r"roslaunch (?:--ros-args )?objectness_segmentation (\w+\.launch)(.*)", command)
    if not match:
        return
    path = REPO / "launch" / match[1]
    if not path.exists():
        yield f"there is no {match[1]}"
        return
    known = {argument.get("name") for argument in ElementTree.parse(path).getroot().iter("arg") if argument.get("doc")}
    for argument in re.findall(r"(\w+):=", match[2]):
        if argument not in known:
            yield f"{match[1]} has no argument {argument}"


def write_pcd(scene, path):
    """The depth of a scene as an organized cloud."""
    depth_m = numpy.asarray(Image.open(scene / "depth.png")) / 1000.0
    height, width = depth_m.shape
    focal = float(re.search(r"camera_matrix:.*?data: *\[ *([\d.]+)", (scene / "camera.yaml").read_text(), re.DOTALL)[1])
    v, u = numpy.mgrid[:height, :width]
    depth_m[depth_m == 0] = numpy.nan
    points = numpy.stack([(u - 0.5 * (width - 1)) / focal * depth_m, (v - 0.5 * (height - 1)) / focal * depth_m, depth_m], -1)
    header = (f"VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {width}\nHEIGHT {height}\n"
              f"VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {width * height}\nDATA binary\n")
    path.write_bytes(header.encode() + points.astype("<f4").tobytes())


def run_problems(text, tools):
    """Runs the tools' commands in a folder where all is that they name."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        make_scene = [tools / "make_scene", "--demo", "--size", "320x240"]
        subprocess.run([*make_scene, "--out", folder / "scene"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([*make_scene, "--frames", "2", "--bag", folder / "recording.bag"], check=True, stdout=subprocess.DEVNULL)
        write_pcd(folder / "scene", folder / "cloud.pcd")
        (folder / TOOL_PREFIX).parent.mkdir(parents=True)
        (folder / TOOL_PREFIX).symlink_to(tools)
        ran = 0
        for command in commands(text):
            if not command.startswith(TOOL_PREFIX):
                continue
            done = subprocess.run(command.split(), cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            ran += 1
            if done.returncode != 0:
                yield f"`{command}` fails: {done.stdout.strip()}"
        for result in ("results/scene/labels.png", "results/cloud/overlay.png", "results.bag"):
            if not (folder / result).exists():
                yield f"{ran} commands were run, and there is no {result}"


def main():
    if len(sys.argv) != 2 or not os.path.isdir(sys.argv[1]):
        sys.exit(__doc__)
    tools = pathlib.Path(sys.argv[1]).resolve()
    wrong, count = [], 0
    for document in DOCUMENTS:
        text = document.read_text(encoding="utf-8")
        for command in commands(text):
            count += program(command, tools) is not None or command.startswith("roslaunch")
            for problem in [*option_problems(command, tools), *launch_problems(command)]:
                wrong.append(f"{document.relative_to(REPO)}: `{command}`: {problem}")
        if document.name == "README.md":
            wrong += [f"README.md: {problem}" for problem in run_problems(text, tools)]
    if count < 20:
        wrong.append(f"only {count} commands were found")
    for problem in wrong:
        print(f"commands: {problem}", file=sys.stderr)
    if wrong:
        sys.exit(1)
    print(f"commands: {count} of them can be given as the documents say")


if __name__ == "__main__":
    main()
