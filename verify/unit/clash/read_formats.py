"""Reads the formats of ecods_clash back with Python's own readers.

usage: read_formats.py ECODS_CLASH ECODS_CLASH_BUILDING

JSON, CSV and the table must say the same; what cannot be written to its end must not be left; and other orders of files, other numbers of jobs and a second run must give
the same bytes.
"""

import csv
import json
import os
import re
import resource
import subprocess
import sys
import tempfile

KINDS = ["equal", "inside", "overlapping", "crossing", "touching", "clearance"]


def run(*arguments):
    return subprocess.run(arguments, check=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE).stdout


def split_into_files(obj, folder):
    """Writes each third object to a file of its own, so that there are three files."""
    vertices, files = 0, ["", "", ""]
    firsts, counts = [0, 0, 0], [0, 0, 0]
    index, own = -1, 0
    for line in obj.decode().splitlines():
        words = line.split()
        if words[0] == "o":
            index = (index + 1) % 3
            own = vertices
            firsts[index] = counts[index]
        if words[0] == "v":
            vertices += 1
            counts[index] += 1
        if words[0] == "f":
            line = "f " + " ".join(str(int(word) - own + firsts[index]) for word in words[1:])
        files[index] += line + "\n"
    paths = []
    for i, text in enumerate(files):
        paths.append(os.path.join(folder, "part%d.obj" % i))
        with open(paths[-1], "w") as file:
            file.write(text)
    return paths


def check_formats(program, paths, folder):
    outputs = []
    for number, (order, jobs) in enumerate([(paths, 1), (paths[::-1], 2), (paths[1:] + paths[:1] + paths[:1], 3)]):
        names = [os.path.join(folder, "%d.%s" % (number, end)) for end in ("json", "csv")]
        table = run(program, *order, "--jobs", str(jobs), "--touching", "--clearance", "0.001", "--lines", "10",
                    "--json", names[0], "--csv", names[1])
        outputs.append([table] + [open(name, "rb").read() for name in names])
    assert all(output == outputs[0] for output in outputs), "the same input gives other bytes"
    return outputs[0]


def check_halves(program, paths, folder):
    """Of a file that is cut off, as on a full disk, nothing is left, and the error names it."""
    for option in ("--json", "--csv", "--html", "--bcf"):
        file = os.path.join(folder, "half" + option)
        # Python ignores the signal of a file that grows too large, so that its child has an error instead.
        done = subprocess.run([program, *paths, "--touching", "--quiet", option, file], stderr=subprocess.PIPE,
                              restore_signals=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)))
        if b"was built without" in done.stderr:
            continue
        assert done.returncode == 2, (option, done)
        assert (file + ": cannot be written").encode() in done.stderr, done.stderr
        assert not os.path.exists(file), option


def check_clash(clash, row, names):
    for key in ("kind", "relation", "a", "b"):
        assert clash[key] == row[key], (clash, row)
    assert clash["a"] in names and clash["b"] in names and clash["a"] < clash["b"]
    assert row["file_a"] == names[clash["a"]]["file"] and row["file_b"] == names[clash["b"]]["file"]
    assert (row["distance"] == "") == (clash["distance"] is None) == (clash["kind"] != "clearance")
    if clash["distance"] is not None:
        assert float(row["distance"]) == clash["distance"] <= 0.001
        assert len(clash["points"]) == 2
    assert (row["depth_lower"] == "") == (clash["depth"] is None)
    if clash["depth"] is not None:
        assert float(row["depth_lower"]) == clash["depth"]["lower"] <= clash["depth"]["upper"]
        assert float(row["depth_upper"]) == clash["depth"]["upper"]
    corners = [float(row[end + "_" + axis]) for end in ("min", "max") for axis in "xyz"]
    assert corners == clash["box"][0] + clash["box"][1], (corners, clash["box"])
    assert len(clash["lines"]) == min(10, clash["line_count"])
    for line in clash["lines"]:
        assert line[0] < line[1]
        for end in line:
            assert all(clash["box"][0][i] <= end[i] <= clash["box"][1][i] for i in range(3)), clash
    assert clash["lines"] == sorted(clash["lines"])


def main():
    program, building = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        paths = split_into_files(run(building, "2", "2", "2"), folder)
        table, text, rows = check_formats(program, paths, folder)
        check_halves(program, paths, folder)
    report = json.loads(text)
    rows = list(csv.DictReader(rows.decode().splitlines()))
    names = {part["name"]: part for part in report["parts"]}
    assert len(names) == len(report["parts"]) == 200
    assert list(names) == sorted(names)
    assert report["format"] == "ecods_clash 1"
    assert [option["name"] for option in report["options"]] == ["clearance", "touching", "lines"]
    assert len(rows) == len(report["clashes"]) > 100
    order = [(KINDS.index(clash["kind"]), clash["a"], clash["b"]) for clash in report["clashes"]]
    assert order == sorted(set(order))
    for clash, row in zip(report["clashes"], rows):
        check_clash(clash, row, names)
    for kind in KINDS:
        assert report["counts"][kind] == sum(clash["kind"] == kind for clash in report["clashes"]) > 0
        assert re.search(r"\b%d %s\b" % (report["counts"][kind], kind), table.decode().splitlines()[-1]), kind
    assert len(table.decode().splitlines()) == 1 + len(rows) + 32 + 1  # four parts a bay are no solids
    for part in report["parts"]:
        assert part["is_solid"] == ("not_solid_because" not in part)
    print("%d clashes: JSON, CSV and table agree" % len(rows))


if __name__ == "__main__":
    main()
