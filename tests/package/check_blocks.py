"""Holds the code of docs/cpp.md to programs that are built and run: each block of C++ stands in one of the examples,
each block of CMake in the project that tests/package/check_install.sh builds.

usage: check_blocks.py ROOT
"""

import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])


def squeezed(text):
    return re.sub(r"\s+", " ", text).strip()


programs = [squeezed(path.read_text()) for path in sorted((root / "examples").glob("*.cpp"))]
projects = (root / "tests/package/check_install.sh").read_text()
bad = 0
blocks = re.findall(r"^```(\w+)\n(.*?)^```", (root / "docs/cpp.md").read_text(), re.M | re.S)
for language, block in blocks:
    if language == "cpp":
        is_there = any(squeezed(block) in program for program in programs)
    else:
        is_there = all(line.strip() in projects for line in block.splitlines())
    if not is_there:
        print(f"docs/cpp.md: this block is in no program:\n{block}")
        bad = 1
print(f"{len(blocks)} blocks")
sys.exit(bad or len(blocks) < 5)
