"""The lists of mutants: their checks, and the faults to plant. fuzz/mutants/README.md describes their text."""
import pathlib
import re
import shlex

from . import code

ROOT = pathlib.Path(__file__).resolve().parents[3]
FOLDER = ROOT / "fuzz/mutants"


class Broken(Exception):
    """A list does not fit the sources, or cannot be run as it is asked for."""


class Check:
    def __init__(self, text):
        found = re.fullmatch(r"(?:(\S+): )?(.+?) = (\S+) ?(.*)", text)
        if not found:
            raise Broken(f"not '[FOLDER:] NAME = PROGRAM ARGUMENTS': {text}")
        self.folder, self.name, self.program = found[1] or "", found[2], found[3]
        self.args = [str(ROOT / word) if "/" in word and (ROOT / word).exists() else word
                     for word in shlex.split(found[4])]

        self.key = f"{self.folder}: {self.name}" if self.folder else self.name  # in its list no other check has it

    def is_of(self, file):
        return file.startswith(self.folder)


class Mutant:
    def __init__(self, block):
        lines = block.splitlines()
        head = lines[0].split()
        if len(head) != 2:
            raise Broken(f"not 'NAME FILE': {lines[0]}")
        self.name, self.file = head

        def text(mark, join):
            return join.join(line[2:] for line in lines[1:] if line.startswith(mark))

        self.why = " ".join(line.strip() for line in lines[1:] if line.startswith("  "))
        self.find, self.replace, self.excuse = text("- ", "\n"), text("+ ", "\n"), text("= ", " ")
        if not self.find or not self.why:
            raise Broken(f"{self.name}: no text to find, or no explanation")

    def source(self, root=ROOT):
        """The text of the file, in which the text to find occurs once."""
        if not (root / self.file).exists():
            raise Broken(f"{self.name}: there is no {self.file}")
        source = (root / self.file).read_text()
        if source.count(self.find) != 1:
            raise Broken(f"{self.name}: found {source.count(self.find)} times in {self.file}:\n{self.find}")
        return source

    def apply(self, root=ROOT):
        return self.source(root).replace(self.find, self.replace)

    def digest(self, root=ROOT):
        """Changes with the mutant and with the function, or other declaration, around it; not with comments or formatting."""
        source = self.source(root)
        begin = source.index(self.find)
        return code.digest(code.text_around(source, begin, begin + len(self.find)), self.find, self.replace)


class MutantList:
    def __init__(self, path):
        self.name = path.stem
        blocks = [b.strip("\n") for b in re.split(r"\n\s*\n", path.read_text()) if b.strip()]
        blocks = [b for b in blocks if not b.startswith("#")]
        self.checks, self.campaigns, self.only_calls = [], [], set()
        for line in blocks[0].splitlines():
            kind, _, rest = line.partition(" ")
            if kind == "check":
                self.checks.append(Check(rest))
            elif kind == "campaign":
                self.campaigns.append(Check(rest))
            elif kind == "only-calls":
                self.only_calls.update(rest.split())
            else:
                raise Broken(f"{path.name}: no directive: {line}")
        keys = [check.key for check in self.checks + self.campaigns]
        if len(set(keys)) != len(keys):
            raise Broken(f"{path.name}: two checks have one name for the same folder")
        self.mutants = [Mutant(block) for block in blocks[1:]]

    def programs(self):
        return sorted({check.program for check in self.checks + self.campaigns})

    def checks_of(self, mutant):
        return [check for check in self.checks if check.is_of(mutant.file)]


def all_lists(folder=FOLDER):
    lists = [MutantList(path) for path in sorted(folder.glob("*.list"))]
    names = [mutant.name for each in lists for mutant in each.mutants]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise Broken(f"two mutants have one name: {', '.join(twice)}")
    return lists
