"""Answers beside rationals: whatever hypothesis draws, from lattices full of contacts to any finite doubles."""
from fractions import Fraction

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import ecods
import exact

small = st.integers(-3, 3).map(float)
wild = st.floats(-1e100, 1e100, allow_subnormal=True)
numbers = st.one_of(small, small, st.floats(-2, 2), wild)


def points(count, coordinates):
    return st.lists(st.tuples(coordinates, coordinates, coordinates), min_size=count, max_size=count)


@st.composite
def bodies(draw):
    coordinates = draw(st.sampled_from([small, small, st.floats(-2, 2), numbers]))
    vertices = draw(points(draw(st.integers(3, 5)), coordinates))
    index = st.integers(0, len(vertices) - 1)
    faces = draw(st.lists(st.tuples(index, index, index), min_size=1, max_size=3))
    rows = [draw(st.tuples(*[draw(st.sampled_from([small, st.floats(-2, 2)]))] * 4)) for _ in range(3)]
    identity = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]
    return vertices, faces, draw(st.sampled_from([identity, rows]))


def given_body(body):
    vertices, faces, pose = body
    return ecods.Mesh(vertices, faces).at(pose), exact.triangles(vertices, faces, pose)


@settings(max_examples=120, deadline=None)
@given(bodies(), bodies())
def test_distance_is_the_true_one_rounded(a, b):
    x, triangles_a = given_body(a)
    y, triangles_b = given_body(b)
    square = exact.least_squared_distance(triangles_a, triangles_b)
    d = ecods.distance(x, y)
    assert exact.is_rounded_root(d, square)
    assert ecods.distance(y, x) == d
    assert ecods.closest(x, y).distance == d
    assert ecods.intersects(x, y) == (square == 0)
    assert (ecods.relation(x, y) == ecods.Relation.apart) == (square > 0)
    for limit in (d, np.nextafter(d, 0), np.nextafter(d, np.inf)):
        assert ecods.within(x, y, limit) == (square <= Fraction(float(limit)) ** 2)
    assert exact.is_inside_interval(ecods.distance_bounds(x, y, relative=0.01), square)
    expected = [(i, j) for i, p in enumerate(triangles_a) for j, q in enumerate(triangles_b)
                if exact.squared_distance(p, q) == 0]
    assert [tuple(pair) for pair in ecods.intersecting_triangles(x, y)] == expected


@settings(max_examples=100, deadline=None)
@given(points(4, numbers))
def test_orient3d_is_the_sign(p):
    expected = exact.orient3d(*[tuple(Fraction(x) for x in q) for q in p])
    assert ecods.orient3d(*p) == expected
    assert ecods.orient3d(*[np.array([q, q]) for q in p]).tolist() == [expected] * 2


@settings(max_examples=60, deadline=None)
@given(bodies(), bodies(), st.data())
def test_posed_predicates(a, b, data):
    def draw():
        vertices, _, pose = data.draw(st.sampled_from([a, b]))
        return data.draw(st.sampled_from(vertices)), pose

    drawn = [draw() for _ in range(4)]
    poses = [np.vstack([pose, [0, 0, 0, 1]]) for _, pose in drawn]
    expected = exact.orient3d(*[exact.posed(pose, v) for v, pose in drawn])
    assert ecods.orient3d(*[v for v, _ in drawn], poses=poses) == expected
    x, y = given_body(a)[1][0], given_body(b)[1][0]
    relation = ecods.triangle_triangle(
        *[[body[0][i] for i in body[1][0]] for body in (a, b)],
        poses=[np.vstack([body[2], [0, 0, 0, 1]]) for body in (a, b)])
    assert (relation == ecods.Relation.apart) == (exact.squared_distance(x, y) > 0)


@settings(max_examples=40, deadline=None)
@given(bodies(), st.lists(bodies(), min_size=1, max_size=4))
def test_a_world_has_the_pairs(first, rest):
    world = ecods.World()
    made = [given_body(body) for body in [first, *rest]]
    ids = [world.create_body(x.mesh, x.pose) for x, _ in made]
    world.update()
    expected = [(ids[i], ids[j]) for i in range(len(ids)) for j in range(i + 1, len(ids))
                if exact.least_squared_distance(made[i][1], made[j][1]) == 0]
    assert [tuple(pair) for pair in world.colliding_pairs()] == expected
    world.check_invariants()


@settings(max_examples=60, deadline=None)
@given(bodies(), points(2, small))
def test_a_hit_is_where_the_surface_is(body, ends):
    x, triangles = given_body(body)
    hits = ecods.all_hits(ecods.Segment(*ends), x)
    line = tuple(tuple(Fraction(c) for c in end) for end in (ends[0], ends[1], ends[1]))
    expected = [i for i, triangle in enumerate(triangles) if exact.squared_distance(line, triangle) == 0]
    assert sorted(hit.triangle for hit in hits) == expected
    first = ecods.first_hit(ecods.Segment(*ends), x)
    assert (first is None) == (not hits) and (not hits or first == hits[0])
