"""Certificates of small random meshes, for tests: every claim, every kind of step and axis, degenerate triangles included.

All is decided by truth.py. Pairs of bodies are small enough for that: some ten triangles.
"""
import math
import random
from fractions import Fraction

import triangles
import truth

AXES = [["0x1p+0", "0x0p+0", "0x0p+0"], ["0x0p+0", "0x1p+0", "0x0p+0"], ["0x0p+0", "0x0p+0", "0x1p+0"]]
INDICES = {"na": 0, "nb": 0, "x": 2, "ea": 2, "eb": 2, "c": 1, "vv": 2, "va": 2, "vb": 2}
FORMULAS = [[name, *map(str, ij[:count])] for name, count in INDICES.items() for ij in ([i, j] for i in range(3) for j in range(3)) if ij[count:] == [0] * (2 - count)]


def shown(value):
    """A double as %a writes it."""
    text = float(value).hex()
    head, tail = text.split("p")
    return (head.rstrip("0").rstrip(".") if "." in head else head) + "p" + tail


def tree_lines(random_, triangles):
    """A random tree over a list: its lines in pre-order."""
    if len(triangles) <= 3 and random_.random() < 0.7 or len(triangles) == 1:
        return [f"l {len(triangles)}"]
    cuts = sorted({0, len(triangles), *(random_.randrange(len(triangles)) for _ in range(random_.randrange(4)))})
    lines = [f"n {len(cuts) - 1}"]
    return lines + [line for low, high in zip(cuts, cuts[1:]) for line in tree_lines(random_, triangles[low:high])]


def mesh_text(random_, vertices, triangles):
    order = list(range(len(triangles)))
    random_.shuffle(order)
    nodes = tree_lines(random_, order)
    lines = ["ecods-mesh 1", f"vertices {len(vertices)} triangles {len(triangles)} nodes {len(nodes)}"]
    lines += [" ".join(map(shown, vertex)) for vertex in vertices]
    lines += [" ".join(map(str, (*triangles[name], name))) for name in order]
    return "\n".join(lines + nodes) + "\n"


def random_mesh(random_):
    size = random_.choice([1, 2, 3])
    vertices = [[float(random_.randint(-size, size)) for _ in range(3)] for _ in range(random_.randint(3, 8))]
    if random_.random() < 0.3:
        vertices = [[x + random_.random() * 0.1 for x in vertex] for vertex in vertices]
    if random_.random() < 0.2:
        vertices = [[x, y, 0.0] for x, y, _ in vertices]
    if random_.random() < 0.1:
        vertices[0][0] = random_.choice([2.0**-1074, -0.0, 2.0**-600])
    triangles = [[random_.randrange(len(vertices)) for _ in range(3)] for _ in range(random_.randint(1, 8))]
    return mesh_text(random_, vertices, triangles)


def random_pose(random_, reach):
    rows = random_.sample([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], 3)
    kind = random_.random()
    if kind < 0.3:
        rows = [[random_.gauss(0, 1) for _ in range(3)] for _ in range(3)]
    elif kind < 0.5:
        rows = [[float(random_.randint(-2, 2)) for _ in range(3)] for _ in range(3)]
    move = [float(random_.randint(-reach, reach)) * random_.choice([1, 1, 0.3]) for _ in range(3)]
    scale = random_.choice([1.0] * 8 + [2.0**200, 2.0**-900, 2.0**900])
    return scale, [[x for x in row] for row in rows], move


def pose_text(scale, pose):
    _, rows, move = pose
    return " ".join(shown(scale * x) for row, t in zip(rows, move) for x in (*row, t))


class Steps:
    """The steps of a claim, found by trying."""

    def __init__(self, random_, a, b, is_apart):
        self.random, self.a, self.b, self.is_apart = random_, a, b, is_apart
        self.lines, self.count = [], 0
        self.proof = truth.Proof(iter(()), a, b, is_apart)
        self.pool = []

    def points(self, body, tree):
        return [p for name in truth.below(tree) for p in body[name]]

    def apart(self, n, one, other):
        return any(n) and self.is_apart(n, self.points(self.a, one), self.points(self.b, other))

    def candidates(self, one, other):
        """Axes as words, some of them named."""
        random_ = self.random
        i, j = random_.choice(truth.below(one)), random_.choice(truth.below(other))
        named = [["na", str(i)], ["nb", str(j)], ["x", str(i), str(random_.randrange(3)), str(j), str(random_.randrange(3))]]
        free = [shown(random_.randint(-9, 9)) for _ in range(3)]
        return random_.sample([*AXES, *named, free], 3)

    def useful(self, pairs):
        """The numbers of some axes that part some of the pairs; new ones are written."""
        known = self.random.sample(range(self.count), min(self.count, 4))
        found = [k for k in known if any(self.apart(self.pool[k], *pair) for pair in pairs)]
        for words in self.candidates(*self.random.choice(pairs)):
            n = self.proof.axis(words)
            if len(found) < 3 and any(self.apart(n, *pair) for pair in pairs):
                self.lines.append("axis " + " ".join(words))
                self.pool.append(n)
                found.append(self.count)
                self.count += 1
        return found

    def prove(self, one, other):
        pending = [(one, other)]
        while pending:
            pending.extend(reversed(self.step(*pending.pop())))
        return self.lines + ["end"]

    def step(self, one, other):
        if one[0] == "t" and other[0] == "t":
            t, u = self.a[one[1]], self.b[other[1]]
            for words in self.random.sample(FORMULAS, len(FORMULAS)):
                n = self.proof.formula(t, u, *words)
                if any(n) and self.is_apart(n, t, u):
                    self.lines.append("t " + " ".join(words))
                    return []
            raise AssertionError("no formula parts two triangles")
        found = self.useful([(one, other)]) if self.random.random() < 0.3 else []
        for k in found:
            if self.apart(self.pool[k], one, other):
                self.lines.append(f"k {k}")
                return []
        kind = self.random.choice(["ab", "a", "b", "ab"])
        if kind == "a" and one[0] == "t" or kind == "b" and other[0] == "t":
            kind = "ab"
        ones = one[1] if "a" in kind and one[0] != "t" else [one]
        others = other[1] if "b" in kind and other[0] != "t" else [other]
        pairs = [(x, y) for x in ones for y in others]
        named = self.useful(pairs) if self.random.random() < 0.8 else []
        left = [at for at, pair in enumerate(pairs) if not any(self.apart(self.pool[k], *pair) for k in named)]
        words = [kind, *map(str, named), *(["|", *map(str, left)] if left else [])]
        self.lines.append(" ".join(words))
        return [pairs[at] for at in left]


def rounded(square, power):
    """The double that sqrt(square) 2^-power rounds to."""
    exact = square / Fraction(4) ** power
    scale = 2 ** max(0, 1200 - (exact.numerator.bit_length() - exact.denominator.bit_length()) // 2)
    root = Fraction(math.isqrt(int(exact * scale**2)), scale)
    try:
        value = max(float(root), 2.0**-1074)
    except OverflowError:
        value = math.inf
    for near in (value, math.nextafter(value, 0), math.nextafter(value, math.inf)):
        if truth.rounds_to(square, near, power):
            return near
    raise AssertionError("nothing rounds")


def features(a, b, square):
    """Two features that attain the distance, those of the lowest dimension."""
    kinds = [("v", "v"), ("v", "e"), ("e", "v"), ("v", "f"), ("f", "v"), ("e", "e")]
    for one, other in kinds:
        for i in a:
            for j in b:
                for k in range(3 if one != "f" else 1):
                    for m in range(3 if other != "f" else 1):
                        words = [one, str(i), *([str(k)] if one != "f" else []), other, str(j), *([str(m)] if other != "f" else [])]
                        if truth.features_squared(words, a, b) == square:
                            return words
    raise AssertionError("no features attain the distance")


def pair_section(random_, soups, poses, kinds):
    """The lines of a claim of one of the kinds, if one of them is true here, and its steps."""
    bodies = [truth.posed(soup, pose.split()) for soup, pose in zip(soups, poses)]
    (a, b), power = truth.integers(*bodies)
    meeting = [(i, j) for i in a for j in b if triangles.meet(a[i], b[j])]
    crossing = [(i, j) for i, j in meeting if triangles.cross_each_other(a[i], b[j])]
    square = triangles.least_squared(a, b)
    value = rounded(square, power) if square else 0.0
    wide = min(value * random_.choice([1, 1.5, 1000]), 1.7e308)
    close = value * random_.choice([0, 0.5, 0.999])
    possible = {"within": [["within", shown(wide)]], "within inf": [["within", "inf"]]}
    if meeting:
        witness = list(map(str, random_.choice(meeting)))
        possible = {"within": [["within", shown(random_.choice([0.0, 1.0])), *witness], ["within", "inf", *witness]]}
        possible["distance"] = [["distance", "0x0p+0", *witness]]
        if crossing:
            possible["crossing"] = [["crossing", *map(str, random_.choice(crossing))]]
        else:
            possible["touching"] = [["touching", *witness]]
    else:
        words = features(a, b, square) if value < math.inf else []
        possible["disjoint"] = [["disjoint"]]
        possible["distance"] = [["distance", shown(value) if value < math.inf else "inf", *words]]
        possible["within"] = [["within", shown(wide), *words]] if value < math.inf and Fraction(wide) ** 2 * 4**power >= square else []
        possible["beyond"] = [["beyond", shown(close)]] if value < math.inf and Fraction(close) ** 2 * 4**power < square else []
    options = [words for kind in kinds for words in possible.get(kind, [])]
    if not options:
        return None
    words = random_.choice(options)
    lines = ["claim " + " ".join(words)]
    if words[0] in ("crossing", "within") or words[:2] == ["distance", "0x0p+0"]:
        return lines + ["end"]
    least = truth.bounds(words, power)
    steps = Steps(random_, a, b, lambda n, t, u: truth.parts_pair(n, t, u, least))
    return lines + steps.prove(soups[0].tree, soups[1].tree)


KINDS = ("disjoint", "touching", "crossing", "distance", "within", "beyond")


def random_pair(random_):
    """The texts of two meshes, and a certificate about them."""
    kind = random_.choice(KINDS)
    while True:
        texts = [random_mesh(random_), random_mesh(random_)]
        soups = [truth.Soup(text.encode()) for text in texts]
        reach = random_.choice([1, 2, 4, 8])
        one, other = random_pose(random_, reach), random_pose(random_, reach)
        poses = [pose_text(one[0], one), pose_text(one[0], other)]
        if any(word in poses[0] + poses[1] for word in ("inf", "nan")):
            continue
        section = pair_section(random_, soups, poses, [kind])
        if section:
            heads = [f"{name} {soup.digest} {pose}" for name, soup, pose in zip("ab", soups, poses)]
            return texts, "\n".join(["ecods-certificate 2", *heads, *section]) + "\n"


def random_hit(random_):
    """The text of a mesh, and a certificate about a segment."""
    text = random_mesh(random_)
    soup, pose = truth.Soup(text.encode()), random_pose(random_, 2)
    head = f"a {soup.digest} {pose_text(1.0, pose)}"
    body = truth.posed(soup, head.split()[2:])
    corners = random_.choice(list(body.values()))
    target = [float(sum(x) / 3) for x in zip(*corners)] if random_.random() < 0.7 else [float(x) for x in corners[0]]
    start = [x + random_.choice([0.0, 1.0, -2.0, random_.random()]) for x in target]
    stop = [x + random_.choice([0.5, 1.0, 1.0, 3.0]) * (x - y) for x, y in zip(target, start)]
    words = [shown(x) for x in (*start, *stop)]
    ends = [triangles.real(word) for word in words]
    ends = ends[:3], ends[3:]
    found = {name: s for name, t in body.items() if (s := triangles.first_parameter(ends, t)) is not None}
    lines = ["ecods-certificate 2", head, "segment " + " ".join(words)]
    piece, is_apart, steps = [ends[0], ends[1], ends[1]], lambda n, t, u: truth.parts_pair(n, t, u, (0, True)), ["end"]
    if found:
        first = min(found.values())
        value = rounded(first**2, 0) if first else 0.0
        name = random_.choice([name for name, s in found.items() if s and truth.rounds_to(s**2, value, 0) or s == value == 0])
        lines.append(f"claim hit {shown(value)} {name}")
        if value > 0:
            m = Fraction(0) if value == 2.0**-1074 else (Fraction(math.nextafter(value, 0)) + Fraction(value)) / 2
            stop = [x + m * (y - x) for x, y in zip(*ends)]
            is_strict = int(value / math.ulp(value)) % 2 == 1
            piece, is_apart = [ends[0], stop, stop], lambda n, t, u: truth.heads_off(n, t, u, is_strict)
    else:
        lines.append("claim miss")
    if lines[-1].split()[-2:-1] != ["0x0p+0"]:
        steps = Steps(random_, body, {0: piece}, is_apart).prove(soup.tree, ("t", 0))
    return [text], "\n".join([*lines, *steps]) + "\n"


def random_world(random_):
    texts = [random_mesh(random_) for _ in range(2)]
    soups = [truth.Soup(text.encode()) for text in texts]
    clearance = random_.choice([None, None, 0.0, 0.5, 1.0])
    lines = ["ecods-world-certificate 2", "clearance " + ("none" if clearance is None else shown(clearance))]
    bodies = []
    for slot in range(1, random_.randint(2, 6)):
        soup, pose = random_.choice(soups), pose_text(1.0, random_pose(random_, 5))
        filters = random_.choice([(1, 1), (3, 2), (2**64 - 1, 2**64 - 1), (2, 1)])
        bodies.append((f"{slot}.{random_.randrange(3)}", soup, pose, filters))
        lines.append(f"body {bodies[-1][0]} {soup.digest} {filters[0]:x} {filters[1]:x} {pose}")
    pairs = [(x, y) for i, x in enumerate(bodies) for y in bodies[i + 1 :]]
    off = [pair for pair in pairs if random_.random() < 0.1]
    lines += [f"off {x[0]} {y[0]}" for x, y in off]
    for x, y in pairs:
        if (x, y) in off or not x[3][0] & y[3][1] or not y[3][0] & x[3][1]:
            continue
        head = f"pair {x[0]} {y[0]}"
        lines += [head, *world_sections(random_, head, [x[1], y[1]], [x[2], y[2]], clearance)]
    return texts, "\n".join([*lines, "end world"]) + "\n"


def world_sections(random_, head, soups, poses, clearance):
    if clearance is None:
        return pair_section(random_, soups, poses, ["disjoint", "touching", "crossing"])
    bodies = [truth.posed(soup, pose.split()) for soup, pose in zip(soups, poses)]
    (a, b), power = truth.integers(*bodies)
    square = triangles.least_squared(a, b)
    if square == 0:
        return pair_section(random_, soups, poses, ["touching", "crossing"])
    if square > Fraction(clearance) ** 2 * 4**power:
        least = truth.bounds(["beyond", shown(clearance)], power)
        steps = Steps(random_, a, b, lambda n, t, u: truth.parts_pair(n, t, u, least))
        return [f"claim beyond {shown(clearance)}", *steps.prove(soups[0].tree, soups[1].tree)]
    words = features(a, b, square)
    disjoint = pair_section(random_, soups, poses, ["disjoint"])
    return [*disjoint, head, f"claim within {shown(clearance)} {' '.join(words)}", "end"]


def random_certificate(random_):
    return random_.choice([random_pair] * 6 + [random_hit] * 3 + [random_world])(random_)


if __name__ == "__main__":
    import sys

    source = random.Random(int(sys.argv[1]))
    mesh_texts, certificate = random_certificate(source)
    print(certificate)
