"""The command line of check.py: reads the files, and prints the verdicts."""
import sys

from lines import Lines, Refused
from reading import Mesh, Unreadable


def run(check_certificate, names):
    """Prints a line for each certificate. Returns 0 if all are accepted, 1 if one is refused, 2 if a file is unreadable."""
    if not names:
        print("usage: check.py CERTIFICATE [MESH...]", file=sys.stderr)
        return 2
    meshes = {}
    try:
        for name in names[1:]:
            with open(name, "rb") as file:
                mesh = Mesh(file.read())
            meshes[mesh.digest] = mesh
        name = names[0]
        with open(name, "rb") as file:
            lines = Lines(file.read())
    except (OSError, Unreadable) as why:
        print(f"unreadable: {name}: {why}")
        return 2
    status, goes_on = 0, True
    while goes_on:
        first = lines.at + 1
        try:
            print(f"accepted: {check_certificate(lines, meshes)}")
            goes_on = lines.at < len(lines.lines)
        except Refused as why:
            print(f"refused: {why}")
            status, goes_on = 1, lines.skip(first)
    return status
