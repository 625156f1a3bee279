"""The lines of certificate files, for check.py, as README.md defines them. What is wrong in a line is refused here, if a look at the line shows it."""
from operator import lt

from reading import counts, numbers

HEADERS = ("ecods-certificate 2", "ecods-world-certificate 2")
OLD_HEADERS = ("ecods-certificate 1", "ecods-world-certificate 1")  # which named meshes by a linear digest
WORK_MAX = 2**28  # units of about 0.1 us, and 256 more for each byte: half a minute


class Refused(Exception):
    """Why a certificate is not accepted, and at which line."""


class Lines:
    """The lines of a certificate file, one after the other."""

    def __init__(self, data):
        self.lines = data.decode("latin-1").split("\n")
        if self.lines.pop() != "":
            self.lines.append("\r")  # no line reads so: the last one does not end
        self.at, self.left = 0, WORK_MAX + 256 * len(data)

    def fail(self, why):
        raise Refused(f"line {max(self.at, 1)}: {why}")

    def spend(self, units):
        if units > self.left:
            self.fail("too costly")
        self.left -= units

    def next(self):
        """The fields of the next line."""
        self.at += 1
        if self.at > len(self.lines):
            self.fail("the file ends before its certificate does")
        return self.lines[self.at - 1].split(" ")

    def peek(self):
        return self.lines[self.at].split(" ")[0] if self.at < len(self.lines) else ""

    def expect(self, *words):
        if self.next() != list(words):
            self.fail(f"this line is not: {' '.join(words)}")

    def skip(self, line):
        """To the first line behind this one that begins a certificate; whether there is one."""
        self.at = line
        while self.at < len(self.lines) and self.lines[self.at] not in HEADERS + OLD_HEADERS:
            self.at += 1
        return self.at < len(self.lines)

    def numbers(self, words, count):
        values = numbers(words) if len(words) == count else None
        return self.fail(f"there are not {count} numbers") if values is None else values

    def distance(self, word):
        return self.fail("a distance has a sign") if word.startswith("-") else self.numbers([word], 1)[0]

    def counts(self, words, *limits):
        """Counts, each less than its limit."""
        values = counts(words) if len(words) == len(limits) else None
        if values is None or not all(map(lt, values, limits)):
            self.fail(f"there are not {len(limits)} numbers, or one is too large")
        return values

    def is_world(self):
        """Whether the next line begins a world's certificate; if not, it must begin one of a pair or a segment."""
        line = " ".join(self.next())
        if line in OLD_HEADERS:
            self.fail("format 1: its mesh digests can be forged; issue the certificate again")
        return HEADERS.index(line) == 1 if line in HEADERS else self.fail("no certificate begins so")

    def body(self, meshes, words):
        """The mesh with a digest, and a pose."""
        if not words or words[0] not in meshes:
            self.fail("no mesh has this digest")
        return meshes[words[0]], self.numbers(words[1:], 12)

    def head(self, meshes):
        """Body a, and body b or the six numbers of a segment."""
        if (words := self.next())[0] != "a":
            self.fail("this is not the line of a")
        a, (kind, *words) = self.body(meshes, words[1:]), self.next()
        if kind not in ("b", "segment"):
            self.fail("this is neither the line of b nor a segment")
        return a, self.body(meshes, words) if kind == "b" else self.numbers(words, 6)

    def step(self, fields, axis_count, row_count, column_count):
        """The axes that a step names, the pairs (row, column) that it leaves open, and the columns that it does not, by rows."""
        bar = fields.index("|") if "|" in fields else len(fields)
        names, left = counts(fields[:bar]), counts(fields[bar + 1 :])
        if names is None or left is None or max(names, default=-1) >= axis_count or max(left, default=-1) >= row_count * column_count:
            self.fail("there is no such axis or pair, or one is not a number")
        if len(set(names)) < bar or left != sorted(set(left)) or fields[bar:] == ("|",):
            self.fail("an axis stands twice, or the pairs left open are not ascending, or none stands behind the bar")
        pairs, closed = [divmod(at, column_count) for at in left], {row: list(range(column_count)) for row in range(row_count)}
        for row, column in pairs:
            closed[row].remove(column)
        return names, pairs, closed

    def feature(self, words):
        """A feature's kind, its numbers as they stand, and the words behind it."""
        kind = words[0] if words else ""
        size = {"v": 3, "e": 3, "f": 2}.get(kind, len(words) + 1)
        return (kind, words[1:size], words[size:]) if size <= len(words) else self.fail("there is no such feature")

    def body_id(self, word):
        slot, generation = self.counts(word.split("."), 2**32, 2**32)
        return (slot, generation) if slot > 0 else self.fail("slot 0 is no body's")

    def hexadecimal(self, word):
        is_one = 1 <= len(word) <= 16 and set(word) <= set("0123456789abcdef")
        return int(word, 16) if is_one else self.fail("a filter is not 1 to 16 hexadecimal digits")

    def pair(self, word):
        """Two bodies' ids, the lesser first."""
        first, *names = self.next()
        pair = tuple(map(self.body_id, names))
        if first != word or len(pair) != 2 or not pair[0] < pair[1]:
            self.fail("these are not two bodies, the lesser id first")
        return pair

    def world(self, read_body):
        """The clearance, or None; bodies, groups and masks by ids; the pairs that are switched off."""
        name, *words = self.next()
        if name != "clearance" or len(words) != 1:
            self.fail("this is not a clearance")
        clearance = None if words == ["none"] else self.distance(words[0])
        bodies, pairs, last = {}, [()], (-1,)
        while self.peek() == "body":
            words = self.next()
            if len(words) != 17 or self.body_id(words[1]) <= last:
                self.fail("this is not a body, or its id is not above the last one's")
            filters = self.hexadecimal(words[3]), self.hexadecimal(words[4])
            last = self.body_id(words[1])
            bodies[last] = read_body([words[2], *words[5:]]), *filters
        while self.peek() == "off":
            pairs.append(self.pair("off"))
            if pairs[-1] <= pairs[-2] or not {*pairs[-1]} <= bodies.keys():
                self.fail("the pairs are not ascending, or one of these is no body of the world")
        return clearance, bodies, set(pairs[1:])
