#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks what the folders of src/ and include/ include of one another against the table in doc/architecture.md.

    test/repository/dependencies.py [--write]

A row of the table is "| `folder` | `folder`, `folder` |". A dependency without an entry and an entry without a dependency
are failures. --write puts what is included now into the table, in the order of its rows; a folder that is new or gone is
still for you to add or to take out.
"""
import argparse
import collections
import pathlib
import re
import sys

REPO = pathlib.Path(__file__).resolve().parents[2]
DOCUMENT = REPO / "doc" / "architecture.md"
HEADERS = REPO / "include" / "objectness_segmentation"
SOURCES = REPO / "src"
ROOT = "pipeline"  # the files that lie in no folder
TITLE = "## Allowed dependencies"
INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]', re.MULTILINE)
ROW = re.compile(r"^\| `(\w+)` \| (.*) \|$")


def folder_of(path):
    for base in (SOURCES, HEADERS):
        if base in path.parents:
            parts = path.relative_to(base).parts
            if len(parts) > 1:
                return parts[0]
            # A header or source beside the folders belongs to that one which holds the other half of it.
            halves = {half.parent.name for half in SOURCES.glob(f"*/{path.stem}.?pp")}
            return halves.pop() if len(halves) == 1 else ROOT
    return None


def included_file(name, source):
    for candidate in (source.parent / name, SOURCES / name, REPO / "include" / name):
        if candidate.is_file():
            return candidate.resolve()
    return None  # of the system, or generated


def dependencies():
    """Returns {folder: {other folder: an example "file -> header"}}."""
    found = collections.defaultdict(dict)
    for source in sorted([*SOURCES.rglob("*.?pp"), *HEADERS.rglob("*.hpp")]):
        folder = folder_of(source)
        found[folder]  # it is there even if it includes nothing
        for name in INCLUDE.findall(source.read_text(encoding="utf-8")):
            header = included_file(name, source)
            other = header and folder_of(header)
            if other and other != folder:
                found[folder].setdefault(other, f"{source.relative_to(REPO)} includes {name}")
    return dict(found)


def table_rows(lines):
    """Returns {folder: (line number, [folders])} of the table under TITLE."""
    if TITLE not in lines:
        sys.exit(f"dependencies: {DOCUMENT.relative_to(REPO)} has no line '{TITLE}'")
    rows = {}
    for number in range(lines.index(TITLE) + 1, len(lines)):
        if lines[number].startswith("## "):
            break
        match = ROW.match(lines[number])
        if match:
            rows[match[1]] = number, re.findall(r"`(\w+)`", match[2])
    return rows


def problems(found, allowed):
    for folder in sorted(found.keys() - allowed.keys()):
        yield f"{folder} has no row in the table"
    for folder in sorted(allowed.keys() - found.keys()):
        yield f"{folder} has a row in the table, but no files"
    for folder in sorted(found.keys() & allowed.keys()):
        for other in sorted(found[folder].keys() - set(allowed[folder])):
            yield f"{folder} must not depend on {other}: {found[folder][other]}"
        for other in sorted(set(allowed[folder]) - found[folder].keys()):
            yield f"{folder} is said to depend on {other}, and includes nothing of it"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true", help="change the table, not the sources")
    args = parser.parse_args()
    lines = DOCUMENT.read_text(encoding="utf-8").split("\n")
    rows, found = table_rows(lines), dependencies()
    if args.write:
        order = list(rows)
        for folder, (number, _) in rows.items():
            others = sorted(found.get(folder, {}), key=lambda other: (order.index(other) if other in order else 99, other))
            lines[number] = f"| `{folder}` | {', '.join(f'`{other}`' for other in others) or 'nothing'} |"
        DOCUMENT.write_text("\n".join(lines), encoding="utf-8")
        rows = table_rows(lines)
    wrong = list(problems(found, {folder: others for folder, (_, others) in rows.items()}))
    for problem in wrong:
        print(f"dependencies: {problem}", file=sys.stderr)
    if wrong:
        sys.exit(1)
    print(f"dependencies: {sum(map(len, found.values()))} between {len(found)} folders, all of them in the table")


if __name__ == "__main__":
    main()
