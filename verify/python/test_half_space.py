"""Half spaces in Python: their questions, worlds, copies, traces."""
import copy
import math
import pickle

import numpy as np
import pytest

import ecods
from scenes import at, mesh


def test_a_ground():
    ground = ecods.HalfSpace([0, 0, 2], 0)
    cube = mesh()
    assert ecods.intersects(cube, ground)
    assert ecods.distance(cube.at(at(0, 0, 5)), ground) == ecods.signed_distance(cube.at(at(0, 0, 5)), ground).distance == 5
    assert ecods.signed_distance(cube.at(at(0, 0, -5)), ground).distance == -5
    assert ecods.relation(cube, ground) == ecods.Relation.touching
    assert ecods.within(cube.at(at(0, 0, 5)), ground, 5) and not ecods.within(cube.at(at(0, 0, 5)), ground, 4.9)
    points = ecods.closest(cube.at(at(0, 0, 5)), ground.at(at(0, 0, 1)))
    assert points.distance == 4 and points.point_b[2] == 1
    assert ecods.cast(cube.at(at(0, 0, 5)), [0, 0, -8], ground).time == 0.625
    assert ground.box(at(0, 0, 1)).tolist() == [[-math.inf] * 3, [math.inf, math.inf, 1]]
    ball = ecods.sphere(1)
    assert ecods.signed_distance(ball.at(at(0, 0, 3)), ground).distance == 2
    assert ecods.relation(ball.at(at(0, 0, -1)), ground) == ecods.Relation.inside
    assert ecods.closest(ball.at(at(0, 0, 3)), ground).point_a.tolist() == [0, 0, 2]
    assert ecods.distance(ground, ecods.HalfSpace([0, 0, -1], -3)) == 3


def test_refusals():
    for normal, offset in (([0, 0, 0], 1), ([0, np.nan, 1], 1), ([0, 0, 1], np.inf)):
        with pytest.raises(ecods.InvalidArgument) as refused:
            ecods.HalfSpace(normal, offset)
        assert refused.value.argument == ecods.Argument.half_space
    with pytest.raises(ecods.SingularPose):
        ecods.distance(mesh(), ecods.HalfSpace([0, 0, 1], 0).at(np.diag([1, 1, 0, 1])))
    with pytest.raises(TypeError, match="HalfSpace"):
        ecods.signed_distance(mesh(), 3)


def test_worlds_copies_and_traces(tmp_path):
    world = ecods.World()
    ground = ecods.HalfSpace([0, 0, 1], 0)
    floor = world.create_body(ground)
    cube = world.create_body(mesh(), at(0, 0, 3))
    ball = world.create_body(ecods.sphere(1), at(5, 0, 1))
    world.update()
    assert world.distance(cube, floor) == 3 and world.distance(ground.at(at(0, 0, 1)), cube) == 2
    assert world.relation(ball, floor) == ecods.Relation.touching
    assert world.shape(floor) is ground and isinstance(world.posed(floor), ecods.PosedHalfSpace)
    other = copy.deepcopy(world)
    assert other.distance(cube, floor) == 3
    again = pickle.loads(pickle.dumps(ground.at(at(1))))
    assert again.shape.normal.tolist() == [0, 0, 1] and copy.copy(ground) is ground
    assert "HalfSpace" in repr(ground) and "PosedHalfSpace" in repr(again)
