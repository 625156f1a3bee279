"""Entering, and points and normals of first contacts, beside rational numbers."""
import random
from fractions import Fraction as F

import numpy as np
import pytest

import ecods
import exact
from exact import cross, dot, sub
from scenes import at, box


def cube(x=1, y=1, z=1):
    return ecods.Solid(*box(x, y, z))


def test_a_cube_on_a_floor():
    floor = cube(8, 8, 1).at(at(-4, -4, -1))
    assert ecods.entering(cube(), [2, 0, 0], floor) is None
    assert ecods.entering(cube(), [0, 0, 1], floor) is None
    assert ecods.entering(cube(), [1, 0, -1], floor).time == 0
    entry = ecods.entering(cube().at(at(0, 0, 0.5)), [0, 0, -1], floor)
    assert entry.time == 0.5 and entry.a.kind == ecods.FeatureKind.face
    assert ecods.pose_before(cube().at(at(0, 0, 0.5)), [0, 0, -1], floor, entry.time)[2, 3] == 0
    with pytest.raises(ecods.NotSupported):
        ecods.entering(cube(), [1, 0, 0], ecods.Mesh(*box()))


def test_a_world():
    world = ecods.World()
    body = world.create_body(cube(), at(3, 0, 0))
    world.update()
    mover = cube()
    found = world.entering(mover.at(None), [4, 0, 0])
    assert found.body == body and found.entry.time == 0.5
    assert world.entering(mover.at(None), [4, 0, 0], max_time=0.5) is None
    assert world.entering(mover.at(None), [4, 0, 0], 0.75) == found
    contact = world.cast(mover.at(None), [4, 0.25, 0])
    assert world.contact_point(mover.at(None), [4, 0.25, 0], contact).normal.tolist() == [1, 0, 0]


def test_balls():
    a, b = ecods.sphere(3), ecods.sphere(2).at(at(8, 3, 0))
    contact = ecods.cast(a, [10, 0, 0], b)
    found = ecods.contact_point(a, [10, 0, 0], b, contact)
    assert found.point.tolist() == [6.4, 1.8, 0] and found.normal.tolist() == [0.8, 0.6, 0]
    floor = cube(8, 8, 1)
    ball = ecods.sphere(0.5).at(at(1, 2.5, 4))
    for first, second, motion in ((ball, floor, [0, 0, -8]), (floor, ball, [0, 0, 8])):
        contact = ecods.cast(first, motion, second)
        point = ecods.contact_point(first, motion, second, contact)
        assert point.normal.tolist() == [0, 0, np.sign(motion[2])]
    world = ecods.World()
    world.create_body(floor)
    met = world.cast(ball, [0, 0, -8])
    assert world.contact_point(ball, [0, 0, -8], met).point.tolist() == [1, 2.5, 1]
    with pytest.raises(ecods.NotSupported):
        ecods.contact_point(a, [10, 1, 0], b, ecods.cast(a, [10, 0, 0], b))


def times(s, v):
    return tuple(s * x for x in v)


def plus(p, q):
    return tuple(x + y for x, y in zip(p, q))


def closest_vector(a, b):
    """The shortest vector from triangle a to triangle b, from candidates of all pairs of features."""
    best = None
    for x, y, turn in ((a, b, 1), (b, a, -1)):
        for p in x:
            n = cross(sub(y[1], y[0]), sub(y[2], y[0]))
            candidates = []
            for i in range(3):
                d = sub(y[(i + 1) % 3], y[i])
                k = min(max(F(dot(sub(p, y[i]), d)) / dot(d, d), 0), 1)
                candidates.append(sub(plus(y[i], times(k, d)), p))
            if all(dot(cross(n, sub(y[(i + 1) % 3], y[i])), sub(p, y[i])) >= 0 for i in range(3)):
                candidates.append(times(F(dot(n, sub(y[0], p))) / dot(n, n), n))
            for v in candidates:
                v = times(turn, v)
                if best is None or dot(v, v) < dot(best, best):
                    best = v
    for i in range(3):
        for j in range(3):
            u, v = sub(a[(i + 1) % 3], a[i]), sub(b[(j + 1) % 3], b[j])
            n, w = cross(u, v), sub(b[j], a[i])
            if n == (0, 0, 0):
                continue
            nn = dot(n, n)
            s, t = F(dot(cross(w, v), n)) / nn, F(dot(cross(w, u), n)) / nn
            if 0 <= s <= 1 and 0 <= t <= 1:
                c = times(F(dot(w, n)) / nn, n)
                if dot(c, c) < dot(best, best):
                    best = c
    return best


def test_normals_are_limits_of_directions():
    draw = random.Random(3)
    kinds = set()
    found = 0
    while found < 60:
        offset = [draw.randint(-4, 4) for _ in range(3)]
        a = [tuple(draw.randint(-2, 2) for _ in range(3)) for _ in range(3)]
        b = [tuple(draw.randint(-2, 2) + o for o in offset) for _ in range(3)]
        m = tuple(draw.randint(-5, 5) for _ in range(3))
        if any(cross(sub(t[1], t[0]), sub(t[2], t[0])) == (0, 0, 0) for t in (a, b)) or m == (0, 0, 0):
            continue
        x, y = (ecods.Mesh(np.array(t, float), [[0, 1, 2]]) for t in (a, b))
        contact = ecods.cast(x, m, y)
        if contact is None or contact.time == 0:
            continue
        # The time is a quotient of small integers, so the nearest fraction with a small denominator is the real one.
        time = F(contact.time).limit_denominator(100000)
        result = ecods.contact_point(x, m, y, contact)
        h = F(1, 1 << 30)
        v = closest_vector([plus(p, times(time - h, m)) for p in a], b)
        n = np.array([float(c / h) for c in v])
        assert np.allclose(result.normal, n / np.linalg.norm(n), rtol=0, atol=1e-14)
        at_contact = [plus(p, times(time, m)) for p in a]
        point = tuple(F(float(c)) for c in result.point)
        for triangle in (at_contact, b):
            assert exact.squared_distance((point,) * 3, triangle) < F(1, 1 << 80)
        kinds.add(contact.kind)
        found += 1
    assert len(kinds) == 4
