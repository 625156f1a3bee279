"""The calls of python-fcl about two objects: known answers, order of arguments, bad input."""
import importlib
import itertools
import math
import sys
from fractions import Fraction

import numpy as np
import pytest

import ecods
import ecods.compat.fcl as fcl
from fcl_shapes import GEOMETRIES, GROUNDS, SOLIDS, contacts, cube_mesh, measured, thing
from scenes import turned

PAIRS = [*itertools.product(GEOMETRIES, GEOMETRIES), *itertools.product(GROUNDS, GEOMETRIES)]
ALL = {**GEOMETRIES, **GROUNDS}


@pytest.mark.parametrize("lower, upper", PAIRS)
def test_all_pairs_apart_touching_and_deep(lower, upper):
    below, above = thing(ALL[lower]), thing(ALL[upper], z=3)
    assert contacts(below, above) == [] == contacts(above, below)
    for is_signed in (False, True):
        found, swapped = measured(below, above, is_signed), measured(above, below, is_signed)
        assert found.min_distance == swapped.min_distance == 2
        assert [point[2] for point in found.nearest_points] == [0.5, 2.5]
        assert [point[2] for point in swapped.nearest_points] == [2.5, 0.5]
        assert (found.b1 >= 0, found.b2 >= 0) == (lower == "mesh", upper == "mesh") == (swapped.b2 >= 0, swapped.b1 >= 0)
    above.setTranslation([0, 0, 1])
    assert contacts(below, above) and contacts(above, below)
    assert measured(below, above, False).min_distance == measured(above, below, False).min_distance == 0
    above.setTranslation([0, 0, 0.75])
    assert contacts(below, above) and contacts(above, below)
    deep = 0 if (lower, upper) in (("mesh", "mesh"), ("triangle", "triangle")) else -1
    assert measured(below, above, False).min_distance == measured(above, below, False).min_distance == deep
    if "mesh" not in (lower, upper):
        assert -0.25 <= measured(below, above).min_distance <= 0


@pytest.mark.parametrize("lower, upper", [*itertools.product(("box", "sphere", "convex", "ball"), repeat=2),
                                          *itertools.product(GROUNDS, SOLIDS)])
def test_depths_points_and_normals(lower, upper):
    below, above = thing(ALL[lower]), thing(ALL[upper], z=0.9375)
    for o1, o2, normal in ((below, above, [0, 0, 1]), (above, below, [0, 0, -1])):
        (contact,) = contacts(o1, o2)
        assert contact.o1 is o1._geometry and contact.o2 is o2._geometry and (contact.b1, contact.b2) == (-1, -1)
        assert contact.penetration_depth == 0.0625 and contact.normal.tolist() == normal and contact.pos[2] == 0.46875
        found = measured(o1, o2)
        assert found.min_distance == -0.0625
        first, second = (0.5, 0.4375) if o1 is below else (0.4375, 0.5)
        assert [point[2] for point in found.nearest_points] == [first, second]
    above.setTranslation([0, 0, 1])
    (contact,) = contacts(below, above)
    assert contact.penetration_depth == 0 and math.copysign(1, contact.penetration_depth) == 1 and contact.pos[2] == 0.5


def test_a_result_without_contact_data():
    (contact,) = contacts(thing(GEOMETRIES["box"]), thing(GEOMETRIES["box"], z=0.5), enable_contact=False)
    assert contact.penetration_depth == 0 and not contact.normal.any() and not contact.pos.any()
    assert "b1=-1" in repr(contact)


def test_results_accumulate():
    result, near, far = fcl.CollisionResult(), thing(GEOMETRIES["box"], x=0.5), thing(GEOMETRIES["box"], x=3)
    cube = thing(GEOMETRIES["box"])
    assert [fcl.collide(cube, other, None, result) for other in (far, near, near, far)] == [0, 1, 1, 0]
    assert result.is_collision and len(result.contacts) == 2
    assert fcl.collide(cube, near) == 1 and fcl.distance(cube, far) == 2
    least = fcl.DistanceResult()
    assert [fcl.distance(cube, other, result=least) for other in (far, thing(GEOMETRIES["sphere"], x=2), far)] == [2, 1, 2]
    assert least.min_distance == 1 and least.o2 is GEOMETRIES["sphere"] and least.nearest_points == [None, None]


def test_triangles_of_meshes():
    mesh, cube = thing(GEOMETRIES["mesh"]), thing(GEOMETRIES["box"], x=0.75)
    faces = [each.b1 for each in contacts(mesh, cube)]
    assert faces == sorted(faces) and [each.b2 for each in contacts(cube, mesh)] == faces
    assert {each.b2 for each in contacts(mesh, cube)} == {-1}
    expected = [i for i in range(12) if ecods.intersects(
        ecods.Mesh(mesh._geometry.shape.vertices, mesh._geometry.shape.faces[i:i + 1]), cube._geometry.shape.at(cube._pose))]
    assert faces == expected and len(contacts(mesh, cube, limit=2)) == 2
    other = thing(GEOMETRIES["mesh"], x=0.75)
    pairs = ecods.intersecting_triangles(mesh._geometry.shape, other._geometry.shape.at(other._pose)).tolist()
    assert [[each.b1, each.b2] for each in contacts(mesh, other)] == pairs
    assert [[each.b1, each.b2] for each in contacts(mesh, other, limit=1)][0] in pairs
    found = measured(mesh, thing(GEOMETRIES["mesh"], x=3))
    assert found.min_distance == 2 and found.b1 >= 0 and found.b2 >= 0


def test_a_mesh_is_hollow_and_a_solid_is_not():
    small = fcl.BVHModel()
    small.beginModel()
    small.addTriangle([0, 0, 0], [0.1, 0, 0], [0, 0.1, 0])
    small.endModel()
    assert [each.b1 for each in contacts(thing(small), thing(GEOMETRIES["box"]))] == [0]
    assert contacts(thing(small), thing(GEOMETRIES["box"]), limit=1)[0].b1 == 0
    assert contacts(thing(small), thing(GEOMETRIES["mesh"])) == []
    assert contacts(thing(fcl.Sphere(0.25)), thing(GEOMETRIES["mesh"])) == []
    assert measured(thing(fcl.Sphere(0.25)), thing(GEOMETRIES["mesh"])).min_distance == 0.25


def test_depths_of_triangles():
    mesh = thing(GEOMETRIES["mesh"])
    ball = thing(GEOMETRIES["sphere"], z=0.875)
    found = contacts(ball, mesh)
    assert {each.penetration_depth for each in found} >= {0.125} and max(each.penetration_depth for each in found) == 0.125
    deepest = measured(ball, mesh)
    assert deepest.min_distance == -0.125 and deepest.b2 in [each.b2 for each in found]
    assert [point[2] for point in deepest.nearest_points] == [0.375, 0.5]
    triangle = thing(GEOMETRIES["triangle"], z=0.875)
    (contact,) = contacts(thing(GEOMETRIES["box"]), triangle)
    assert contact.penetration_depth == 0.125 and contact.normal.tolist() == [0, 0, 1]
    crossing = contacts(mesh, thing(GEOMETRIES["mesh"], x=0.75))
    assert all(each.penetration_depth >= 0 and abs(np.linalg.norm(each.normal) - 1) < 1e-15 for each in crossing)


def test_a_plane_between_the_parts_of_a_mesh_meets_neither():
    model = fcl.BVHModel()
    model.beginModel()
    for x in (-3, 3):
        model.addSubModel(cube_mesh(x).shape.vertices, cube_mesh(x).shape.faces)
    model.addVertex(0, 0, 0)
    model.endModel()
    wall = fcl.Plane([2, 0, 0], 1)
    assert model.num_tries_() == 24 and contacts(thing(model), thing(wall)) == []
    found = measured(thing(wall), thing(model))
    assert found.min_distance == 2 and found.b2 >= 0 and [point[0] for point in found.nearest_points] == [0.5, 2.5]
    (contact,) = contacts(thing(model), thing(wall, x=2.25))
    assert contact.penetration_depth == 0.25 and contact.normal.tolist() == [-1, 0, 0] and contact.b1 >= 0
    assert fcl.continuousCollide(thing(model), fcl.Transform([4, 0, 0]), thing(wall), fcl.Transform()) == 0.75
    assert fcl.continuousCollide(thing(model), fcl.Transform([1, 0, 0]), thing(wall), fcl.Transform()) == 1
    cloud = fcl.BVHModel()
    cloud.beginModel()
    cloud.addSubModel([[0, 0, 0], [1, 0, 0]], [])
    cloud.endModel()
    assert cloud.num_tries_() == 0 and contacts(thing(cloud), thing(wall)) == []
    assert measured(thing(cloud), thing(wall)).min_distance == 0.5


def test_half_spaces_and_planes():
    ground, roof = fcl.Halfspace([0, 0, 1], 0), fcl.Halfspace([0, 0, -1], -2)
    floor, wall = fcl.Plane([0, 0, 1], 1), fcl.Plane([1, 0, 0], 0)
    assert contacts(thing(ground), thing(roof)) == [] and measured(thing(ground), thing(roof)).min_distance == 2
    assert measured(thing(ground), thing(floor)).min_distance == measured(thing(floor), thing(roof)).min_distance == 1
    assert measured(thing(floor), thing(floor, z=3)).min_distance == 3
    assert measured(thing(floor), thing(floor)).min_distance == 0 == measured(thing(ground), thing(roof, z=-2)).min_distance
    assert measured(thing(floor), thing(wall)).min_distance == measured(thing(ground), thing(wall)).min_distance == -1
    assert measured(thing(ground), thing(ground, z=5)).nearest_points == [None, None]
    (contact,) = contacts(thing(ground), thing(wall))
    assert math.isnan(contact.penetration_depth) and np.isnan(contact.normal).all() and np.isnan(contact.pos).all()
    assert ground.n.tolist() == [0, 0, 1] and ground.d == 0
    ground.d = 3
    assert contacts(thing(ground), thing(roof))


def test_continuous_collisions():
    cube, other = thing(GEOMETRIES["box"]), thing(GEOMETRIES["box"], x=5)
    result = fcl.ContinuousCollisionResult()
    assert fcl.continuousCollide(cube, fcl.Transform([5, 0, 0]), other, fcl.Transform([5, 0, 0]), None, result) == 0.8
    assert result.is_collide and result.time_of_contact == 0.8
    assert fcl.continuousCollide(cube, fcl.Transform([5, 0, 0]), other, fcl.Transform(), result=result) == 0.4
    assert fcl.continuousCollide(cube, fcl.Transform(), other, fcl.Transform([2, 0, 0]), result=result) == 1
    assert result.is_collide and result.time_of_contact == 0.4
    missed = fcl.ContinuousCollisionResult()
    assert fcl.continuousCollide(cube, fcl.Transform(), other, fcl.Transform([2, 0, 0]), result=missed) == 1
    assert not missed.is_collide and missed.time_of_contact == 1
    assert fcl.continuousCollide(cube, fcl.Transform([9, 0, 0]), cube, fcl.Transform()) == 0
    ground, wall = thing(fcl.Halfspace([0, 0, 1], -1.5)), thing(fcl.Plane([0, 0, 1], -1.5))
    for lower in (ground, wall):
        assert fcl.continuousCollide(cube, fcl.Transform([0, 0, -1]), lower, fcl.Transform([0, 0, 1])) == 0.5
        assert fcl.continuousCollide(lower, fcl.Transform([0, 0, 2]), cube, fcl.Transform()) == 0.5
        assert fcl.continuousCollide(lower, fcl.Transform([0, 0, -9]), cube, fcl.Transform()) == 1
    last = fcl.ContinuousCollisionResult()
    high = thing(GEOMETRIES["box"], z=3)
    assert fcl.continuousCollide(wall, fcl.Transform([0, 0, 4]), high, fcl.Transform([0, 0, 3]), result=last) == 1
    assert last.is_collide
    needle = thing(GEOMETRIES["triangle"])
    assert fcl.continuousCollide(needle, fcl.Transform([5, 0, 0]), other, fcl.Transform([5, 0, 0])) == 0.85
    sheet = thing(fcl.Plane([0, 0, 1], 0))
    assert fcl.continuousCollide(ground, fcl.Transform([0, 0, 2]), sheet, fcl.Transform()) == 0.75


def test_continuous_collisions_of_spheres():
    ball, other = thing(GEOMETRIES["sphere"]), thing(GEOMETRIES["box"], x=5)
    assert fcl.continuousCollide(ball, fcl.Transform([8, 0, 0]), other, fcl.Transform([5, 0, 0])) == 0.5
    assert fcl.continuousCollide(other, fcl.Transform([1, 0, 0]), ball, fcl.Transform([4, 0, 0])) == 0.5
    assert fcl.continuousCollide(ball, fcl.Transform(), other, fcl.Transform([5, 0, 0])) == 1
    for ground in (thing(fcl.Halfspace([1, 0, 0], -2)), thing(fcl.Plane([1, 0, 0], -2))):
        assert fcl.continuousCollide(ground, fcl.Transform([3, 0, 0]), ball, fcl.Transform()) == 0.5
        assert fcl.continuousCollide(ball, fcl.Transform([-1.5, 0, 0]), ground, fcl.Transform()) == 1


def test_motions_that_turn():
    cube, other = thing(GEOMETRIES["box"]), thing(GEOMETRIES["box"], x=5)
    end = fcl.Transform(turned(1, (0, 0, 0))[:3, :3], [5, 0, 0])
    stay = fcl.Transform([5, 0, 0])
    assert fcl.continuousCollide(cube, end, other, stay) == 0.8
    for motion in (fcl.CCDMotionType.CCDM_LINEAR, fcl.CCDMotionType.CCDM_SCREW):
        request = fcl.ContinuousCollisionRequest(ccd_motion_type=motion)
        assert fcl.continuousCollide(cube, stay, other, stay, request) == 0.8
        with pytest.raises(NotImplementedError, match=motion.name):
            fcl.continuousCollide(cube, end, other, stay, request)
    with pytest.raises(NotImplementedError, match="CCDM_SPLINE"):
        fcl.continuousCollide(cube, stay, other, stay, fcl.ContinuousCollisionRequest(ccd_motion_type=3))


def test_bad_arguments():
    cube = thing(GEOMETRIES["box"])
    for call in (fcl.collide, fcl.distance):
        with pytest.raises(TypeError, match="argument o2 is None; a CollisionObject is expected"):
            call(cube, None)
        with pytest.raises(TypeError, match="argument o1 is a Box; a CollisionObject"):
            call(GEOMETRIES["box"], cube)
    with pytest.raises(TypeError, match="argument tf2_end is a numpy array"):
        fcl.continuousCollide(cube, fcl.Transform(), cube, np.eye(4))
    for count in (0, -1, 1.5, "one"):
        with pytest.raises(ValueError, match="num_max_contacts"):
            fcl.collide(cube, cube, fcl.CollisionRequest(num_max_contacts=count))
    with pytest.raises(NotImplementedError, match="enable_cost"):
        fcl.collide(cube, cube, fcl.CollisionRequest(enable_cost=True))


def test_the_boxes_of_triangles_are_rounded_outwards():
    """A corner is in a box as a real point, and beyond a face as its product is rounded before most of it cancels."""
    random = np.random.default_rng(7)
    beyond = []
    for r, v in random.uniform(0.5, 1, (200, 2)) * [1, 2.0**20]:
        t = 0.0625 - r * v
        real = Fraction(r) * Fraction(v) + Fraction(t)
        if real < Fraction(r * v + t):
            beyond.append((r, v, t, float((real + Fraction(r * v + t)) / 2)))
    assert len(beyond) > 50
    for r, v, t, x in beyond:
        model = fcl.BVHModel()
        model.beginModel()
        model.addTriangle([v, 0, 0], [v + 1, 0, 0], [v + 1, 1, 0])
        model.endModel()
        placed = fcl.CollisionObject(model, fcl.Transform(np.diag([r, 1.0, 1.0]), [t, 0, 0]))
        assert len(contacts(placed, thing(fcl.Box(2 * x, 1, 1)))) == 1
    with np.errstate(all="raise"):
        model = fcl.BVHModel()
        model.beginModel()
        model.addTriangle([-1.5, -1.5, 0], [1.5, -1.5, 0], [0, 1.5, 0])
        model.endModel()
        huge = fcl.CollisionObject(model, fcl.Transform(np.diag([1.7e308] * 3)))
        assert len(contacts(huge, thing(GEOMETRIES["box"]), enable_contact=False)) == 1


def test_triangles_of_turned_meshes_are_those_that_meet():
    random = np.random.default_rng(3)
    mesh = GEOMETRIES["mesh"]
    for solid in ("box", "sphere", "capsule", "cone", "triangle"):
        for _ in range(20):
            rotation = turned(random.uniform(0, 7), (0, 0, 0))[:3, :3]
            o1 = fcl.CollisionObject(mesh, fcl.Transform(rotation, random.normal(size=3) / 2))
            o2 = thing(SOLIDS[solid], *random.normal(size=3) / 2)
            expected = [i for i in range(12) if ecods.intersects(
                ecods.Mesh(mesh.shape.vertices, mesh.shape.faces[i:i + 1]).at(o1._pose), o2._geometry.shape.at(o2._pose))]
            assert [each.b1 for each in contacts(o1, o2)] == expected


def test_a_program_that_imports_fcl(monkeypatch):
    monkeypatch.setitem(sys.modules, "fcl", fcl)
    module = importlib.import_module("fcl")
    assert module.collide is fcl.collide and set(module.__all__) <= set(dir(module)) and module.__version__ == ecods.__version__


def test_triangles_of_meshes_at_planes_and_half_spaces():
    model = fcl.BVHModel()
    model.beginModel()
    model.addTriangle([0, 0, 5], [1, 0, 5], [0, 1, 5])
    model.addTriangle([0, 0, -1], [1, 0, 2], [0, 1, 2])
    model.endModel()
    mesh, plane, ground = thing(model), thing(fcl.Plane([0, 0, 1], 0)), thing(fcl.Halfspace([0, 0, 1], 0))
    for lower in (plane, ground):
        for has_contact in (True, False):
            result = fcl.CollisionResult()
            assert fcl.collide(mesh, lower, fcl.CollisionRequest(2**64 - 1, has_contact), result) == 1
            assert (result.contacts[0].b1, result.contacts[0].b2) == (1, -1)
            turned = fcl.CollisionResult()
            assert fcl.collide(lower, mesh, fcl.CollisionRequest(10, has_contact), turned) == 1
            assert (turned.contacts[0].b1, turned.contacts[0].b2) == (-1, 1)
    far = fcl.DistanceResult()
    assert fcl.distance(thing(model, z=3), plane, fcl.DistanceRequest(), far) == 2
    assert (far.b1, far.b2) == (1, -1)


def test_a_manager_takes_all_objects_or_none():
    manager, model = fcl.DynamicAABBTreeCollisionManager(), fcl.BVHModel()
    model.beginModel()
    with pytest.raises(ValueError):
        manager.registerObjects([thing(fcl.Box(1, 1, 1)), fcl.CollisionObject(model)])
    assert manager.size() == 0
