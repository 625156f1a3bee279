"""Deforming meshes, and casts to a distance."""
import numpy as np
import pytest

import ecods


def sheet(height=3.0):
    return ecods.Mesh([[0, 0, height], [1, 0, height], [1, 1, height], [0, 1, height]], [[0, 1, 2], [0, 2, 3]])


def unit_cube():
    return ecods.ConvexSolid.hull([[i & 1, i >> 1 & 1, i >> 2 & 1] for i in range(8)])


def cube(*corner):
    pose = np.eye(4)
    pose[:3, 3] = corner or (0, 0, 0)
    return unit_cube().at(pose)


def test_a_sheet_falls_on_a_cube():
    falls = ecods.Deforming(sheet(), sheet(-1).vertices)
    for contact in (ecods.cast(falls, cube()), ecods.cast(cube(), falls), ecods.cast(falls, sheet(1).moving(None, None)),
                    ecods.cast(sheet(1).moving(None, None), falls)):
        assert contact.time == 0.5
    assert ecods.cast(falls, cube()).time == 0.5
    assert ecods.cast(falls, cube(), max_time=0.25) is None
    assert ecods.cast(falls, cube(), witness=ecods.Witness()).time == 0.5
    rises = ecods.Deforming(sheet(-1), sheet(3).vertices)
    assert ecods.cast(falls, rises).time == 0.5
    assert falls.vertices.tolist() == sheet(-1).vertices.tolist()
    assert falls.mesh.digest == sheet().digest
    assert falls.box.tolist() == [[0, 0, -1], [1, 1, 3]]
    world = ecods.World()
    body = world.create_body(unit_cube())
    assert world.cast(falls).body == body and world.cast(falls).contact.time == 0.5
    assert world.cast(falls, max_time=0.25) is None
    with pytest.raises(ecods.InvalidMesh):
        ecods.Deforming(sheet(), [[0, 0, 0]])
    with pytest.raises(ecods.InvalidMesh):
        ecods.Deforming(sheet(), np.full((4, 3), np.nan))
    with pytest.raises(ecods.InvalidArgument):
        ecods.cast(falls, cube(), -1)


def test_cast_to_distance():
    assert ecods.cast_to_distance(cube(0, 0, 5), [0, 0, -8], cube(), 2).time == 0.25
    assert ecods.cast_to_distance(cube(0, 0, 5), [0, 0, -8], cube(), 0).time == 0.5
    assert ecods.cast_to_distance(cube(0, 0, 5), [0, 0, -1], cube(), 2) is None
    ball = ecods.sphere(1).at(np.eye(4))
    assert ecods.cast_to_distance(ball, [0, 0, 0], cube(5, 0, 0), 4).time == 0
    assert ecods.cast_to_distance(cube(5, 0, 0), [-4, 0, 0], ball, 2).time == 0.5
    assert ecods.cast_to_distance(ball, [3, 0, 0], ecods.sphere(1).at([[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0]]), 1.5).time == 0.5
    for distance in (-1, np.inf, np.nan):
        with pytest.raises(ecods.InvalidArgument):
            ecods.cast_to_distance(cube(), [1, 0, 0], cube(5, 0, 0), distance)


def test_entering_up_to_a_time():
    fall = cube(0, 0, 2), [0, 0, -2], cube()
    assert ecods.entering(*fall).time == 0.5
    assert ecods.entering(*fall, max_time=0.5) is None
