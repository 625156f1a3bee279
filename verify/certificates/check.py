#!/usr/bin/env python3
# Checks certificates: check.py CERTIFICATE [MESH...] . README.md has the format, and why an accepted certificate is true.
#
# Coordinates are integers here, in units of 2^-fine, which is so small that each posed corner is one. Doubles only look ahead: where
# their error leaves a comparison open, the integers decide.
import sys
from bisect import bisect_right

from apart import FORMULAS, INDICES, UNITS, Ahead, Apart, Weak, bits, cross, dot, edge, effort, is_apart_by_any, minus, normal, off, span
from command_line import run
from filters import count_unjudged, may_meet
from reading import INFINITY, ONE, ZERO, Kept, Segment, above, below, exactly, is_odd, scaled, to_double

# The error of a range in doubles. n is scaled so that |n_i| < 1, lengths so that |R_i1| X + |R_i2| X + |R_i3| X + |t_i| <= 1, where X is at
# least each |coordinate of v|. So the coefficients of n R v + n t, the products and the partial sums are below 3 together; with u = 2^-53,
# rounding coefficients, constant and v costs at most 9u, the products 3u, three additions 9u, and twice that where v was divided by X / 2.
NEAR = 2.0**-47
# The error of a difference of ranges less a floor: 2 NEAR, its own roundings (12u), and the floor's (16 * 4u), together below 2^-45.
MARGIN = 2.0**-44


# A posed mesh. Its corners are integers in units of 2^-fine, for any fine from finest on.
class Body:
    def __init__(self, lines, mesh, pose=(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0)):
        self.mesh, self.spend = mesh, lines.spend
        values, self.power = scaled(pose)
        self.rotation, self.translation = [values[0:3], values[4:7], values[8:11]], values[3::4]
        self.finest = self.power + mesh.fine

    def place(self, fine):
        self.fine, self.shift, self.corners = fine, fine - self.finest, Kept(self.corners_of)
        self.moved = [x << fine - self.power for x in self.translation]
        # 2^(scale + 1) is above all coordinates, and at least 2^-fine of the mesh, so that nothing is shifted to the right.
        spans = [sum(map(abs, row)) << self.mesh.scale + 1 + fine - self.power for row in self.rotation]
        self.size = max(x + abs(y) for x, y in zip(spans, self.moved)).bit_length()

    def corners_of(self, part):
        vertices = map(self.mesh.integers, self.mesh.corners[part - self.mesh.node_count])
        self.spend(effort(self.size, 10))
        return [[(dot(row, v) << self.shift) + x for row, x in zip(self.rotation, self.moved)] for v in vertices]

    # The corners of the triangle with this number in the caller's mesh.
    def named(self, lines, name):
        (number,) = lines.counts([name], len(self.mesh.line_of))
        return self.corners[self.mesh.node_count + self.mesh.line_of[number]]


# Ranges of n.x over the parts of a body. In doubles they are in units of 2^unit.
class Along:
    def __init__(self, body, n, unit):
        self.body, self.sharp, self.near, self.exact = body, Kept(self.sharp), Kept(self.near), Kept(self.exact)
        self.n, self.constant = [dot(n, column) for column in zip(*body.rotation)], dot(n, body.moved)
        factors = [to_double(x, body.mesh.scale + body.fine - body.power - unit) for x in self.n]
        self.doubles = *factors, to_double(self.constant, -unit)

        # Where a box, of six numbers, is least along n.
        self.least = [k if factor >= 0 else k + 3 for k, factor in enumerate(factors)]

    def values(self, part):
        x, y, z, constant = self.doubles
        if part not in (mesh := self.body.mesh).parts_points:
            self.body.spend(mesh.size(part))
        vertices, points = mesh.points(part)
        self.body.spend(4 * len(points))
        return vertices, [x * p + y * q + z * r + constant for p, q, r in points]

    # The range in doubles: each end is within NEAR of the true one.
    def sharp(self, part):
        values = self.values(part)[1]
        return min(values), max(values)

    # Of the parts of a part, or of itself: ends of ranges that contain theirs, but for NEAR, and the least and the greatest end.
    def near(self, of):
        (part, is_opened), mesh = of, self.body.mesh
        if mesh.is_triangle(part):
            return (ends := self.sharp[part])[:1], ends[1:], *ends
        if of not in mesh.boxes:
            self.body.spend(4 * mesh.size(part))
        if is_opened and mesh.is_leaf(part):
            values = self.values(part)[1]
            corners = [(values[i], values[j], values[k]) for i, j, k in mesh.places(part)]
            lows, highs = list(map(min, corners)), list(map(max, corners))
        else:  # of boxes, whose corners are as good as vertices
            (x, y, z, constant), (i, j, k), boxes = self.doubles, self.least, mesh.boxes[of]
            lows = [x * box[i] + y * box[j] + z * box[k] + constant for box in boxes]
            highs = [x * box[i - 3] + y * box[j - 3] + z * box[k - 3] + constant for box in boxes]
        self.body.spend(8 * len(lows))
        return lows, highs, min(lows), max(highs)

    # The range. In doubles, a vertex that attains an end is within 2 NEAR of the end in doubles.
    def exact(self, part):
        vertices, values = self.values(part)
        low, high = min(values) + 3 * NEAR, max(values) - 3 * NEAR
        near = [v for v, x in zip(vertices, values) if not low < x < high]
        self.body.spend(effort(self.body.size + bits(self.n), 3 * len(near)))
        ends = [dot(self.n, self.body.mesh.integers(v)) for v in near]
        return [(end << self.body.shift) + self.constant for end in (min(ends), max(ends))]


# A vector, and which pairs of parts are apart along it.
class Axis:
    def __init__(self, n, a, b, rule):
        all_bits = n[0] | n[1] | n[2]
        self.n, self.rule, self.spend = [x // (all_bits & -all_bits) for x in n], rule, a.spend
        unit = bits(self.n) + max(a.size, b.size)
        self.cost = effort(unit + rule.bits, 2)  # of a comparison in integers
        self.spend(10 * self.cost)
        self.a, self.b, self.floor = Along(a, self.n, unit), Along(b, self.n, unit), rule.floor(self.n, unit)

    def looks_apart(self, i, j, margin=MARGIN):
        (la, ha), (lb, hb) = self.a.sharp[i], self.b.sharp[j]
        return max(lb - ha, la - hb) - self.floor > margin

    # Of pairs of parts of i and j, or of themselves: those that do not look apart. `rows` has the columns of each row that has any.
    def not_apart(self, i, opens_i, j, opens_j, rows):
        (la, ha, *_), (lb, hb, low, high) = self.a.near[i, opens_i], self.b.near[j, opens_j]
        need, left = self.floor + MARGIN, {}
        self.spend(sum(map(len, rows.values())))
        for k, columns in rows.items():
            least, most = la[k] - need, ha[k] + need
            if low <= most and high >= least and (columns := [at for at in columns if lb[at] <= most and hb[at] >= least]):
                left[k] = columns
        return left

    def is_apart(self, i, j):
        self.spend(self.cost)
        return self.looks_apart(i, j, -MARGIN) and self.rule(self.n, self.a.exact[i], self.b.exact[j])


def read_axis(lines, a, b, kind="", *words):
    if kind in ("na", "nb") and len(words) == 1:
        n = normal((a if kind == "na" else b).named(lines, words[0]))
    elif kind == "x" and len(words) == 4:
        n = FORMULAS["x"](a.named(lines, words[0]), b.named(lines, words[2]), *lines.counts(words[1::2], 3, 3))
    else:
        n = scaled(lines.numbers([kind, *words], 3))[0]
    return n if any(n) else lines.fail("the axis is zero")


# One step about the parts i and j. Returns the pairs that it leaves open.
def prove_step(lines, a, b, axes, axis_count, rule, i, j, kind, *fields):
    triangles = a.mesh.is_triangle(i), b.mesh.is_triangle(j)
    if kind == "t" and all(triangles):
        p, q, name = a.corners[i], b.corners[j], fields[0] if fields and fields[0] in FORMULAS else lines.fail("no such formula")
        lines.spend(effort(3 * max(a.size, b.size) + rule.bits, 20))
        n = FORMULAS[name](p, q, *lines.counts(fields[1:], *[3] * INDICES[name]))
        return [] if any(n) and rule(n, span(n, p), span(n, q)) else lines.fail("the triangles are not apart so, or it is zero")
    opens_i, opens_j = "a" in kind, "b" in kind
    if kind not in ("a", "b", "ab") and (kind != "k" or len(fields) != 1) or kind != "k" and opens_i <= triangles[0] and opens_j <= triangles[1]:
        lines.fail("this is not a step about such parts, or it opens triangles only")
    rows, columns = a.mesh.parts(i) if opens_i else [i], b.mesh.parts(j) if opens_j else [j]
    names, left, closed = lines.step(fields, axis_count, len(rows), len(columns))
    lines.spend(len(rows) * len(columns))
    for name in names:
        closed = axes[name].not_apart(i, opens_i, j, opens_j, closed) if closed else closed
    closed = [(rows[k], columns[at]) for k, row in closed.items() for at in row]
    for name in names:
        lines.spend(8 * len(closed))
        closed = [pair for pair in closed if not axes[name].looks_apart(*pair)]
    if not all(any(axes[name].is_apart(*pair) for name in names) for pair in closed):
        lines.fail("a pair that is not left open is not apart along any of the axes")
    return [(rows[k], columns[at]) for k, at in left]


# Steps until all pairs are apart, axes among them, and the end.
def prove(lines, a, b, rule):
    vectors, pending, axes = [], [(0, 0)], Kept(lambda name: Axis(vectors[name], a, b, rule))
    while pending or lines.peek() == "axis":
        words = lines.next()
        if words[0] == "axis":
            vectors.append(read_axis(lines, a, b, *words[1:]))
        else:
            pending.extend(reversed(prove_step(lines, a, b, axes, len(vectors), rule, *pending.pop(), *words)))
    lines.expect("end")


# The corners of a feature, and the words behind it.
def feature(lines, body, words):
    kind, (name, *corner), words = lines.feature(words)
    corners = body.named(lines, name)
    for k in lines.counts(corner, *[3] * len(corner)):
        corners = (corners * 2)[k:][: 1 if kind == "v" else 2]
    return corners, words


# That the closest points of two features, which the words name, are in them, and at most so far apart, or less.
def check_closest(lines, a, b, words, most, is_less):
    one, words = feature(lines, a, words)
    other, words = feature(lines, b, words)
    p, q = sorted((one, other), key=len)
    w, e, f = minus(p[0], q[0]), minus(p[-1], p[0]), minus(q[-1], q[0])
    lines.spend(effort(4 * max(a.size, b.size), 20))
    n = w if len(q) == 1 else off(w, f) if len(p) < len(q) == 2 else cross(e, f) if len(q) == 2 else normal(q)
    is_in = {  # by the numbers of corners; e and f are zero at vertices
        (1, 1): lambda: True,
        (1, 2): lambda: 0 <= dot(w, f) <= dot(f, f) > 0,
        (1, 3): lambda: any(n) and all(dot(n, cross(edge(q, i), minus(p[0], q[i]))) >= 0 for i in range(3)),
        (2, 2): lambda: any(n) and all(0 <= -dot(cross(w, x), n) <= dot(n, n) for x in (e, f)),
    }.get((len(p), len(q)), lambda: False)
    square, unit = dot(w, n) ** 2, max(dot(n, n), 1)  # the distance is |w.n| / |n|, and 0 where n is
    if words or not is_in():
        lines.fail("these are not two features whose closest points are in them")
    left, right = (square << 2 * most[1], unit * most[0] ** 2 << 2 * a.fine) if most else (0, 1)
    if left > right or left == right and is_less:
        lines.fail("the closest points are too far apart")


def check_meeting(lines, a, b, names, rule):
    p, q = (body.named(lines, name) for body, name in zip((a, b), names))
    lines.spend(32 * effort(2 * max(a.size, b.size), 20))
    if is_apart_by_any(rule, p, q):
        lines.fail("the two triangles do not meet as the claim says")


# A claim about two bodies, with its proof. Returns the words of the claim.
def check_pair(lines, a, b, kinds):
    words, apart, steps = lines.next(), Apart(a.fine), None
    if words[0] != "claim" or not set(words[1:2]) <= kinds:
        lines.fail("no claim that may stand here")
    match words[1:]:
        case ["disjoint"]:
            steps = apart
        case ["touching", i, j]:
            check_meeting(lines, a, b, (i, j), apart)
            steps = Weak(a.fine)
        case ["crossing", i, j]:
            check_meeting(lines, a, b, (i, j), Weak(a.fine))
        case ["distance", "inf"]:
            steps = Apart(a.fine, below(INFINITY), False)
        case ["distance", d, i, j] if lines.distance(d) == 0:
            check_meeting(lines, a, b, (i, j), apart)
        case ["distance", d, *names] if (value := lines.distance(d)) > 0:
            check_closest(lines, a, b, names, above(value), is_odd(value))
            steps = Apart(a.fine, below(value), is_odd(value))
        case ["within", d, i, j] if d == "inf" or lines.distance(d) >= 0:
            check_meeting(lines, a, b, (i, j), apart)
        case ["within", d, *names]:
            check_closest(lines, a, b, names, None if d == "inf" else exactly(lines.distance(d)), False)
        case ["beyond", d]:
            steps = Apart(a.fine, exactly(lines.distance(d)))
        case _:
            lines.fail("this is not a claim")
    prove(lines, a, b, steps) if steps else lines.expect("end")
    return " ".join(words[1:])


# A claim about a segment, with its proof. Returns the words of the claim.
def check_hit(lines, a, ends):
    words, value, start, stop = lines.next(), 1, ONE, ONE
    match words:
        case ["claim", "miss"]:
            pass
        case ["claim", "hit", s, _] if (value := lines.distance(s)) <= 1:
            start, stop = (below(value), ONE if value == 1 else above(value)) if value > 0 else (ZERO, ZERO)
        case _:
            lines.fail("this is not a claim about a segment")
    piece, rest = (Body(lines, Segment(ends, *parameters)) for parameters in ((ZERO, start), (start, stop)))
    place(a, piece, rest)
    steps = Apart(a.fine)
    if words[1] == "hit":
        check_meeting(lines, a, rest, (words[3], "0"), Ahead(a.fine, rest.corners[0], not is_odd(value)))
        steps = Ahead(a.fine, piece.corners[0], is_odd(value))
    prove(lines, a, piece, steps) if value > 0 else lines.expect("end")
    return " ".join(words[1:])


def place(*bodies):
    fine = max((body.finest for body in bodies), default=0)
    for body in bodies:
        body.place(fine)


# The pairs of bodies whose boxes have no gap greater than the limit along any coordinate axis. Looked at are the pairs that have none along
# one of the axes: that along which these are fewest.
def near_pairs(lines, bodies, limit):
    boxes = [([Along(body, n, body.size + 1).exact[0] for n in UNITS], name) for name, (body, *_) in bodies.items()]
    starts = [sorted(box[k][0] - limit for box, _ in boxes) for k in range(3)]
    work, k = min((sum(bisect_right(starts[k], box[k][1]) for box, _ in boxes), k) for k in range(3))
    lines.spend(32 * (work - len(boxes) ** 2 // 2))
    boxes.sort(key=lambda each: each[0][k][0])
    for at, (box, name) in enumerate(boxes):
        for other, other_name in boxes[at + 1 : bisect_right(starts[k], box[k][1])]:
            if all(max(b[0] - a[1], a[0] - b[1]) <= limit for a, b in zip(box, other)):
                yield tuple(sorted((name, other_name)))


def check_world(lines, meshes):
    clearance, bodies, off_pairs = lines.world(lambda words: Body(lines, *lines.body(meshes, words)))
    place(*(body for body, *_ in bodies.values()))
    kinds, last = {}, ()
    while lines.peek() == "pair":
        pair = lines.pair("pair")
        if pair <= last or not {*pair} <= bodies.keys() or not may_meet(bodies, off_pairs, pair):
            lines.fail("the pairs are not ascending, or these two cannot meet")
        a, b = bodies[pair[0]][0], bodies[pair[1]][0]
        kind, *words = check_pair(lines, a, b, {"touching", "crossing", "disjoint", "beyond"}).split(" ")
        if kind == "disjoint" and clearance is not None:
            if lines.pair("pair") != pair:
                lines.fail("it is not said whether the last pair is within the clearance")
            kind, *words = check_pair(lines, a, b, {"within"}).split(" ")
        if kind in ("within", "beyond") and (words[0] == "inf" or lines.distance(words[0]) != clearance):
            lines.fail("the claim's distance is not the clearance")
        kinds[pair], last = kind, pair
    lines.expect("end", "world")
    n, power = exactly(clearance or 0.0)
    for pair in near_pairs(lines, bodies, (n << next(iter(bodies.values()))[0].fine >> power) if bodies else 0):
        if pair not in kinds and may_meet(bodies, off_pairs, pair):
            lines.fail("a pair that may meet has no claim: " + " ".join(f"{slot}.{generation}" for slot, generation in pair))
    counts = [list(kinds.values()).count(kind) for kind in ("touching", "crossing", "within")]
    close = f", {sum(counts)} close" if clearance is not None else ""
    unjudged = count_unjudged(lines, bodies, off_pairs)
    return f"world of {len(bodies)} bodies, {sum(counts[:2])} colliding{close}, {unjudged} pair{'' if unjudged == 1 else 's'} not judged"


# The words of what a certificate proves.
def check_certificate(lines, meshes):
    if lines.is_world():
        return check_world(lines, meshes)
    (mesh, pose), ends = lines.head(meshes)
    a = Body(lines, mesh, pose)
    if len(ends) == 6:
        return check_hit(lines, a, ends)
    b = Body(lines, *ends)
    place(a, b)
    return check_pair(lines, a, b, {"disjoint", "touching", "crossing", "distance", "within", "beyond"})


if __name__ == "__main__":
    sys.exit(run(check_certificate, sys.argv[1:]))
