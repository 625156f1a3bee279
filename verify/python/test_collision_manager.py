"""The calls of trimesh's collision manager, on a class of the shape of its meshes."""
import math

import numpy as np
import pytest

import ecods
from scenes import Trimesh, at, box


@pytest.fixture
def manager():
    made = ecods.CollisionManager()
    made.add_object("b", Trimesh(*box()))
    made.add_object("a", box(), at(0.5))
    made.add_object("far", ecods.Mesh(*box()), at(10))
    return made


def test_single(manager):
    cube = Trimesh(*box())
    assert manager.in_collision_single(cube) is True
    assert manager.in_collision_single(cube, at(5)) is False
    assert manager.in_collision_single(cube, at(11), return_names=True) == (True, {"far"})
    found, names, data = manager.in_collision_single(cube, at(11), return_names=True, return_data=True)
    assert found and data and data[0].names == {"far", "__external"}
    assert 0 <= data[0].index("far") < 12 and data[0].point[0] == 11 and data[0].normal.shape == (3,)
    assert math.isnan(data[0].depth)
    assert manager.in_collision_single(cube, at(5), return_data=True) == (False, [])


def test_internal(manager):
    assert manager.in_collision_internal(return_names=True) == (True, {("a", "b")})
    manager.set_transform("a", at(5))
    assert manager.in_collision_internal() is False
    manager.remove_object("a")
    manager.add_object("b", box(), at(9.5))
    found, names, data = manager.in_collision_internal(True, True)
    assert names == {("b", "far")} and all(each.names == {"b", "far"} for each in data)
    for call in (lambda: manager.remove_object("a"), lambda: manager.set_transform("a", np.eye(4))):
        with pytest.raises(ValueError):
            call()


def test_other(manager):
    other = ecods.CollisionManager()
    assert manager.in_collision_other(other, return_names=True) == (False, set())
    assert manager.min_distance_other(other) == math.inf
    other.add_object("x", Trimesh(*box()), at(10.5))
    assert manager.in_collision_other(other, return_names=True) == (True, {("far", "x")})
    assert manager.in_collision_other(other, return_data=True)[1][0].index("x") >= 0
    other.set_transform("x", at(8))
    distance, names, data = manager.min_distance_other(other, return_names=True, return_data=True)
    assert (distance, names) == (1.0, ("far", "x")) and data.distance == 1.0
    assert data.point("far")[0] == 10 and data.point("x")[0] == 9 and data.index("x") >= 0


def test_distances(manager):
    cube = Trimesh(*box())
    assert manager.min_distance_single(cube, at(3.5)) == 2.0
    assert manager.min_distance_single(cube, at(8), return_name=True) == (1.0, "far")
    distance, name, data = manager.min_distance_single(cube, at(8), return_name=True, return_data=True)
    assert data.names == {"far", "__external"} and data.point("__external")[0] == 9 and data.distance == distance
    assert manager.min_distance_internal() == 0.0
    assert manager.min_distance_internal("far", return_names=True) == (8.5, ("a", "far"))
    manager.remove_object("b")
    distance, names, data = manager.min_distance_internal(return_names=True, return_data=True)
    assert (distance, names) == (8.5, ("a", "far")) and data.point("a")[0] == 1.5 and data.point("far")[0] == 10
    assert ecods.CollisionManager().min_distance_single(cube) == math.inf
    assert ecods.CollisionManager().min_distance_internal(return_names=True) == (math.inf, None)


def test_depths_of_convex_solids():
    made = ecods.CollisionManager()
    made.add_object("a", ecods.ConvexSolid(*box()))
    made.add_object("b", ecods.ConvexSolid(*box()), at(0.75))
    _, data = made.in_collision_internal(return_data=True)
    assert {each.depth for each in data} == {0.25} and data[0].normal.tolist() == [1, 0, 0]


def test_names_without_an_order():
    made = ecods.CollisionManager()
    made.add_object(1, box())
    made.add_object("one", box(), at(3))
    assert made.min_distance_internal(return_names=True) == (2.0, (1, "one"))
    assert made.min_distance_internal("one", return_names=True)[1] == (1, "one")
    made.set_transform("one", at(1))
    assert made.in_collision_internal(return_names=True) == (True, {(1, "one")})
