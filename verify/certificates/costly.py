"""Certificates that are short and take long: both checkers count what they cost, digits too, and refuse them once it is too much.

usage: costly.py CHECKER [--python CHECK] [--seconds]

Nothing is timed but with --seconds, which prints how long a unit of work takes in each checker, by families.
"""
import argparse
import importlib
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from checkers import HERE, digest

ONE, ZERO = "0x1p+0", "0x0p+0"
FAR = "0x1p+1000"  # the bodies are so far from each other, but for less than any double tells
LIMIT = "0x1.fffffffffffffp+999"  # and claimed to be further apart than that


def mesh(size, leaves, low):
    """Leaves of `size` equal triangles, under one root. A posed coordinate is the sum of a great number and of one of 2^low."""
    count = size * leaves
    vertices = [f"0x1p+900 0x1p{low:+} {ZERO}", f"0x1.8p+900 0x1.4p{low:+} {ZERO}", f"0x1p+900 0x1.8p{low:+} 0x1p+900"]
    lines = ["ecods-mesh 1", f"vertices 3 triangles {count} nodes {leaves + 1}", *vertices]
    lines += [f"0 1 2 {at}" for at in range(count)]
    return "\n".join([*lines, f"n {leaves}", *[f"l {size}"] * leaves]) + "\n"


def certificate(text, claim, lines):
    rows = f"{ONE} {ONE} {ZERO} {{}} {ZERO} {ONE} {ONE} {ZERO} {ONE} {ZERO} {ONE} {ZERO}"
    head = ["ecods-certificate 2", f"a {digest(text)} {rows.format(ZERO)}", f"b {digest(text)} {rows.format(FAR)}"]
    return "\n".join([*head, f"claim {claim}", *lines, "end"]) + "\n"


def wide(size, leaves, axes, low):
    """Every pair of triangles looks along all axes, of which only the last one parts them as far as claimed."""
    oblique = [f"axis {ONE} 0x1.{at:02x}p-25 {ZERO}" for at in range(axes - 1)]
    names = " ".join(map(str, range(axes)))
    steps = ["ab | " + " ".join(map(str, range(leaves * leaves))), *[f"ab {names}"] * leaves**2]
    text = mesh(size, leaves, low)
    return text, certificate(text, f"beyond {LIMIT}", [*oblique, f"axis {ONE} {ZERO} {ZERO}", *steps])


def deep(size, leaves, low):
    """Every pair of triangles has a step of its own, whose vector is of the third degree."""
    pairs = " ".join(map(str, range(size * size)))
    steps = ["ab | " + " ".join(map(str, range(leaves * leaves))), *[f"ab | {pairs}", *["t vb 0 1"] * size**2] * leaves**2]
    text = mesh(size, leaves, low)
    return text, certificate(text, "disjoint", steps)


def cpp(checker, text, data):
    """The verdict, the units of work and the seconds."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / name for name in ("certificate", "mesh")]
        for path, each in zip(paths, (data, text)):
            path.write_text(each)
        said = subprocess.run([checker, "--times", *paths], capture_output=True, check=False, text=True).stdout
    seconds, units = re.search(r"  ([0-9.]+) us, \d+ steps, (\d+) units", said).groups()
    return said.split("\n")[0], int(units), float(seconds) / 1e6


def python(check, lines, reading, text, data, limit=None):
    read = reading.Mesh(text.encode())
    its_lines = lines.Lines(data.encode())
    before = its_lines.left = its_lines.left if limit is None else limit
    start = time.process_time()
    try:
        said = "accepted: " + check.check_certificate(its_lines, {read.digest: read})
    except lines.Refused as why:
        said = f"refused: {why}"
    return said, before - its_lines.left, time.process_time() - start


def judge(checker, modules):
    """What is wrong with how both checkers count, as lines."""
    bits = 2000  # of a gap: from 2^1000 down to below 2^-1000
    text, data = wide(64, 1, 64, -1000)
    said, units, _ = cpp(checker, text, data)
    if not said.startswith("accepted: ") or units < 64 * 64 * 63 * (bits // 64) ** 2:
        yield f"C++, one wide step: {said}, {units} units"
    text, data = wide(64, 5, 64, -1000)
    said, units, _ = cpp(checker, text, data)
    if not re.fullmatch(r"refused: line \d+: too costly", said):
        yield f"C++, 25 wide steps: {said}, {units} units"
    text, data = deep(16, 1, -1000)
    said, units, _ = cpp(checker, text, data)
    if not said.startswith("accepted: ") or units < 16 * 16 * 90 * (bits // 64) ** 2:
        yield f"C++, vectors of the third degree: {said}, {units} units"
    for name, (text, data), least in (
        ("one wide step", wide(16, 1, 16, -1000), 16 * 16 * 15 * (bits // 256) ** 2),
        ("vectors of the third degree", deep(8, 1, -1000), 8 * 8 * 20 * (3 * bits // 512) ** 2),
    ):
        said, units, _ = python(*modules, text, data)
        if not said.startswith("accepted: ") or units < least:
            yield f"Python, {name}: {said}, {units} units"
        said, spent, _ = python(*modules, text, data, units - 1)
        if not re.fullmatch(r"refused: line \d+: too costly", said) or spent >= units:
            yield f"Python, {name}, with a unit less: {said}, {spent} units"


def print_seconds(checker, modules):
    for name, (text, data), (small_text, small_data) in (
        ("wide", wide(64, 2, 64, -1000), wide(16, 2, 16, -1000)),
        ("wide, short numbers", wide(64, 2, 64, 900), wide(16, 2, 16, 900)),
        ("deep", deep(32, 2, -1000), deep(16, 2, -1000)),
    ):
        _, units, seconds = cpp(checker, text, data)
        _, its_units, its_seconds = python(*modules, small_text, small_data)
        print(f"{name:20} {1e9 * seconds / units:.2f} ns a unit in C++, {1e9 * its_seconds / its_units:.0f} ns in Python")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("checker")
    parser.add_argument("--python", type=Path, default=HERE / "check.py", help="another Python checker")
    parser.add_argument("--seconds", action="store_true")
    options = parser.parse_args()
    sys.path.insert(0, str(options.python.resolve().parent))
    modules = [importlib.import_module(name) for name in ("check", "lines", "reading")]
    if options.seconds:
        print_seconds(options.checker, modules)
        return 0
    wrong = list(judge(options.checker, modules))
    for line in wrong:
        print(f"--- {line}")
    print(f"hostile certificates: {len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
