#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that what README.md, CONTRIBUTING.md and doc/*.md point to is there: links and their anchors, paths and names of
files in `code`, C++ blocks (each is a part of a file in examples/). README.md has 150 lines at most and leads to every
document."""
import pathlib
import re
import sys

REPO = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = [REPO / "README.md", REPO / "CONTRIBUTING.md", *sorted((REPO / "doc").glob("*.md"))]
MAX_README_LINES = 150
FOLDERS = sorted(p.name for p in REPO.iterdir() if p.is_dir() and not p.name.startswith((".", "build", "out")))

LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
CODE = re.compile(r"`([^`\n]+)`")
PATH = re.compile(r"(?:%s)/[\w./*+-]*" % "|".join(map(re.escape, FOLDERS)))
FILE_NAME = re.compile(r"[a-z_][a-z0-9_*]*\.(?:cpp|hpp|launch|test)")
FENCED = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def repository_files():
    return {path.name for folder in FOLDERS for path in (REPO / folder).rglob("*") if path.is_file()}


def anchors(text):
    """As GitHub makes them of headings."""
    headings = re.findall(r"^#+ (.*)$", FENCED.sub("", text), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def link_problems(document, text):
    for target in LINK.findall(FENCED.sub("", text)):
        if re.match(r"\w+:", target):
            continue  # of the web: not looked at here
        name, _, anchor = target.partition("#")
        path = (document.parent / name).resolve() if name else document
        if not path.exists():
            yield f"links to {name}, which is not there"
        elif anchor and anchor not in anchors(path.read_text(encoding="utf-8")):
            yield f"links to {target}, which has no such heading"


def code_of(text):
    """What is set as code: within lines, and lines that are indented."""
    plain = FENCED.sub("", text)
    yield from CODE.findall(plain)
    for line in re.findall(r"^ {4}(.*)$", plain, re.MULTILINE):
        yield line.partition("#")[0]


def path_problems(text, files):
    for code in code_of(text):
        for word in re.split(r"[\s,|\[\]()]+", code):
            word = word.rstrip(".:;")
            if any(part.isupper() for part in word.split("/")):
                continue  # stands for another name
            if PATH.fullmatch(word) and not any(REPO.glob(word.rstrip("/"))):
                yield f"names {word}, which is not there"
            if FILE_NAME.fullmatch(word) and not any(pathlib.PurePath(name).match(word) for name in files):
                yield f"names {word}, and no file is called so"


def block_problems(text):
    examples = [path.read_text(encoding="utf-8") for path in (REPO / "examples").iterdir() if path.is_file()]
    for language, block in FENCED.findall(text):
        if language in ("cpp", "python") and not any(block in example for example in examples):
            yield f"has a {language} block that is in no file of examples/: {block.splitlines()[0]}"


def readme_problems(text):
    lines = text.count("\n")
    if lines > MAX_README_LINES:
        yield f"has {lines} lines; {MAX_README_LINES} are allowed"
    for document in DOCUMENTS[1:]:
        name = str(document.relative_to(REPO))
        if name not in LINK.findall(text):
            yield f"does not link to {name}"


def main():
    wrong = []
    files = repository_files()
    for document in DOCUMENTS:
        text = document.read_text(encoding="utf-8")
        problems = [*link_problems(document, text), *path_problems(text, files), *block_problems(text)]
        if document.name == "README.md":
            problems += readme_problems(text)
        wrong += [f"{document.relative_to(REPO)} {problem}" for problem in problems]
    for problem in wrong:
        print(f"documents: {problem}", file=sys.stderr)
    if wrong:
        sys.exit(1)
    print(f"documents: all that {len(DOCUMENTS)} documents point to is there")


if __name__ == "__main__":
    main()
