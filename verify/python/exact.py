"""Answers about triangles in rational arithmetic, from definitions: the oracle of the module's tests.

Shares nothing with the library. A point is a tuple of three Fractions, a triangle a tuple of three points.
"""
from fractions import Fraction
from itertools import combinations, product
from math import inf, nextafter



def sub(p, q):
    return tuple(x - y for x, y in zip(p, q))


def dot(p, q):
    return sum(x * y for x, y in zip(p, q))


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def sign(x):
    return (x > 0) - (x < 0)


def posed(pose, point):
    """R v + t of a (3, 4) or (4, 4) nested list of floats and a point of floats."""
    v = [Fraction(x) for x in point]
    return tuple(sum(Fraction(pose[i][j]) * v[j] for j in range(3)) + Fraction(pose[i][3]) for i in range(3))


def triangles(vertices, faces, pose):
    points = [posed(pose, v) for v in vertices]
    return [tuple(points[i] for i in face) for face in faces]


def orient3d(a, b, c, d):
    return sign(dot(cross(sub(b, a), sub(c, a)), sub(d, a)))


def point_segment(p, a, b):
    """The squared distance of a point from a segment."""
    ab = sub(b, a)
    length = dot(ab, ab)
    s = Fraction(0) if length == 0 else min(max(Fraction(dot(sub(p, a), ab), 1) / length, 0), 1)
    gap = sub(p, tuple(x + s * y for x, y in zip(a, ab)))
    return dot(gap, gap)


def segment_segment(a, b, c, d):
    """The squared distance of two segments: inside both, or at an end of one."""
    best = min(point_segment(a, c, d), point_segment(b, c, d), point_segment(c, a, b), point_segment(d, a, b))
    u, v, w = sub(b, a), sub(d, c), sub(c, a)
    n = cross(u, v)
    nn = dot(n, n)
    if nn != 0:
        s, t = Fraction(dot(cross(w, v), n)) / nn, Fraction(dot(cross(w, u), n)) / nn
        if 0 <= s <= 1 and 0 <= t <= 1:
            best = min(best, Fraction(dot(w, n)) ** 2 / nn)
    return best


def is_above(p, triangle):
    """Whether a point's foot on the plane of a triangle with area lies in the triangle."""
    a, b, c = triangle
    n = cross(sub(b, a), sub(c, a))
    signs = {sign(dot(cross(sub(y, x), sub(p, x)), n)) for x, y in ((a, b), (b, c), (c, a))}
    return not {1, -1} <= signs and signs != set() and dot(n, n) != 0


def crosses(p, q, triangle):
    """Whether the segment p q goes from one side of the triangle's plane to the other through the triangle."""
    a, b, c = triangle
    sides = orient3d(a, b, c, p), orient3d(a, b, c, q)
    if sides[0] * sides[1] >= 0:
        return False
    around = {orient3d(p, q, x, y) for x, y in ((a, b), (b, c), (c, a))}
    return not {1, -1} <= around


def squared_distance(x, y):
    """Of two closed triangles: 0 where an edge of one passes through the other, otherwise between their features."""
    for one, other in ((x, y), (y, x)):
        if any(crosses(p, q, other) for p, q in combinations(one, 2)):
            return Fraction(0)
    best = min(segment_segment(*e, *f) for e, f in product(combinations(x, 2), combinations(y, 2)))
    for one, other in ((x, y), (y, x)):
        a, b, c = other
        n = cross(sub(b, a), sub(c, a))
        for p in one:
            if dot(n, n) != 0 and is_above(p, other):
                best = min(best, Fraction(dot(sub(p, a), n)) ** 2 / dot(n, n))
    return best


def least_squared_distance(body, other):
    return min(squared_distance(x, y) for x, y in product(body, other))


def is_rounded_root(value, square):
    """Whether a float is the square root of a Fraction, rounded once to nearest: it lies between the midpoints."""
    if square == 0:
        return value == 0
    below = nextafter(value, 0.0)  # what is positive rounds to a positive double
    lower = (Fraction(value) + Fraction(below)) / 2 if below > 0 else Fraction(0)
    upper = (Fraction(value) + Fraction(nextafter(value, inf))) / 2
    return lower * lower <= square <= upper * upper


def is_inside_interval(bounds, square):
    return Fraction(bounds.lower) ** 2 <= square <= Fraction(bounds.upper) ** 2
