"""Mistakes made on purpose in a checker: each must be caught by the cases made by hand, hostile certificates, false claims or tampering.

usage: mutants.py CHECKER [--list LIST]... [--every N] [--compiler CXX]

CHECKER: the C++ one, which is right. Without --list, both lists beside this file are gone through; --every 10 takes each tenth mutant.

A mutant of a list is two lines, `- TEXT` as it stands in the checker, and `+ TEXT` in its place, after a line `# WHY`, or several, and, in the
C++ checker, a line `file: NAME`. Without that line the text is in one of the Python checker's files. Its first occurrence is replaced. A line
`= WHY NOT` says why the mistake changes no verdict; such a mutant is not run.
"""
import argparse
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

HERE = Path(__file__).parent
PYTHON_FILES = ["check.py", "apart.py", "reading.py", "lines.py", "filters.py", "command_line.py"]
SECONDS_MAX = 900  # a mutant that goes on for ever is caught


@dataclass
class Mutant:
    why: list = field(default_factory=list)
    file: str = ""
    old: str = ""
    new: str = ""
    is_harmless: bool = False


def read_list(path):
    mutant = Mutant()
    for line in path.read_text().splitlines():
        kind, text = line[:2], line[2:]
        if kind == "# ":
            mutant.why.append(text)
        elif line.startswith("file: "):
            mutant.file = line.removeprefix("file: ")
        elif kind == "- ":
            mutant.old = text
        elif kind == "= ":
            mutant.is_harmless = True
        elif kind == "+ ":
            mutant.new = text
            yield mutant
            mutant = Mutant()


class Builds:
    """Copies of the checkers' sources in a folder, with one mistake at a time."""

    def __init__(self, folder, compiler):
        self.folder, self.compiler = Path(folder), compiler
        names = [*PYTHON_FILES, *(f"checker/{path.name}" for path in (HERE / "checker").glob("*.[ch]pp"))]
        self.sources = {Path(name).name: (HERE / name).read_text() for name in names}
        self.units = [name for name in self.sources if name.endswith(".cpp")]
        self.objects = set()  # of the sources as they are

    def plant(self, mutant):
        """Writes the sources with the mistake, and says in which file it is."""
        names = [mutant.file] if mutant.file else PYTHON_FILES
        name = next((name for name in names if mutant.old in self.sources[name]), None)
        if name is None:
            sys.exit(f"not in {', '.join(names)}: {mutant.old}")
        for each, source in self.sources.items():
            (self.folder / each).write_text(source.replace(mutant.old, mutant.new, 1) if each == name else source)
        (self.folder / "check.py").chmod(0o755)
        return name

    def compile(self, changed):
        """The C++ checker with a file changed."""
        is_stale = {unit for unit in self.units if changed in (unit, *(name for name in self.sources if name.endswith(".hpp")))}
        new = [unit for unit in self.units if unit in is_stale or unit not in self.objects]
        running = [subprocess.Popen([self.compiler, "-std=c++20", "-O1", "-c", unit, "-o", unit + ".o"], cwd=self.folder) for unit in new]
        failed = [unit for unit, process in zip(new, running) if process.wait() != 0]
        if failed:
            sys.exit(f"a mutant of {changed} does not compile")
        self.objects = (self.objects | set(new)) - is_stale
        program = self.folder / "checker"
        subprocess.run([self.compiler, *(unit + ".o" for unit in self.units), "-lgmpxx", "-lgmp", "-lcrypto", "-o", program], cwd=self.folder, check=True)
        return program


def catcher(checker, python, own):
    """The first suite that fails for the two checkers, of which `own` is the mutant; or None."""
    suites = [
        ["checker/cases.py", own, "0"],
        ["costly.py", checker, "--python", python],
        ["false_claims.py", checker, "--python", python, "--claims", "150"],
        ["tamper.py", checker, "--python", python, "--changes", "1500", "--sources", "60"],
    ]
    for name, *arguments in suites:
        try:
            done = subprocess.run([sys.executable, HERE / name, *arguments], capture_output=True, timeout=SECONDS_MAX, check=False)
        except subprocess.TimeoutExpired:
            return name
        if done.returncode != 0:
            return name
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("checker", type=lambda name: str(Path(name).resolve()))
    parser.add_argument("--list", type=Path, action="append")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--compiler", default=os.environ.get("CXX", "c++"))
    options = parser.parse_args()
    lists = options.list or [HERE / "mutants_cpp.txt", HERE / "mutants_python.txt"]
    mutants = [mutant for path in lists for mutant in read_list(path) if not mutant.is_harmless]
    survivors, mutants = 0, mutants[:: options.every]
    with tempfile.TemporaryDirectory() as folder:
        builds = Builds(folder, options.compiler)
        for mutant in mutants:
            name = builds.plant(mutant)
            checker, python = options.checker, builds.folder / "check.py"
            is_python = name in PYTHON_FILES
            if not is_python:
                checker = builds.compile(name)
            caught = catcher(checker, python, python if is_python else checker)
            survivors += caught is None
            print(f"{caught or 'NOT CAUGHT':18} {name:16} {' '.join(mutant.why)}", flush=True)
    print(f"{len(mutants)} mutants: {survivors} not caught")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
