"""The command line of check.py: reads the files, and prints the verdicts."""
import contextlib
import os
import sys

from lines import Lines, Refused
from reading import Mesh, Unreadable


def run(check_certificate, names):
    """Prints a line for each certificate. Returns 0 if all are accepted, 1 if one is refused, 2 if a file is unreadable or the output cannot
    be written."""
    try:
        status = print_verdicts(check_certificate, names)
        if sys.stdout is None:  # it was closed, and print() did nothing
            raise OSError
        sys.stdout.flush()
        return status
    except OSError:
        if sys.stdout is not None:  # the interpreter flushes it once more
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        with contextlib.suppress(OSError):
            os.write(2, b"check.py: standard output: cannot be written\n")
        return 2


def print_verdicts(check_certificate, names):
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
