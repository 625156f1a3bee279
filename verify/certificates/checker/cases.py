"""Small certificates made by hand, with the verdicts that they must get; then damaged ones, which must not crash the checker.

usage: cases.py CHECKER [DAMAGED_COUNT]      the C++ checker is asked with --exact, too
"""
import random
import subprocess
import sys
import tempfile
from pathlib import Path

from case_texts import BAD, BAD_MESHES, DIGITS, GOOD, MESHES, digest
from verdict_texts import FORGED, FORGED_MESHES, VERDICTS


class Checker:
    def __init__(self, program, folder, *options):
        self.program, self.options = program, options
        self.folder = Path(folder)
        self.mesh_files = []
        for name, text in MESHES.items():
            self.mesh_files.append(self.folder / name)
            self.mesh_files[-1].write_text(text)

    def run(self, certificate, mesh_files=None):
        path = self.folder / "certificate"
        path.write_bytes(certificate if isinstance(certificate, bytes) else certificate.encode())
        result = subprocess.run([self.program, *self.options, path, *(mesh_files or self.mesh_files)], capture_output=True, timeout=60)
        return result.returncode, result.stdout.decode(errors="replace")


def check_verdicts(checker):
    wrong = 0
    for expected, certificates in ((0, GOOD), (1, BAD)):
        for text in certificates:
            code, said = checker.run(text)
            if code != expected or said.startswith("accepted") != (expected == 0):
                wrong += 1
                print(f"--- verdict {code}, {said}{text}")
    code, said = checker.run("".join(GOOD))
    if code != 0 or said.count("accepted: ") != len(GOOD):
        wrong += 1
        print("--- not all accepted in one file")
    code, said = checker.run("".join(good + bad for good, bad in zip(GOOD, BAD) if bad.endswith("end\n")))
    if code != 1 or said.count("accepted: ") != said.count("refused: "):
        wrong += 1
        print("--- refused and accepted ones in one file", said)
    for text in BAD_MESHES:
        path = checker.folder / "bad"
        path.write_text(text)
        code, said = checker.run(GOOD[0], [*checker.mesh_files, path])
        if code != 2 or not said.startswith("unreadable: "):
            wrong += 1
            print(f"--- verdict {code}, {said}{text[:200]}")
    return wrong


def check_words(checker):
    """Verdicts, word by word; and a claim about a mesh for which another one is given, by the right file name."""
    wrong = 0
    for text, expected in VERDICTS.items():
        _, said = checker.run(text)
        if said.split("\n")[:-1] != expected:
            wrong += 1
            print(f"--- not {expected}: {said}{text}")
    paths = [checker.folder / f"{digest(DIGITS if at == 0 else text)}.mesh" for at, text in enumerate(FORGED_MESHES)]
    for path, text in zip(paths, FORGED_MESHES):
        path.write_text(text)
    for meshes in (paths, [*paths, checker.mesh_files[list(MESHES).index("digits")]]):
        code, said = checker.run(FORGED, meshes)
        if code != 1 or not said.startswith("refused: "):
            wrong += 1
            print(f"--- with a forged mesh {code}, {said}")
    return wrong


def damage(text, source):
    """The bytes with one or two changes: a byte, a range taken out or doubled, another line, another number."""
    data = bytearray(text.encode())
    for _ in range(source.randint(1, 2)):
        at = source.randrange(len(data) + 1)
        end = min(len(data), at + source.choice((1, 1, 2, 8, 64)))
        kind = source.randrange(5)
        if kind == 0:
            data[at:end] = b""
        elif kind == 1:
            data[at:at] = data[at:end]
        elif kind == 2:
            data[at:at + 1] = bytes([source.randrange(256)])
        elif kind == 3:
            data[at:at + 1] = source.choice((b"4294967295", b"99999999999", b" ", b"\n", b"-", b"0", b"1", b"7", b"p+1023"))
        else:
            lines = bytes(data).split(b"\n")
            lines[source.randrange(len(lines))] = source.choice(lines)
            data = bytearray(b"\n".join(lines))
    return bytes(data)


def check_damaged(checker, count):
    """Damaged files end with a verdict: many certificates in one file, or a damaged mesh."""
    source = random.Random(18)
    wrong = 0
    for done in range(count):
        if done % 2 == 0:
            data = b"".join(damage(source.choice(GOOD), source) for _ in range(40))
            code, said = checker.run(data)
        else:
            path = checker.folder / "damaged"
            path.write_bytes(damage(source.choice(list(MESHES.values())), source))
            code, said = checker.run(GOOD[0], [*checker.mesh_files, path])
        if code not in (0, 1, 2):
            wrong += 1
            print(f"--- ended with {code} at damage {done}: {said[-300:]}")
    return wrong


def main():
    with tempfile.TemporaryDirectory() as folder:
        checker = Checker(sys.argv[1], folder)
        wrong = check_verdicts(checker) + check_words(checker)
        if not sys.argv[1].endswith(".py"):
            wrong += check_verdicts(Checker(sys.argv[1], folder, "--exact"))
        wrong += check_damaged(checker, int(sys.argv[2]) if len(sys.argv) > 2 else 200)
    print(f"{len(GOOD)} to accept, {len(BAD)} to refuse, {len(BAD_MESHES)} meshes to refuse: {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
