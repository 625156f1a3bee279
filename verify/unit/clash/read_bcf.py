"""Reads BCF 2.1 files and pictures of ecods_clash back with Python's own readers.

usage: read_bcf.py ECODS_CLASH ECODS_CLASH_BUILDING SCHEMA_FOLDER

Every document is held to the schemas by xmllint, where that is installed; topics must be the clashes of the JSON. In
each picture, of the parts' two colors and that of contact there must be something.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
import zipfile

from clash_program import run
from png import read_png, share
from read_formats import split_into_files

TETRAHEDRON = "o %s\nv %s 0 0\nv %s 0 0\nv %s 2 0\nv %s 0 2\nf -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n"
NAMES = ["<a & \"b\"> ]]> \u00e9", "\x01\ufffe 'x'", "0N1Bb_$zzzzzzzzzzzzzzz", "IfcColumn_Stuetze-1_1FnVzZtET9CQDoxryuX4cb",
         "Column_1FnVzZtET9CQDoxryuX4cc"]


def write_names(folder):
    """Parts that overlap, with names that XML must escape or cannot have, one that is an IFC GUID, and two that end with one, of which only
    that of an IFC class is taken for one."""
    path = os.path.join(folder, "names.obj")
    with open(path, "wb") as file:
        for i, name in enumerate(NAMES):
            file.write((TETRAHEDRON % (name, i * 0.5, i * 0.5 + 2, i * 0.5, i * 0.5)).encode())
        file.write(b"o \xff\xc3\n" + "".join(TETRAHEDRON.splitlines(True)[1:]).encode() % (b"9", b"11", b"9", b"9"))
        file.write(b"o bytes\n" + "".join(TETRAHEDRON.splitlines(True)[1:]).encode() % (b"10", b"12", b"10", b"10"))
    return path


def validate(schemas, kind, documents, folder):
    if shutil.which("xmllint") is None:
        print("xmllint is not installed: documents are not held to the schemas")
        return
    paths = []
    for i, document in enumerate(documents):
        paths.append(os.path.join(folder, "%s%d.xml" % (kind, i)))
        with open(paths[-1], "wb") as file:
            file.write(document)
    done = subprocess.run(["xmllint", "--noout", "--nonet", "--schema", os.path.join(schemas, kind + ".xsd")] + paths,
                          stderr=subprocess.PIPE)
    assert done.returncode == 0, [line for line in done.stderr.decode().splitlines() if "validates" not in line][:5]


def make(program, source, folder, *options):
    bcf, text = os.path.join(folder, "report.bcf"), os.path.join(folder, "report.json")
    run(program, source, "--quiet", "--bcf", bcf, "--json", text, *options)
    with open(bcf, "rb") as file, open(text) as report:
        return file.read(), json.load(report)


def check_picture(data, clash):
    width, height, rows = read_png(data)
    assert (width, height) == (480, 320)
    shares = {
        "blue": share(rows, lambda r, g, b: b > 1.5 * r and b > 90),
        "amber": share(rows, lambda r, g, b: r > g > 1.25 * b and r > 90),
        "contact": share(rows, lambda r, g, b: r > 70 and r > 1.5 * g and b < 0.9 * r),
    }
    # A part may be almost hidden, and a contact be a point; but something of each is seen. What is wholly in the other
    # part is itself the contact.
    if clash["relation"] in ("inside", "equal"):
        del shares["blue"]
    if clash["relation"] in ("contains", "equal"):
        del shares["amber"]
    for name, value in shares.items():
        assert value > (0.0003 if name == "contact" else 0.002), (clash["kind"], clash["a"], clash["b"], shares)


def check_camera(root, clash):
    """The middle of the place must come into the middle half of what the camera sees, and be in front of it."""
    point = lambda name: [float(root.find("OrthogonalCamera/" + name + "/" + axis).text) for axis in "XYZ"]
    eye, forward, up = point("CameraViewPoint"), point("CameraDirection"), point("CameraUpVector")
    height = float(root.find("OrthogonalCamera/ViewToWorldScale").text)
    dot = lambda p, q: sum(x * y for x, y in zip(p, q))
    assert abs(dot(forward, forward) - 1) < 1e-12 and abs(dot(up, up) - 1) < 1e-12 and abs(dot(forward, up)) < 1e-12
    arm = [(low + high) / 2 - at for low, high, at in zip(clash["box"][0], clash["box"][1], eye)]
    assert dot(arm, forward) > 0, clash
    assert abs(dot(arm, up)) <= height / 2, (clash, dot(arm, up), height)
    assert dot(arm, arm) - dot(arm, forward) ** 2 <= height ** 2, clash


def check_bcf(data, report, schemas, folder, picture_count):
    path = os.path.join(folder, "read.bcf")
    with open(path, "wb") as file:
        file.write(data)
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        entries = {entry.filename: archive.read(entry) for entry in archive.infolist()}
        assert len(entries) == len(archive.infolist()) == 1 + 2 * len(report["clashes"]) + picture_count
        assert archive.infolist()[0].filename == "bcf.version"
        assert all(entry.date_time == (1980, 1, 1, 0, 0, 0) for entry in archive.infolist())
    validate(schemas, "version", [entries["bcf.version"]], folder)
    markups = {name: text for name, text in entries.items() if name.endswith("/markup.bcf")}
    views = {name: text for name, text in entries.items() if name.endswith("/viewpoint.bcfv")}
    validate(schemas, "markup", markups.values(), folder)
    validate(schemas, "visinfo", views.values(), folder)
    found = {}
    for name, text in markups.items():
        topic = ElementTree.fromstring(text).find("Topic")
        assert topic.get("Guid") == name.split("/")[0]
        found[int(topic.find("Index").text)] = (name.split("/")[0], topic.find("Title").text)
    assert sorted(found) == list(range(len(report["clashes"])))
    for index, clash in enumerate(report["clashes"]):
        folder_name, title = found[index]
        title_wanted = "%s: %s | %s" % (clash["kind"], clash["a"], clash["b"])
        assert title == title_wanted.replace("\ufffe", "\ufffd"), (title, title_wanted)
        view = ElementTree.fromstring(entries[folder_name + "/viewpoint.bcfv"])
        parts = [each.text for each in view.findall("Components/Selection/Component/AuthoringToolId")]
        assert parts == [clash[key].replace("\ufffe", "\ufffd") for key in "ab"], parts
        check_camera(view, clash)
        assert (folder_name + "/snapshot.png" in entries) == (index < picture_count)
        # Python takes long for a picture: the first of each kind, and some others.
        if index < picture_count and (index % 5 == 0 or clash["kind"] != report["clashes"][index - 1]["kind"]):
            check_picture(entries[folder_name + "/snapshot.png"], clash)
    return entries


def check_orders(program, source, folder):
    """Other orders of files and numbers of jobs give the same page and the same BCF."""
    with open(source, "rb") as file:
        paths = split_into_files(file.read(), folder)
    outputs = []
    for order, jobs in [(paths, "1"), (paths[::-1], "2"), (paths[1:] + paths[:1], "3")]:
        names = [os.path.join(folder, name) for name in ("orders.html", "orders.bcf")]
        run(program, *order, "--quiet", "--jobs", jobs, "--pictures", "4", "--html", names[0], "--bcf", names[1])
        outputs.append([open(name, "rb").read() for name in names])
    assert outputs[1:] == outputs[:1] * 2, "the same input gives other bytes"


def main():
    program, building, schemas = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "building.obj")
        with open(source, "wb") as file:
            file.write(run(building, "1", "1", "1"))
        options = ["--touching", "--clearance", "0.01"]
        data, report = make(program, source, folder, "--jobs", "1", "--pictures", "99", *options)
        count = len(report["clashes"])
        assert count >= 30
        check_bcf(data, report, schemas, folder, count)
        assert make(program, source, folder, "--jobs", "3", "--pictures", "99", *options)[0] == data
        check_orders(program, source, folder)
        few, _ = make(program, source, folder, "--pictures", "2", "--lines", "5", *options)
        check_bcf(few, report, schemas, folder, 2)

        data, report = make(program, write_names(folder), folder, "--date", "2026-02-03T04:05:06+07:00")
        entries = check_bcf(data, report, schemas, folder, 0)
        text = b"".join(entries.values())
        guids = {part.split(b'"')[0].decode() for part in text.split(b'IfcGuid="')[1:]}
        assert guids == {NAMES[2], NAMES[3][-22:]}, guids
        assert b"<CreationDate>2026-02-03T04:05:06+07:00</CreationDate>" in text
    print("%d topics with pictures" % count)


if __name__ == "__main__":
    main()
