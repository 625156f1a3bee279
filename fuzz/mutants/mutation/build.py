"""The build folder, and programs that are linked with a mutant."""
import concurrent.futures
import fcntl
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading

from . import checks
from .lists import ROOT, Broken

MUTABLE = ("src/", "verify/scenes/", "verify/programs/clash/")  # their objects are in libraries, which a link does not name
# A file with a mutant is compiled by itself, without a header that was compiled before.
EACH_ALONE = {"ECODS_UNITY": "OFF", "CMAKE_DISABLE_PRECOMPILE_HEADERS": "ON"}


class DoesNotCompile(Exception):
    def __init__(self, errors):
        super().__init__(errors)
        self.is_static_assert = "static assertion failed" in errors or "static_assert failed" in errors


def prepare(folder, root=ROOT):
    """The build folder: the one that is named, or that of the preset."""
    if folder is None:
        folder = root / "build/mutants"
        if not (folder / "build.ninja").exists():
            subprocess.run(["cmake", "--preset", "mutants"], cwd=root, check=True, stdout=subprocess.DEVNULL)
    if not (folder / "build.ninja").exists():
        raise Broken(f"{folder} is not configured: cmake --preset mutants")
    cache = dict(re.findall(r"^(\w+):\w+=(.*)$", (folder / "CMakeCache.txt").read_text(), re.MULTILINE))
    if any(cache.get(name) != value for name, value in EACH_ALONE.items()):
        raise Broken(f"{folder} does not compile every file on its own: {EACH_ALONE} is expected")
    (folder / "mutants").mkdir(exist_ok=True)
    return folder.resolve()


class Build:
    """Programs without a mutant, and what it takes to link them with one. At most `jobs` processes run at a time."""

    def __init__(self, folder, programs, only_calls=(), jobs=1, root=ROOT):
        self.folder, self.only_calls, self.jobs, self.root = folder, only_calls, jobs, root
        self.slots = threading.BoundedSemaphore(jobs)
        self.compilers = concurrent.futures.ThreadPoolExecutor(jobs)
        with open(folder / "mutants/lock", "w") as lock:  # other ranks may use the folder
            fcntl.flock(lock, fcntl.LOCK_EX)
            subprocess.run(["ninja", "-C", folder, f"-j{jobs}", *programs], check=True,
                           stdout=sys.stderr if sys.stderr.isatty() else subprocess.DEVNULL)
            self.compile = {}
            for entry in json.loads((folder / "compile_commands.json").read_text()):
                args = shlex.split(entry["command"])
                source = os.path.relpath(os.path.realpath(entry["file"]), root)
                self.compile[args[args.index("-o") + 1]] = (source, entry["file"], args)
            self.links = {program: self.link_of(program) for program in programs}
            self.deps = {}
            for block in self.ninja("-t", "deps").split("\n\n"):
                head, *files = block.strip().splitlines() or [""]
                self.deps[head.split(":")[0]] = {os.path.realpath(folder / f.strip()) for f in files}
        self.objects = {program: self.objects_of(program) for program in programs}
        self.seconds = {}

    def ninja(self, *args):
        return subprocess.run(["ninja", "-C", self.folder, "--quiet", *args], check=True, text=True,
                              stdout=subprocess.PIPE).stdout

    def link_of(self, program):
        last = self.ninja("-t", "commands", program).splitlines()[-1]
        return shlex.split(last.split("&&")[1])

    def objects_of(self, program):
        """Those that are linked: named by the link, or taken from the project's libraries."""
        link = self.links[program]
        with tempfile.TemporaryDirectory() as unused:
            args = [*link, f"-Wl,-Map={unused}/map"]
            args[args.index("-o") + 1] = f"{unused}/program"
            subprocess.run(args, cwd=self.folder, check=True)
            with open(f"{unused}/map", encoding="utf-8") as lines:
                members = {found[1] for found in (re.search(r"\.a\(([^()\s/]+\.o)\)", line) for line in lines) if found}
        return [o for o, (source, _, _) in self.compile.items() if source not in self.only_calls and
                (o in link or (source.startswith(MUTABLE) and pathlib.Path(o).name in members))]

    def reads(self, program, file):
        """The objects of a program that a mutant of the file changes."""
        changed = os.path.realpath(self.root / file)
        return [o for o in self.objects[program] if changed in self.deps.get(o, ())]

    def check_without_mutant(self, each):
        """A check that fails without a mutant would be named as the one that catches them all."""
        if (each.program, *each.args) in self.seconds:
            return
        link = self.links[each.program]
        program = self.folder / link[link.index("-o") + 1]
        with self.slots:
            outcome = checks.run(program, each.args, self.folder / "mutants")
        if not outcome.passed:
            raise Broken(f"without any mutant, {each.name} ({each.program}) fails:\n"
                         f"{(outcome.out + outcome.errors)[-2000:]}")
        self.seconds[(each.program, *each.args)] = outcome.seconds


class Planting:
    """A mutant in a copy of the sources. Only the objects of a program that is asked for are compiled."""

    def __init__(self, build, work, file, text):
        self.build, self.work, self.file = build, work, file
        self.overlay = work / "tree"
        shutil.rmtree(work, ignore_errors=True)
        for top in sorted({"src", file.split("/")[0]}):
            shutil.copytree(build.root / top, self.overlay / top)
        (self.overlay / file).write_text(text)
        self.again, self.linked = {}, {}

    def compile_again(self, number, obj):
        source, file, args = self.build.compile[obj]
        out = str(self.work / f"{number}.o")
        args = [out if a == obj else a for a in args]
        is_copy = source.startswith("src/") or source == self.file
        args = [str(self.overlay / source) if a == file and is_copy else a for a in args]
        args = [a for a in args if not re.fullmatch("-O.|-Werror", a)] + ["-O1", "-w"]
        place = args.index("-o")  # before that, a compiler launcher and the compiler
        folders = [f"{self.overlay}/src", f"{self.overlay}/verify", str(self.overlay)]  # from which paths of includes begin
        args[place:place] = [a for folder in folders for a in ("-iquote", folder, f"-I{folder}")]
        with self.build.slots:
            return obj, out, subprocess.run(args, cwd=self.build.folder, text=True, capture_output=True, errors="replace")

    def compile(self, objects):
        # Objects of one planting are compiled by one thread; their numbers do not repeat.
        jobs = [self.build.compilers.submit(self.compile_again, len(self.again) + i, o) for i, o in enumerate(objects)]
        try:
            for job in concurrent.futures.as_completed(jobs):
                obj, out, done = job.result()
                if done.returncode != 0:
                    raise DoesNotCompile(done.stderr)
                self.again[obj] = out
        finally:
            for job in jobs:
                job.cancel()
            concurrent.futures.wait(jobs)  # nothing is written into the folder once another mutant has it

    def reads(self, program):
        return bool(self.build.reads(program, self.file))

    def program(self, name):
        """The program, linked with the mutant."""
        if name not in self.linked:
            objects = self.build.reads(name, self.file)
            self.compile([o for o in objects if o not in self.again])
            # An object given by name comes before the library's, which is then not looked at.
            of_library = [self.again[o] for o in objects if self.build.compile[o][0].startswith(MUTABLE)]
            args = [self.again.get(a, a) for a in self.build.links[name]]
            output = args.index("-o")
            args[output + 1] = str(self.work / name)
            args[output + 2:output + 2] = of_library
            with self.build.slots:
                done = subprocess.run(args, cwd=self.build.folder, text=True, capture_output=True, errors="replace")
            if done.returncode != 0:  # a function whose name or result was changed
                raise DoesNotCompile(done.stderr)
            self.linked[name] = self.work / name
        return self.linked[name]

    def run(self, check):
        program = self.program(check.program)
        seconds = self.build.seconds.get((check.program, *check.args), checks.SECONDS_MAX)
        with self.build.slots:
            return checks.run(program, check.args, self.work, checks.SLOWER_MAX * seconds + checks.SECONDS_MORE)
