#!/usr/bin/env python3
"""Checks the tables of README.md beside it: each file of src that computes with doubles or floats is on a line, and each
path names a file. Python's module is left out, which hands numbers on.

usage: places.py
"""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
SRC = HERE.parents[1] / "src"
NUMBER = re.compile(r"\b(double|float|Vec2|Vec3|Mat3|Doubles?\w*|Floats?\w*|Numbers|Lanes)\b")
OPERATION = re.compile(r"(?<![-+*/<>=!&|(,\[{])\s[-+*/]=?\s|std::(sqrt|fma|abs|hypot|max|min|ldexp|floor|ceil)\b|"
                       r"\.(norm|dot|cross|squaredNorm|cwiseAbs)\(")


def computes(text):
    code = re.sub(r'//[^\n]*|^#[^\n]*|"(?:\\.|[^"\\\n])*"', "", text, flags=re.M)
    return NUMBER.search(code) is not None and OPERATION.search(code) is not None


def main():
    rows = [line for line in (HERE / "README.md").read_text(encoding="utf-8").splitlines() if line.startswith("| `")]
    paths = [path for row in rows for path in re.findall(r"`([^`]+)`", row.split(" | ")[0])]
    files = [file.relative_to(SRC).as_posix() for file in sorted(SRC.rglob("*.?pp"))]
    computing = [file for file in files if not file.startswith("python/") and computes((SRC / file).read_text(encoding="utf-8"))]
    wrong = [f"README.md has no line for src/{file}, which computes with doubles or floats" for file in computing
             if not any(file.startswith(path) for path in paths)]
    wrong += [f"README.md names {path}: there is no such place in src" for path in paths
              if not any(file.startswith(path) for file in files)]
    wrong += [f"README.md names {path} on two lines" for path in sorted({path for path in paths if paths.count(path) > 1})]
    print("\n".join(wrong) or f"{len(computing)} files that compute are on {len(rows)} lines")
    if wrong or len(computing) < 150:
        sys.exit(1)


main()
