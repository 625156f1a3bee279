"""A third, slow reading of certificates, for tests: whether a claim is true, and whether the steps prove it, triangle by triangle.

It shares nothing with the checkers: relations come from edges and faces, never from the 32 vectors; distances are the least over all
features; a proof holds if each pair of triangles falls under a step whose vector parts just these two. It does not refuse what is badly
written: it is asked about certificates that a checker accepted.
"""
import hashlib
import math
from fractions import Fraction

from triangles import cross, cross_each_other, dot, first_parameter, least_squared, meet, normal, point_face, real, segment_segment, sub


# Rounding of the square root of a rational number, and of one; the unit of lengths is 2^-power.


def rounds_to(square, value, power):
    """Whether sqrt(square) 2^-power > 0 rounds to a double, ties to even, positive numbers to 2^-1074 at least."""
    square = square / Fraction(4) ** power
    if square == 0:
        return value == 0
    if value == 0:
        return False
    low = Fraction(0) if value == 2.0**-1074 else (Fraction(math.nextafter(value, 0)) + top(value)) / 2
    high = (top(math.nextafter(value, math.inf)) + top(value)) / 2 if value < math.inf else None
    is_even = value == math.inf or int(value / math.ulp(value)) % 2 == 0
    inside = low**2 < square and (high is None or square < high**2)
    return inside or is_even and square in (low**2, high**2 if high is not None else None)


def top(value):
    return Fraction(value) if value < math.inf else Fraction(2) ** 1024


# Meshes, posed.


class Soup:
    """A mesh file: corners by the caller's numbers, and the tree: ("n", children) and ("l", triangles)."""

    def __init__(self, data):
        self.digest = hashlib.sha256(data).hexdigest()
        lines = data.decode().splitlines()
        _, nv, _, nt, _, _ = lines[1].split()
        vertices = [[Fraction(float.fromhex(word)) for word in line.split()] for line in lines[2 : 2 + int(nv)]]
        rows = [list(map(int, line.split())) for line in lines[2 + int(nv) : 2 + int(nv) + int(nt)]]
        self.triangles = {row[3]: [vertices[corner] for corner in row[:3]] for row in rows}
        self.order, self.nodes = [row[3] for row in rows], [line.split() for line in lines[2 + int(nv) + int(nt) :]]
        self.tree, self.order, self.nodes = self.node(iter(self.order), iter(self.nodes)), None, None

    def node(self, order, nodes):
        kind, count = next(nodes)
        if kind == "l":
            return "l", [("t", next(order)) for _ in range(int(count))]
        return "n", [self.node(order, nodes) for _ in range(int(count))]


def posed(soup, words):
    """The triangles under a pose, in rational numbers."""
    m = [real(word) for word in words]
    rows = [(m[i : i + 3], m[i + 3]) for i in (0, 4, 8)]
    points = {tuple(p): [dot(r, p) + t for r, t in rows] for triangle in soup.triangles.values() for p in triangle}
    return {name: [points[tuple(p)] for p in triangle] for name, triangle in soup.triangles.items()}


def integers(*bodies):
    """The same in integers, and their unit's power."""
    power = max((x.denominator for body in bodies for t in body.values() for p in t for x in p), default=1).bit_length() - 1
    return [{k: [[int(x * 2**power) for x in p] for p in t] for k, t in body.items()} for body in bodies], power


def below(tree):
    return [tree[1]] if tree[0] == "t" else [name for child in tree[1] for name in below(child)]


# Claims.


def named_features(words, a, b):
    """The corners of the two features that words name, the fewer first."""
    found = []
    for body in (a, b):
        size = 2 if words[0] == "f" else 3
        triangle, corner = body[int(words[1])], int(words[2]) if size == 3 else 0
        found.append({"v": [triangle[corner]], "e": [triangle[corner], triangle[(corner + 1) % 3]], "f": triangle}[words[0]])
        words = words[size:]
    return sorted(found, key=len)


def features_squared(words, a, b):
    """The distance, squared, of the two features that words name."""
    p, q = named_features(words, a, b)
    if len(q) == 3:
        return point_face(p[0], q)
    return segment_segment((p[0], p[-1]), (q[0], q[-1]))


def has_feet(words, a, b):
    """Whether the closest points of what two features span, the points, lines and plane, are in the features, one in each."""
    p, q = named_features(words, a, b)
    if len(q) == 3:
        return point_face(p[0], q) < math.inf
    e, f, w = sub(p[-1], p[0]), sub(q[-1], q[0]), sub(q[0], p[0])
    if len(q) == 1:
        return True
    if len(p) == 1:
        return any(f) and 0 <= -dot(w, f) <= dot(f, f)
    n = cross(e, f)
    return any(n) and 0 <= dot(cross(w, f), n) <= dot(n, n) and 0 <= dot(cross(w, e), n) <= dot(n, n)


def claim_holds(words, a, b, power):
    """Whether a claim is true of two bodies, and so are the features that it names."""
    kind = words[0]
    if kind in ("touching", "crossing", "distance", "within") and len(words) > 2 and words[-2].isdigit() and words[-3] not in "vef":
        pair = a.get(int(words[-2])), b.get(int(words[-1]))
        if None in pair or not meet(*pair):
            return False
        if kind in ("distance", "within"):
            return kind == "within" or real(words[1]) == 0
        return cross_each_other(*pair) if kind == "crossing" else not any(cross_each_other(t, u) for t in a.values() for u in b.values())
    if kind == "disjoint":
        return not any(meet(t, u) for t in a.values() for u in b.values())
    if len(words) > 2 and not has_feet(words[2:], a, b):
        return False
    if words[1] == "inf" and kind == "within":
        return True
    square = least_squared(a, b)
    if words[1] == "inf":
        return rounds_to(square, math.inf, power)
    if kind == "distance":
        value = float.fromhex(words[1])
        return rounds_to(square, value, power) and rounds_to(features_squared(words[2:], a, b), value, power)
    bound = (real(words[1]) * 2**power) ** 2
    return features_squared(words[2:], a, b) <= bound if kind == "within" else square > bound


def hit_holds(words, a, ends):
    found = {name: first_parameter(ends, triangle) for name, triangle in a.items()}
    first = min((s for s in found.values() if s is not None), default=None)
    if words[0] == "miss" or first is None:
        return words[0] == "miss" and first is None
    value, own = float.fromhex(words[1]), found.get(int(words[2]))
    # The triangle is met at some parameter that rounds to S: its first one may round lower only if S is not the first of all.
    return rounds_to(first**2, value, 0) and own is not None and rounds_to(own**2, value, 0)


# Proofs, pair of triangles by pair of triangles.


def bounds(words, power):
    """(the least ratio of gap and length, whether more is needed) of a claim; None of `touching`."""
    if words[0] == "touching":
        return None
    if words[0] == "beyond":
        return real(words[1]) * 2**power, True
    if words[0] != "distance":
        return Fraction(0), True
    value = math.inf if words[1] == "inf" else float.fromhex(words[1])
    low = Fraction(0) if value == 2.0**-1074 else (Fraction(math.nextafter(value, 0)) + top(value)) / 2
    return low * 2**power, value < math.inf and int(value / math.ulp(value)) % 2 == 1


def parts_pair(n, t, u, least):
    """Whether two triangles are apart along n."""
    one, other = [dot(n, p) for p in t], [dot(n, p) for p in u]
    gap = max(min(other) - max(one), min(one) - max(other))
    if least is None:
        return gap >= 0
    ratio, is_more = least
    left, right = gap * gap, ratio * ratio * dot(n, n)
    return gap > 0 and (left > right if is_more else left >= right)


def heads_off(n, t, piece, is_strict):
    """Whether a triangle is apart from a piece of a segment along n: its start strictly, its stop so or level with it."""
    values = [dot(n, p) for p in t]
    for side in (1, -1):
        start, stop = side * dot(n, piece[0]), side * dot(n, piece[1])
        high = max(side * value for value in values)
        if high < start and (high < stop or high == stop and not is_strict):
            return True
    return False


class Proof:
    """The axes and steps of one claim."""

    def __init__(self, lines, a, b, is_apart):
        self.lines, self.a, self.b, self.is_apart, self.axes = lines, a, b, is_apart, []

    def axis(self, words):
        if words[0] in ("na", "nb"):
            return normal((self.a if words[0] == "na" else self.b)[int(words[1])])
        if words[0] == "x":
            name, i, other, j = map(int, words[1:])
            return self.formula(self.a[name], self.b[other], "x", i, j)
        return [real(word) for word in words]

    @staticmethod
    def edge(triangle, i):
        return sub(triangle[(i + 1) % 3], triangle[i])

    def formula(self, t, u, kind, *numbers):
        i, j = [*map(int, numbers), 0, 0][:2]
        unit = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        if kind in ("va", "vb"):
            (p, e) = (sub(t[i], u[j]), self.edge(u, j)) if kind == "va" else (sub(u[i], t[j]), self.edge(t, j))
            return [dot(e, e) * x - dot(p, e) * y for x, y in zip(p, e)]
        if kind == "na" or kind == "nb":
            return normal(t if kind == "na" else u)
        if kind == "x":
            return cross(self.edge(t, i), self.edge(u, j))
        if kind in ("ea", "eb"):
            return cross(self.edge(t if kind == "ea" else u, i), unit[j])
        return unit[i] if kind == "c" else sub(u[j], t[i])

    def holds(self, roots):
        """Whether every pair of triangles falls under a step that parts it. Leaves the lines behind `end`."""
        pending = [roots]
        while pending:
            kind, *words = next(self.lines).split()
            if kind == "axis":
                self.axes.append(self.axis(words))
                continue
            one, other = pending.pop()
            if kind == "t":
                t, u = self.a[one[1]], self.b[other[1]]
                n = self.formula(t, u, *words)
                if not any(n) or not self.is_apart(n, t, u):
                    return False
                continue
            bar = words.index("|") if "|" in words else len(words)
            named, left = [self.axes[int(word)] for word in words[:bar]], list(map(int, words[bar + 1 :]))
            ones = one[1] if "a" in kind and one[0] != "t" else [one]
            others = other[1] if "b" in kind and other[0] != "t" else [other]
            pairs = [(x, y) for x in ones for y in others]
            for at, (x, y) in enumerate(pairs):
                if at not in left and not self.parted(named, x, y):
                    return False
            pending.extend(pairs[at] for at in reversed(left))
        while (line := next(self.lines)).startswith("axis "):  # that no step names
            if not any(self.axis(line.split()[1:])):
                return False
        return line == "end"

    def parted(self, named, x, y):
        triangles = [(self.a[i], self.b[j]) for i in below(x) for j in below(y)]
        return all(any(any(n) and self.is_apart(n, t, u) for n in named) for t, u in triangles)


def pair_holds(claim, lines, a, b, trees, power):
    """Whether a claim is true and its steps, if it needs some, prove it."""
    words = claim.split()[1:]
    if not claim_holds(words, a, b, power):
        return False
    if words[0] in ("crossing", "within") or words[0] == "distance" and words[1] != "inf" and real(words[1]) == 0:
        return next(lines) == "end"
    least = bounds(words, power)
    return Proof(lines, a, b, lambda n, t, u: parts_pair(n, t, u, least)).holds(trees)


def segment_holds(claim, lines, body, tree, ends):
    words = claim.split()[1:]
    if not hit_holds(words, body, ends):
        return False
    value = float.fromhex(words[1]) if words[0] == "hit" else 1.0
    if value == 0:
        return next(lines) == "end"
    m = Fraction(1)
    if words[0] == "hit":
        m = Fraction(0) if value == 2.0**-1074 else (Fraction(math.nextafter(value, 0)) + Fraction(value)) / 2
    stop = [x + m * (y - x) for x, y in zip(*ends)]
    (body, piece), _ = integers(body, {0: [ends[0], stop, stop]})
    is_strict = int(value / math.ulp(value)) % 2 == 1
    if words[0] == "hit":
        proof = Proof(lines, body, piece, lambda n, t, u: heads_off(n, t, u, is_strict))
    else:
        proof = Proof(lines, body, piece, lambda n, t, u: parts_pair(n, t, u, (Fraction(0), True)))
    return proof.holds((tree, ("t", 0)))


def certificate_holds(text, soups):
    """Whether a certificate of a pair or a segment is true and proves what it says. `soups` by digest."""
    lines = iter(text.split("\n"))
    next(lines)
    _, digest, *pose = next(lines).split()
    one = soups[digest]
    second = next(lines).split()
    claim = next(lines)
    if second[0] == "segment":
        numbers = [real(word) for word in second[1:]]
        (a, piece), _ = integers(posed(one, pose), {0: [numbers[:3], numbers[3:]]})
        return segment_holds(claim, lines, a, one.tree, piece[0])
    other = soups[second[1]]
    (a, b), power = integers(posed(one, pose), posed(other, second[2:]))
    return pair_holds(claim, lines, a, b, (one.tree, other.tree), power)


def world_holds(text, soups):
    """The same of a world: also that the lists that follow from its claims are the true ones."""
    lines = iter(text.split("\n"))
    next(lines)
    word = next(lines).split()[1]
    clearance = None if word == "none" else real(word)
    bodies, off, kinds = {}, set(), {}
    line = next(lines)
    while line.startswith("body "):
        _, name, digest, groups, mask, *pose = line.split()
        bodies[name] = posed(soups[digest], pose), int(groups, 16), int(mask, 16), soups[digest].tree
        line = next(lines)
    placed, power = integers(*(body for body, *_ in bodies.values()))
    bodies = {name: (body, *rest[1:]) for (name, rest), body in zip(bodies.items(), placed)}
    while line.startswith("off "):
        off.add(tuple(line.split()[1:]))
        line = next(lines)
    while line.startswith("pair "):
        one, other = line.split()[1:]
        claim = next(lines)
        if not pair_holds(claim, lines, bodies[one][0], bodies[other][0], (bodies[one][3], bodies[other][3]), power):
            return False
        kinds.setdefault((one, other), []).append(claim.split()[1])
        line = next(lines)
    return line == "end world" and all(
        lists_hold(bodies, off, None if clearance is None else clearance * 2**power, kinds.get((one, other), []), one, other)
        for one in bodies
        for other in bodies
        if tuple(map(int, one.split("."))) < tuple(map(int, other.split(".")))
    )


def lists_hold(bodies, off, clearance, kinds, one, other):
    (a, groups, mask, _), (b, other_groups, other_mask, _) = bodies[one], bodies[other]
    if (one, other) in off or not groups & other_mask or not other_groups & mask:
        return not kinds
    square = least_squared(a, b)
    collide = "touching" in kinds or "crossing" in kinds
    return collide == (square == 0) and (clearance is None or (collide or "within" in kinds) == (square <= clearance**2))
