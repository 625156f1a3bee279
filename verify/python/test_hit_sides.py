"""Normals and sides of hits, parts of lines inside solids, all hits of many rays."""
import pickle

import numpy as np
import pytest

import ecods
from scenes import box


def wall():
    vertices, faces = box(4, 1, 4)
    return ecods.Solid(vertices, faces)


def test_a_wall():
    solid = wall()
    line = ecods.Segment([1, -1, 2], [1, 3, 2])
    enters, leaves = ecods.sided_hits(line, solid)
    assert enters.passage == ecods.Passage.enters and leaves.passage == ecods.Passage.leaves
    assert enters.before == ecods.Side.outside and enters.after == ecods.Side.inside
    assert enters.normal.tolist() == [0, -1, 0] and leaves.normal.tolist() == [0, 1, 0]
    assert ecods.hit_normal(line, solid, ecods.first_hit(line, solid)).tolist() == [0, -1, 0]
    part, = ecods.inside_parts(line, solid)
    assert (part.from_parameter, part.to_parameter) == (0.25, 0.5)
    assert part.begin == part.end == ecods.PartEnd.crosses and part.to_point.tolist() == [1, 1, 2]
    assert pickle.loads(pickle.dumps(part)) == part and pickle.loads(pickle.dumps(enters)) == enters
    begins = ecods.sided_hits(ecods.Ray([1, 0.5, 2], [0, 1, 0]), solid)[0]
    assert begins.passage == ecods.Passage.begins and begins.normal is None
    assert ecods.inside_parts(ecods.Ray([0, 0, 0], [0, 0, 1]), solid) == []
    with pytest.raises(TypeError):
        ecods.inside_parts(line, ecods.Mesh(*box(1, 1, 1)))


def test_a_world():
    world = ecods.World()
    bodies = [world.create_body(wall(), np.array([[1, 0, 0, 0], [0, 1, 0, y], [0, 0, 1, 0], [0, 0, 0, 1.0]]))
              for y in (3, 0)]
    line = ecods.Segment([1, -1, 2], [1, 7, 2])
    hits = world.sided_hits(line)
    assert [hit.body for hit in hits] == [bodies[1]] * 2 + [bodies[0]] * 2
    assert [hit.sided.passage == ecods.Passage.enters for hit in hits] == [True, False] * 2
    assert [(part.body, part.part.from_parameter) for part in world.inside_parts(line)] == [
        (bodies[1], 0.125), (bodies[0], 0.5)]
    assert world.inside_parts(ecods.Ray([1, -1, 2], [0, 1, 0], 0.5), filter=ecods.CollisionFilter(1, 1)) == []
    world.create_body(ecods.sphere(1))
    with pytest.raises(ecods.NotSupported):
        world.sided_hits(line)


def test_all_hits_of_many_rays():
    solid = wall()
    origins = np.array([[1, -1, 2.5], [1, 0.5, 2.5], [9, 9, 9.0]])
    first, parameters, triangles = ecods.all_hits_many(origins, [[0, 1, 0]] * 3, solid)
    for i, origin in enumerate(origins):
        hits = ecods.all_hits(ecods.Ray(origin, [0, 1, 0]), solid)
        assert parameters[first[i]:first[i + 1]].tolist() == [hit.parameter for hit in hits]
        assert triangles[first[i]:first[i + 1]].tolist() == [
            -1 if hit.kind == ecods.HitKind.inside else hit.triangle for hit in hits]
    with pytest.raises(ecods.InvalidArgument) as error:
        ecods.all_hits_many(origins, [[0, 1, 0], [0, 0, 0], [0, 1, 0]], solid)
    assert error.value.index == 1
