"""Malformed and huge files: both checkers must end with an error, and the same one of 0, 1, 2, soon and without a crash.

usage: malformed.py CHECKER [--files N] [--seed S]
"""
import argparse
import random
import subprocess
import sys

import small_certificates
from checkers import IDENTITY, MARKER_MESH, Checkers, digest

TIME_MAX = 20  # seconds, on a busy machine; quiet, each takes well below one


def damaged(random_, data):
    """Bytes changed, cut off at the end, taken out or put in."""
    data, kind = bytearray(data), random_.randrange(5)
    at = random_.randrange(len(data))
    if kind == 0:
        data = data[:at]
    elif kind == 1:
        data[at] = random_.randrange(256)
    elif kind == 2:
        del data[at : at + random_.randrange(1, 20)]
    elif kind == 3:
        data[at:at] = random_.choice([b" ", b"\n", b"\r", b"\0", b"9" * 30, b"0x1p+99999", b"nan", b"inf", b"-", b"0", b"\xb2", b"\xff\xfe"])
    else:
        data = bytearray(random_.randbytes(at))
    return bytes(data)


def mesh(vertices, triangles, nodes, counts=None):
    head = counts or (len(vertices), len(triangles), len(nodes))
    lines = ["ecods-mesh 1", "vertices {} triangles {} nodes {}".format(*head), *vertices, *triangles, *nodes]
    return ("\n".join(lines) + "\n").encode()


ORIGIN = "0x0p+0 0x0p+0 0x0p+0"


def huge_meshes():
    """Meshes with counts that nothing stands behind, deep trees, long numbers, and their neighbours that are well."""
    for counts in ((2**32 - 1, 1, 1), (1, 2**32 - 1, 1), (1, 1, 2**32 - 1), (10**18, 1, 1), (2**64, 2**64, 2**64), (0, 1, 1), (1, 0, 0)):
        yield mesh([ORIGIN], ["0 0 0 0"], ["l 1"], counts)
    for depth in (200, 201, 100_000):
        yield mesh([ORIGIN], ["0 0 0 0"], ["n 1"] * depth + ["l 1"])
    for size in (64, 65, 2**31, 2**32, 2**64, 0):
        yield mesh([ORIGIN], [f"0 0 0 {at}" for at in range(64)], [f"l {size}"])
        yield mesh([ORIGIN], ["0 0 0 0"], [f"n {size}", "l 1"])
    for word in ("0x1p+1023", "0x1.8p+1024", "0x1p-1074", "0x1p-1075", "0x0.8p-1073", "0x1.8p-1074", "0x1p+9999", "0x1p-9999", "0x0p-9999", "0x1p+99999"):
        yield mesh([f"{word} -{word} 0x0p+0"], ["0 0 0 0"], ["l 1"])
    for word in ("0X1p+0", "0x1P+0", "+0x1p+0", "1.0", "inf", "nan", "0x1", "0x1.p+0", "0x2p+0", "0x1.ABp+0", "0x1.00000000000000p+0", "-0x0p+0"):
        yield mesh([f"{word} 0x0p+0 0x0p+0"], ["0 0 0 0"], ["l 1"])
    for row in ("0 0 0 1", "0 0 1 0", "0 0 0", "00 0 0 0", "+0 0 0 0", "0 0 0 0 0", "0  0 0 0", "4294967296 0 0 0", "9" * 10000 + " 0 0 0", "1_0 0 0 0", "\xb2 0 0 0"):
        yield mesh([ORIGIN], [row], ["l 1"])
    for node in ("m 1", "l", "l 1 1", "l  1", " l 1", "n 1", "l 01", "l 2", "nl 1", "l\t1"):
        yield mesh([ORIGIN], ["0 0 0 0"], [node])
    whole = mesh([ORIGIN], ["0 0 0 0"], ["l 1"])
    yield from (whole, whole[:-1], whole + b"\n", whole + b"l 1\n", whole.replace(b"\n", b"\r\n"), b"", b"\n", whole[:13], b"\0" * 10_000_000)


def huge_certificates():
    """Certificates of the marker's mesh that are long, wide, or name what is not there."""
    body = f"{digest(MARKER_MESH)} {IDENTITY}"
    head = f"ecods-certificate 2\na {body}\nb {body}\n"
    many = " ".join(map(str, range(200_000)))
    for steps in (f"ab {many}", f"ab | {many}", "a | 0\n" * 200_000, "axis 0x1p+0 0x0p+0 0x0p+0\n" * 100_000, "k 4294967295", f"k {'9' * 100_000}", "x" * 10_000_000, " " * 1_000_000, "ab | 0\n" * 3, "axis na 4294967295"):
        yield f"{head}claim disjoint\n{steps}\nend\n".encode()
    for claim in ("distance inf", "beyond inf", "within inf 0 0", "distance -0x0p+0 0 0", "distance nan 0 0", "within 0x0p+0 0 1", "touching 0", "crossing 0 0 0", "hit 0x0p+0 0", "miss", "", "claim"):
        yield f"{head}claim {claim}\nend\n".encode()
    world = "ecods-world-certificate 2\nclearance none\n"
    for lines in ("body 0.0 " * 100_000, f"body 4294967296.0 {body}", "end world", "off 1.0 1.1\nend world", "clearance none\nend world", "pair 1.0 1.1", "body"):
        yield f"{world}{lines}\n".encode()
    digest_, pose = body.split(" ", 1)
    bodies = "".join(f"body {at}.0 {digest_} 1 2 {pose}\n" for at in range(1, 401))
    yield f"{world}{bodies}end world\n".encode()  # all at one place, and none may meet
    yield f"{world}{bodies.replace(' 1 2 ', ' 1 1 ')}end world\n".encode()
    yield from (b"", b"\n", b"ecods-certificate 2", b"ecods-certificate 2\n", b"ecods-certificate 1\n", b"ecods-certificate 2\n" * 1000, b"ecods-world-certificate 1\n" * 1000)


def costly_world():
    """So many bodies at one place that the Python checker, which looks at all pairs, refuses to."""
    bodies = "".join(f"body {at}.0 {digest(MARKER_MESH)} 1 1 {IDENTITY}\n" for at in range(1, 16_501))
    return f"ecods-world-certificate 2\nclearance none\n{bodies}end world\n".encode()


def disagreement(checkers, data, meshes):
    """What is wrong with how the checkers end, if anything."""
    paths = []
    for number, each in enumerate(meshes):
        paths.append(checkers.path(f"mesh{number}"))
        paths[-1].write_bytes(each)
    try:
        said = checkers.run(data, paths, TIME_MAX)
    except subprocess.TimeoutExpired as slow:
        return f"no end within {TIME_MAX} s: {slow.cmd[:2]}"
    codes = {code for code, _, _ in said.values()}
    lines = [[line.split(":")[0] for line in out.split("\n")[:-1]] for _, out, _ in said.values()]
    if len(codes) > 1 or not codes <= {0, 1, 2} or lines[0] != lines[1] or any(errors for *_, errors in said.values()):
        return str({name: (code, out[-300:], errors[-300:]) for name, (code, out, errors) in said.items()})
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("checker")
    parser.add_argument("--files", type=int, default=100)
    parser.add_argument("--seed", type=int, default=18)
    options = parser.parse_args()
    random_, checkers = random.Random(options.seed), Checkers(options.checker)
    valid = f"ecods-certificate 2\na {digest(MARKER_MESH)} {IDENTITY}\nb {digest(MARKER_MESH)} {IDENTITY}\nclaim within 0x0p+0 0 0\nend\n"
    marker_mesh, tasks = MARKER_MESH.encode(), []
    tasks += [(valid.encode(), [marker_mesh, each]) for each in huge_meshes()]
    tasks += [(each, [marker_mesh]) for each in huge_certificates()]
    for number in range(options.files):
        meshes, text = small_certificates.random_certificate(random_)
        data, *files = [text.encode(), *(each.encode() for each in meshes)]
        if number % 3 == 0:
            files[0] = damaged(random_, files[0])
        else:
            data = b"".join(damaged(random_, data) for _ in range(20))
        tasks.append((data, files))
    wrong = 0
    for at, (data, meshes) in enumerate(tasks):
        why = disagreement(checkers, data, meshes)
        if why:
            wrong += 1
            print(f"--- {at}: {why}\n{data[:2000]!r}\n{[each[:1000] for each in meshes]}", flush=True)
    checkers.path("mesh0").write_bytes(marker_mesh)
    said = checkers.run(costly_world(), [checkers.path("mesh0")])
    if said["Python"][:2] != (1, "refused: line 16503: too costly\n") or said["C++"][0] != 1:
        wrong += 1
        print(f"--- a costly world: {said}")
    print(f"{len(tasks) + 1} files, most of them malformed: {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
