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


class Convex(Trimesh):
    """A mesh of another library that says that it is convex."""
    is_convex = True


def around(half):
    """A cube around the origin."""
    return [tuple(2 * half * x - half for x in corner) for corner in box()[0]], box()[1]


def test_depths_of_convex_solids():
    made = ecods.CollisionManager()
    made.add_object("a", ecods.ConvexSolid(*box()))
    made.add_object("b", Convex(*box()), at(0.75))
    found, data = made.in_collision_internal(return_data=True)
    assert found and len(data) == 1 and data[0].depth == 0.25 and data[0].normal.tolist() == [1, 0, 0]
    assert data[0].point[0] == 0.875 and 0 <= data[0].index("a") < 12 and 0 <= data[0].index("b") < 12


def test_what_is_inside_a_convex_mesh_collides():
    made = ecods.CollisionManager()
    made.add_object("hall", Convex(*around(5)))
    inner = Convex(*around(0.5))
    assert made.in_collision_single(inner, at(1), return_names=True) == (True, {"hall"})
    distance, name, data = made.min_distance_single(inner, at(1), return_name=True, return_data=True)
    assert (distance, name) == (-4.5, "hall") and data.distance == -4.5
    assert data.index("hall") >= 0 and data.index("__external") >= 0
    assert (data.point("hall") - data.point("__external")).tolist() == [4.5, 0, 0]
    _, (contact,) = made.in_collision_single(inner, at(1), return_data=True)
    assert contact.depth == 4.5 and contact.normal.tolist() == [1, 0, 0] and contact.point[0] == 2.75


def test_cubes_at_one_place():
    """trimesh's tests expect this point: the first feature of each by name, and the face of triangle 0."""
    vertices, faces = around(0.5)
    faces[0] = faces[0][1:] + faces[0][:1]
    assert vertices[faces[0][0]] == (-0.5, -0.5, 0.5)
    cube = Convex(vertices, faces)
    made = ecods.CollisionManager()
    made.add_object("a", cube, at(5))
    _, (contact,) = made.in_collision_single(cube, at(5), return_data=True)
    assert contact.depth == 1 and contact.normal.tolist() == [-1, 0, 0] and contact.point.tolist() == [5, -0.5, 0.5]
    distance, data = made.min_distance_single(cube, at(5), return_data=True)
    assert distance == data.distance == -1
    assert data.point("a").tolist() == [4.5, -0.5, 0.5] and data.point("__external").tolist() == [5.5, -0.5, 0.5]


def test_a_surface_inside_a_solid():
    made = ecods.CollisionManager()
    made.add_object("hall", ecods.Solid(*around(5)))
    made.add_object("ring", around(0.5))
    _, (contact,) = made.in_collision_internal(return_data=True)
    assert math.isnan(contact.depth) and np.isnan(contact.normal).all() and contact.point.tolist() == [-0.5] * 3
    assert contact.index("hall") is None and contact.index("ring") == 0 and "'hall': no face" in repr(contact)
    assert made.min_distance_internal() == 0.0
    made.add_object("hall", Trimesh(*around(5)))
    assert made.in_collision_internal() is False and made.min_distance_internal() == 4.5


def test_signed_distances_are_least_first():
    made = ecods.CollisionManager()
    cube = Convex(*box())
    for name, x in (("a", 0), ("b", 0.75), ("c", 1.25), ("d", 2.25)):
        made.add_object(name, cube, at(x))
    made.add_object("surface", box(), at(2.5))
    assert made.min_distance_internal(return_names=True) == (-0.5, ("b", "c"))
    assert made.min_distance_internal("a", return_names=True) == (-0.25, ("a", "b"))
    assert made.min_distance_single(cube, at(1), return_name=True) == (-0.75, "b")
    other = ecods.CollisionManager()
    other.add_object("x", cube, at(-0.5))
    other.add_object("y", cube, at(2.5))
    assert made.min_distance_other(other, return_names=True) == (-0.75, ("d", "y"))
    touching = made.min_distance_single(cube, at(-1))
    assert touching == 0 and math.copysign(1, touching) == 1
    flat = np.diag([1.0, 1.0, 0.0, 1.0])
    assert made.min_distance_single(cube, flat) == 0 and made.in_collision_single(cube, flat) is True


def test_a_dent_by_rounding_is_filled():
    vertices, faces = np.array(around(0.5)[0]), around(0.5)[1]
    dented = vertices.copy()
    dented[0] += 2.0**-40
    with pytest.raises(ecods.NotSolid):
        ecods.ConvexSolid(dented, faces)
    made = ecods.CollisionManager()
    made.add_object("dented", Convex(dented, faces))
    made.add_object("open", Convex(vertices, faces[1:]), at(9))
    assert made.min_distance_single(Convex(*around(0.125))) == -0.625
    assert made.in_collision_single(Convex(*around(0.125)), at(9)) is False


def test_names_without_an_order():
    made = ecods.CollisionManager()
    made.add_object(1, box())
    made.add_object("one", box(), at(3))
    assert made.min_distance_internal(return_names=True) == (2.0, (1, "one"))
    assert made.min_distance_internal("one", return_names=True)[1] == (1, "one")
    made.set_transform("one", at(1))
    assert made.in_collision_internal(return_names=True) == (True, {(1, "one")})
