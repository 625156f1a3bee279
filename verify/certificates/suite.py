"""Certificates of hard answers, as the library writes them: both checkers must accept each.

usage: suite.py --folder FOLDER CHECKER
       suite.py CHECKER PROGRAM ARGUMENTS...

What is checked is in a folder: certificates (*.cert, certificates.txt) and meshes (*.mesh). A program is run to write it; of its
arguments, FOLDER stands for the folder.
"""
import argparse
import collections
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from checkers import Checkers


def check_folder(checkers, folder):
    """Verdicts of a folder, by kinds; those that are not as they should be are printed, and counted."""
    files = [*folder.glob("*.cert"), *folder.glob("certificates.txt")]
    said = checkers.run(b"".join(file.read_bytes() for file in files), sorted(folder.glob("*.mesh")))
    (cpp_code, cpp, cpp_errors), (code, python, errors) = said["C++"], said["Python"]
    wrong, kinds, cpp, python = 0, collections.Counter(), cpp.split("\n")[:-1], python.split("\n")[:-1]
    if code not in (0, 1) or cpp_code != code or len(cpp) != len(python):
        print(f"C++ {cpp_code}: {cpp[-3:]} {cpp_errors[-300:]}\nPython {code}: {python[-3:]} {errors[-300:]}")
        return 1, kinds
    for at, (one, other) in enumerate(zip(cpp, python)):
        kinds[other.split()[1] if other.startswith("accepted") else "refused"] += 1
        if one != other or not other.startswith("accepted"):
            wrong += 1
            print(f"--- certificate {at}: C++ {one}\n    Python {other}")
    return wrong, kinds


def most_work(checkers, folder):
    """The most units that the C++ checker counts for one certificate of those last checked, in parts of what a file of no bytes may take."""
    command = [*checkers.commands["C++"], "--times", checkers.path("certificates"), *sorted(folder.glob("*.mesh"))]
    said = subprocess.run(command, capture_output=True, check=False, text=True).stdout
    return max(map(int, re.findall(r", (\d+) units\n", said)), default=0) / 2**33


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("checker")
    parser.add_argument("--folder", type=Path)
    parser.add_argument("command", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as made:
        folder = options.folder or Path(made)
        if not options.folder:
            command = [str(folder) if word == "FOLDER" else word for word in options.command]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        checkers = Checkers(options.checker)
        wrong, kinds = check_folder(checkers, folder)
        work = most_work(checkers, folder)
    print(", ".join(f"{kind} {count}" for kind, count in sorted(kinds.items())))
    print(f"{sum(kinds.values())} certificates: {wrong} not accepted by both")
    print(f"the most work of one: 1/{1 / max(work, 2.0**-33):.0f} of what a file may take")
    return 1 if wrong or not kinds or work > 0.01 else 0


if __name__ == "__main__":
    sys.exit(main())
