"""Mutants that are drawn by rule, from the code of src, in proportion to the lines of its folders."""
import bisect
import hashlib
import re
from collections import defaultdict
from dataclasses import dataclass

from . import code, rules
from .lists import FOLDER, ROOT, Broken, Check

NOT_DRAWN = ("src/python/",)  # the module is not built in build/mutants
CHECKS = FOLDER / "rooms.checks"


@dataclass(frozen=True)
class Drawn:
    """A mutant. Its name is a digest of its unit, its place there and the text that replaces it: no other change renames it."""
    name: str
    file: str
    line: int
    rule: str
    begin: int
    end: int
    text: str

    def room(self):
        return self.file.rpartition("/")[0]

    def source(self, root=ROOT):
        return (root / self.file).read_text()

    def apply(self, root=ROOT):
        source = self.source(root)
        return source[:self.begin] + self.text + source[self.end:]

    def shown(self, root=ROOT):
        """Its line, with what was there and what replaces it."""
        source = self.source(root)
        begin, end = source.rfind("\n", 0, self.begin) + 1, source.find("\n", self.end)
        what = " ".join(source[self.begin:self.end].split())
        return f"{source[begin:self.begin].lstrip()}[{what} -> {self.text}]{source[self.end:end]}"


def mutants_of(file, root=ROOT):
    """All that the rules find in a file."""
    source = (root / file).read_text()
    plain, found, seen = code.without_comments(source), [], defaultdict(int)
    units = code.units(source) or [code.Unit(0, len(source))]
    begins, digests = [unit.begin for unit in units], [code.digest(plain[unit.begin:unit.end]) for unit in units]
    words = [word.start() for word in re.finditer(code.TOKEN, plain)]
    for site in rules.sites(source):
        unit = bisect.bisect(begins, site.begin) - 1
        place = bisect.bisect_left(words, site.begin) - bisect.bisect_left(words, begins[unit])
        what = (file, digests[unit], place, plain[site.begin:site.end], site.text, site.rule)
        seen[what] += 1  # a unit that stands in the file twice
        name = hashlib.sha256(repr((*what, seen[what])).encode()).hexdigest()[:12]
        found.append(Drawn(name, file, source.count("\n", 0, site.begin) + 1, site.rule, site.begin, site.end, site.text))
    return found


def lines_of_code(text):
    return sum(bool(line.strip()) for line in code.without_comments(text).splitlines())


def rooms_of(root=ROOT):
    """The files of each folder of src from which mutants are drawn, and its lines of code."""
    files, lines = defaultdict(list), defaultdict(int)
    for path in sorted((root / "src").rglob("*.[ch]pp")):
        file = path.relative_to(root).as_posix()
        if not file.startswith(NOT_DRAWN):
            room = file.rpartition("/")[0]
            files[room].append(file)
            lines[room] += lines_of_code(path.read_text())
    return files, lines


def shares(lines, count):
    """How many of `count` each room has: the largest remainders are rounded up."""
    total = sum(lines.values())
    exact = {room: count * n / total for room, n in lines.items()}
    found = {room: int(share) for room, share in exact.items()}
    for room in sorted(lines, key=lambda room: (found[room] - exact[room], room))[:count - sum(found.values())]:
        found[room] += 1
    return found


def draw_from(mutants, count, seed):
    """The rules take turns: constants, which most lines have, are not most of the mutants. What comes first is decided by
    digests, of rules and of names, so that a change of one function leaves most mutants of others drawn."""
    def order(*words):
        return hashlib.sha256(" ".join([str(seed), *words]).encode()).digest()

    by_rule = defaultdict(list)
    for mutant in mutants:
        by_rule[mutant.rule].append(mutant)
    for each in by_rule.values():
        each.sort(key=lambda mutant: order(mutant.name), reverse=True)
    turns = sorted(by_rule, key=lambda rule: order(mutants[0].room(), rule))
    drawn = []
    while len(drawn) < count and any(by_rule.values()):
        for rule in turns:
            if by_rule[rule] and len(drawn) < count:
                drawn.append(by_rule[rule].pop())
    return sorted(drawn, key=lambda mutant: (mutant.file, mutant.begin, mutant.end, mutant.text))


def draw(seed, count, root=ROOT):
    """The mutants of a seed, room by room."""
    files, lines = rooms_of(root)
    drawn = []
    for room, number in shares(lines, count).items():
        drawn += draw_from([m for file in files[room] for m in mutants_of(file, root)], number, seed)
    return drawn


def read_checks(path=CHECKS):
    lines = [line for line in path.read_text().splitlines() if line.strip() and not line.startswith("#")]
    if wrong := [line for line in lines if not line.startswith("check ")]:
        raise Broken(f"{path.name}: no directive: {wrong[0]}")
    return [Check(line.removeprefix("check ")) for line in lines]


def checks_of(mutant, checks):
    found = [check for check in checks if check.is_of(mutant.file)]
    if not found:
        raise Broken(f"{CHECKS.name}: no check for {mutant.file}")
    return found
