"""Triangles in rational numbers, for truth.py: their distances, whether they meet or cross, and where a segment meets one."""
import math
from fractions import Fraction


def sub(p, q):
    return [x - y for x, y in zip(p, q)]


def dot(p, q):
    return sum(x * y for x, y in zip(p, q))


def cross(p, q):
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def normal(triangle):
    return cross(sub(triangle[1], triangle[0]), sub(triangle[2], triangle[1]))


def edges(triangle):
    return [(triangle[i], triangle[(i + 1) % 3]) for i in range(3)]


def real(word):
    return Fraction(float.fromhex(word))


# Distances, squared, of integer points.


def point_segment(p, ends):
    e, w, v = sub(ends[1], ends[0]), sub(p, ends[0]), sub(p, ends[1])
    if dot(w, e) <= 0:
        return Fraction(dot(w, w))
    if dot(v, e) >= 0:
        return Fraction(dot(v, v))
    return Fraction(dot(w, w) * dot(e, e) - dot(w, e) ** 2, dot(e, e))


def segment_segment(one, other):
    least = min(
        point_segment(one[0], other), point_segment(one[1], other), point_segment(other[0], one), point_segment(other[1], one)
    )
    e, f, w = sub(one[1], one[0]), sub(other[1], other[0]), sub(other[0], one[0])
    n = cross(e, f)
    if any(n):
        square = dot(n, n)
        s, t = dot(cross(w, f), n), dot(cross(w, e), n)
        if 0 <= s <= square and 0 <= t <= square:
            least = min(least, Fraction(dot(w, n) ** 2, square))
    return least


def is_over(point, triangle, n):
    return all(dot(n, cross(sub(q, p), sub(point, p))) >= 0 for p, q in edges(triangle))


def point_face(p, triangle):
    """Infinity unless the foot is in a triangle with a normal; edges are looked at elsewhere."""
    n = normal(triangle)
    return Fraction(dot(n, sub(p, triangle[0])) ** 2, dot(n, n)) if any(n) and is_over(p, triangle, n) else math.inf


def pierced(ends, triangle):
    """The parameter at which a segment passes the plane of a triangle within it, if there is just one."""
    n = normal(triangle)
    start, stop = (dot(n, sub(end, triangle[0])) for end in ends)
    if not any(n) or start == stop or start * stop > 0:
        return None
    s = Fraction(start, start - stop)
    point = [x + s * (y - x) for x, y in zip(*ends)]
    return s if is_over(point, triangle, n) else None


def distance_squared(t, u):
    if any(pierced(e, u) is not None for e in edges(t)) or any(pierced(e, t) is not None for e in edges(u)):
        return Fraction(0)
    least = min(point_face(p, x) for x, y in ((t, u), (u, t)) for p in y)
    return min([least, *(segment_segment(e, f) for e in edges(t) for f in edges(u))])


def box_gap_squared(t, u):
    """The distance, squared, of the boxes of two triangles."""
    gaps = (max(min(x) - max(y), min(y) - max(x), 0) for x, y in zip(zip(*t), zip(*u)))
    return sum(gap * gap for gap in gaps)


def meet(t, u):
    return box_gap_squared(t, u) == 0 and distance_squared(t, u) == 0


def least_squared(a, b):
    """The distance of two bodies, squared."""
    pairs = sorted(((box_gap_squared(t, u), t, u) for t in a.values() for u in b.values()), key=lambda pair: pair[0])
    least = math.inf
    for gap, t, u in pairs:
        if gap >= least:
            break
        least = min(least, distance_squared(t, u))
    return least


def passes(t, u, way):
    """The open interval, of parameters along the line of both planes, that the inside of t has there; None if it has none."""
    n = normal(u)
    sides = [dot(n, sub(p, u[0])) for p in t]
    if not min(sides) < 0 < max(sides):
        return None
    ends = []
    for i in range(3):
        (p, a), (q, b) = (t[i], sides[i]), (t[(i + 1) % 3], sides[(i + 1) % 3])
        if a == 0:
            ends.append(Fraction(dot(way, p)))
        if a * b < 0:
            ends.append(dot(way, [x + Fraction(a, a - b) * (y - x) for x, y in zip(p, q)]))
    return min(ends), max(ends)


def cross_each_other(t, u):
    """Whether the relative interiors meet, of triangles that are not in one plane."""
    if not any(normal(t)):
        t, u = u, t
    n = normal(t)
    if not any(n):
        return False
    if any(normal(u)):
        way = cross(normal(t), normal(u))
        one, other = passes(t, u, way), passes(u, t, way)
        return one is not None and other is not None and max(one[0], other[0]) < min(one[1], other[1])
    e = max(edges(u), key=lambda ends: dot(sub(*ends), sub(*ends)))
    start, stop = (dot(n, sub(end, t[0])) for end in e)
    if start * stop >= 0:
        return False
    point = [x + Fraction(start, start - stop) * (y - x) for x, y in zip(*e)]
    return all(dot(n, cross(sub(q, p), sub(point, p))) > 0 for p, q in edges(t))


def first_parameter(ends, triangle):
    """The least parameter at which a segment meets a triangle, or None."""
    way, n = sub(ends[1], ends[0]), normal(triangle)
    if any(n) and dot(n, way) != 0:
        return pierced(ends, triangle)
    # In the plane, or a triangle without one: the first point is the start, or on an edge.
    found = [Fraction(0)] if any(n) and point_face(ends[0], triangle) == 0 else []
    for p, q in edges(triangle):
        if segment_segment(ends, (p, q)) != 0:
            continue
        m, w = cross(way, sub(q, p)), sub(p, ends[0])
        if any(m):
            found.append(Fraction(dot(cross(w, sub(q, p)), m), dot(m, m)))
        elif not any(way):
            found.append(Fraction(0))
        else:
            at = [Fraction(dot(sub(x, ends[0]), way), dot(way, way)) for x in (p, q)]
            found.append(max(min(at), 0))
    return min(found, default=None)
