"""How long both checkers take for certificates of pairs that are a small distance apart.

usage: times.py CHECKER FOLDER [--rounds N]

FOLDER is what `certificate_samples FOLDER gaps COUNT` writes: NAME.mesh and NAME.QUESTION.cert. Prints, of each file, how long the mesh
takes to be read, how long that takes with the first certificate, and the median of the others, for both checkers, in ms; each is the
least of the rounds. The Python checker is timed within this process, as the other one times itself (--times).
"""
import argparse
import re
import subprocess
import time
from pathlib import Path
from statistics import median

import check
from lines import Lines
from reading import Mesh


def of_cpp(checker, certificates, mesh):
    said = subprocess.run([checker, "--times", certificates, mesh], capture_output=True, check=True, text=True).stdout
    assert "refused" not in said, said
    reading, first, later = map(float, re.findall(r"([0-9.]+) us[ ;(]", " ".join(said.split("\n")[-3:])))
    return reading / 1e3, first / 1e3, later / 1e3


def of_python(certificates, mesh):
    times = [time.process_time()]
    read = Mesh(mesh.read_bytes())
    lines = Lines(certificates.read_bytes())
    times.append(time.process_time())
    while lines.at < len(lines.lines):
        check.check_certificate(lines, {read.digest: read})
        times.append(time.process_time())
    return [1e3 * x for x in (times[1] - times[0], times[2] - times[0], median(b - a for a, b in zip(times[2:], times[3:])))]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("checker")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    print(f"{'':22}{'C++: reading, first, later (1/N)':38}{'Python':34}Python / C++: reading, first, later")
    for certificates in sorted(options.folder.glob("*.cert")):
        mesh = options.folder / (certificates.name.split(".")[0] + ".mesh")
        rounds = [(of_cpp(options.checker, certificates, mesh), of_python(certificates, mesh)) for _ in range(options.rounds)]
        cpp, python = ([min(values) for values in zip(*each)] for each in zip(*rounds))
        numbers = " ".join(f"{x:9.3f}" for x in cpp), " ".join(f"{x:9.2f}" for x in python)
        ratios = " ".join(f"{y / x:7.1f}" for x, y in zip(cpp, python))
        print(f"{certificates.stem:22}{numbers[0]} (1/{cpp[1] / cpp[2]:.1f})   {numbers[1]}   {ratios}")


if __name__ == "__main__":
    main()
