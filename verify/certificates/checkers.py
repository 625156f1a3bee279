"""Runs both checkers on many certificates at once, and says which verdict belongs to which."""
import hashlib
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
MARKER_MESH = "ecods-mesh 1\nvertices 1 triangles 1 nodes 1\n0x1p+0 0x1p+0 0x1p+0\n0 0 0 0\nl 1\n"
IDENTITY = "0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0"
HEADERS = ("ecods-certificate 2", "ecods-world-certificate 2")
TIME_MAX = 600


def digest(text):
    return hashlib.sha256(text if isinstance(text, bytes) else text.encode()).hexdigest()


def marker(number):
    """A certificate that is accepted, by words that name it."""
    body = f"{digest(MARKER_MESH)} {IDENTITY}"
    return f"ecods-certificate 2\na {body}\nb {body}\nclaim within 0x1.{number:013x}p+9 v 0 0 v 0 0\nend\n"


def marked(line):
    """The number of a marker's verdict, or None."""
    words = line.split()
    is_marker = words[:2] == ["accepted:", "within"] and words[2].endswith("p+9") and words[3:] == ["v", "0", "0", "v", "0", "0"]
    return int(words[2][4:-3], 16) if is_marker else None


class Checkers:
    """Both checkers, with a folder of their own for files."""

    def __init__(self, cpp, python=HERE / "check.py"):
        self.commands = {"C++": [str(cpp)], "Python": [sys.executable, str(python)]}
        self.folder = tempfile.TemporaryDirectory()

    def path(self, name):
        return Path(self.folder.name) / name

    def run(self, data, mesh_paths, timeout=TIME_MAX):
        """What each checker prints about a file of certificates, and its exit code."""
        self.path("certificates").write_bytes(data if isinstance(data, bytes) else data.encode())
        said = {}
        for name, command in self.commands.items():
            done = subprocess.run([*command, self.path("certificates"), *mesh_paths], capture_output=True, timeout=timeout, check=False)
            said[name] = done.returncode, done.stdout.decode("latin-1"), done.stderr.decode("latin-1")
        return said

    def verdicts(self, texts, meshes):
        """For each text the two lists of verdicts, without words: accepted claims, and "refused"."""
        paths = []
        for number, mesh in enumerate({MARKER_MESH, *meshes}):
            paths.append(self.path(f"mesh{number}"))
            paths[-1].write_bytes(mesh if isinstance(mesh, bytes) else mesh.encode())
        blocks = [text + ("" if text.endswith("\n") or not text else "\n") + marker(at) for at, text in enumerate(texts)]
        found = {name: self.split(len(texts), *said) for name, said in self.run("".join(blocks), paths).items()}
        return [tuple(found[name][at] for name in self.commands) for at in range(len(texts))]

    @staticmethod
    def split(count, code, out, errors):
        if code not in (0, 1):
            raise AssertionError(f"a checker ended with {code}: {out[-500:]} {errors[-500:]}")
        found, current = [], []
        for line in out.split("\n")[:-1]:
            number = marked(line)
            if number is None:
                current.append(line if line.startswith("accepted: ") else "refused")
            else:
                assert number == len(found), f"verdicts are out of step at {number}"
                found.append(current)
                current = []
        assert len(found) == count and not current, f"{len(found)} verdicts of {count}, and {current}"
        return found


def is_accepted(verdicts):
    return len(verdicts) == 1 and verdicts[0].startswith("accepted")
