"""The transforms, objects and geometries of ecods.compat.fcl: what they take, keep and refuse."""
import math

import numpy as np
import pytest

import ecods
import ecods.compat.fcl as fcl
from fcl_shapes import GEOMETRIES, measured, polygons, thing
from scenes import box


def test_transforms():
    quarter, moved = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]), [1.0, 2.0, 3.0]
    half = [math.sqrt(0.5), 0, 0, math.sqrt(0.5)]
    assert fcl.Transform().getRotation().tolist() == np.eye(3).tolist() and not fcl.Transform().getTranslation().any()
    assert fcl.Transform(quarter).getRotation().tolist() == quarter.tolist()
    assert fcl.Transform(moved).getTranslation().tolist() == moved
    assert np.allclose(fcl.Transform(half).getRotation(), quarter, atol=1e-15)
    both = fcl.Transform(half, np.array([moved]))
    copy = fcl.Transform(both)
    copy.setTranslation([0, 0, 0])
    assert both.getTranslation().tolist() == moved and np.allclose(both.getQuatRotation(), half)
    copy.setRotation(np.eye(3))
    copy.setQuatRotation(half)
    assert np.array_equal(copy.getRotation(), both.getRotation()) and "translation [0.0, 0.0, 0.0]" in repr(copy)
    for quaternion in np.eye(4)[1:].tolist() + [[0.5, -0.5, 0.5, 0.5], [0.1, 0.7, -0.7, 0.1], [0.1, 0.1, 0.7, -0.7]]:
        again = fcl.Transform(fcl.Transform(quaternion).getQuatRotation()).getRotation()
        assert np.allclose(again, fcl.Transform(quaternion).getRotation(), atol=1e-15)
    for bad in ([1, 2], np.eye(4), "x"):
        with pytest.raises(ValueError, match=r"a matrix \(3, 3\) or a quaternion \(4,\), a translation \(3,\)"):
            fcl.Transform(bad)
    for args, text in ((([1, 2, 3], [1, 2, 3]), "argument 1 is a list of 3"), ((np.eye(3), [1, 2]), "translation is a list"),
                       ((1, 2, 3), "3 arguments are given")):
        with pytest.raises(ValueError, match=text):
            fcl.Transform(*args)
    with pytest.raises(ecods.InvalidArgument, match=r"t\(1\)"):
        fcl.Transform([0, math.nan, 0])


def test_objects():
    placed = fcl.CollisionObject(GEOMETRIES["mesh"], fcl.Transform([1, 0, 0]))
    assert (placed.getObjectType(), placed.getNodeType()) == (fcl.OBJECT_TYPE.OT_BVH, fcl.NODE_TYPE.BV_OBBRSS) == (1, 5)
    assert thing(GEOMETRIES["box"]).getObjectType() == fcl.OBJECT_TYPE.OT_GEOM == 2
    assert fcl.CollisionGeometry().getNodeType() is None and fcl.CollisionGeometry().aabb_center is None
    given = placed.getTransform()
    given.setTranslation([9, 9, 9])
    assert placed.getTranslation().tolist() == [1, 0, 0] and "BVHModel of 12 triangles" in repr(placed)
    placed.setRotation(np.eye(3))
    placed.setQuatRotation([1, 0, 0, 0])
    placed.setTransform(given)
    placed.computeAABB()
    assert placed.getTranslation().tolist() == [9, 9, 9] and placed.getQuatRotation().tolist() == [1, 0, 0, 0]
    assert (placed.isOccupied(), placed.isFree(), placed.isUncertain()) == (True, False, False)
    for geometry in (None, fcl.CollisionGeometry()):
        with pytest.raises(ValueError, match="there is no geometry"):
            fcl.CollisionObject(geometry)
    with pytest.raises(TypeError, match="is 5; a CollisionGeometry is expected"):
        fcl.CollisionObject(5)
    with pytest.raises(TypeError, match="a Transform is expected"):
        placed.setTransform(np.eye(4))


def test_numbers_of_geometries():
    names = {"BV_OBBRSS": 5, "GEOM_BOX": 9, "GEOM_CONVEX": 15, "GEOM_TRIANGLE": 18, "NODE_COUNT": 20}
    assert {name: int(fcl.NODE_TYPE[name]) for name in names} == names
    ball, cube, corner = fcl.Sphere(1), fcl.Box(1, 2, 3), fcl.TriangleP([0, 0, 0], [1, 0, 0], [0, 1, 0])
    assert ball.radius == 1 and cube.side.tolist() == [1, 2, 3] and corner.b.tolist() == [1, 0, 0]
    other = thing(GEOMETRIES["box"], x=3)
    ball.radius, corner.b = 2, [2, 0, 0]
    assert measured(thing(ball), other).min_distance == 0.5 == measured(thing(corner), other).min_distance
    with pytest.raises(ecods.InvalidArgument):
        ball.radius = -1
    assert ball.radius == 2 and repr(ball) == "Sphere(radius=2)"
    cube.side[0] = 7
    assert cube.side.tolist() == [1, 2, 3] and cube.aabb_center.tolist() == [0, 0, 0]
    assert fcl.Plane([0, 0, 1], 4).aabb_center.tolist() == [0, 0, 4]
    assert fcl.Capsule(1, 4).lz == 4 and "OcTree" in fcl.__all__ and fcl.Ellipsoid(1, 1, 1).deviation == 0
    cube.computeLocalAABB()
    with pytest.raises(NotImplementedError, match="OcTree"):
        fcl.OcTree(0.1, b"")


def test_polytopes_contain_curved_bodies_and_say_so():
    for make, deviation in ((lambda: fcl.Cylinder(1, 2), 0.0013), (lambda: fcl.Cone(1, 2), 0.0013),
                            (lambda: fcl.Ellipsoid(1, 0.5, 0.75), 0.0015)):
        with pytest.warns(fcl.PolytopeWarning, match="is answered as a polytope of .* up to 0.001. away") as warned:
            made = make()
        assert warned[0].filename == __file__ and 0 < made.deviation < deviation
    with pytest.warns(fcl.PolytopeWarning) as warned:
        can = fcl.Cylinder(1, 2, sides=4)
        can.sides = 256
    assert len(warned) == 2 and {each.filename for each in warned} == {__file__} and can.deviation < 0.0001
    assert (can.radius, can.lz, can.sides) == (1, 2, 256)
    with pytest.warns(fcl.PolytopeWarning):
        assert fcl.Ellipsoid(1, 2, 3).radii.tolist() == [1, 2, 3]


def test_convex():
    vertices, count, faces = polygons()
    cube = fcl.Convex(vertices, count, faces)
    assert cube.num_faces == 6 and isinstance(cube.shape, ecods.ConvexSolid) and "8 vertices, 6 faces" in repr(cube)
    triangles = np.array(box()[1])
    listed = np.hstack([np.full((12, 1), 3), triangles]).flatten()
    assert np.array_equal(fcl.Convex(vertices, 12, listed).shape.faces, triangles)
    dented = vertices.copy()
    dented[0] += 2.0**-40
    assert len(fcl.Convex(dented, 12, listed).shape.vertices) == 8
    spike = np.vstack([vertices, [[0, 0, 4]]])
    assert measured(thing(fcl.Convex(spike, count, faces)), thing(GEOMETRIES["box"], z=6)).min_distance == 1.5
    for bad, text in (((7, faces), "face 6 begins at number 30"), ((5, faces), "5 faces end after 25"),
                      ((6, faces[:-1]), "face 5"), ((1, [2, 0, 1]), "face 0"), ((1, [3, 0, 1, 2.5]), "not whole")):
        with pytest.raises(ValueError, match=text):
            fcl.Convex(vertices, *bad)
    with pytest.raises(TypeError, match="num_faces"):
        fcl.Convex(vertices, "six", faces)
    with pytest.raises(ecods.InvalidMesh, match="index 8"):
        fcl.Convex(vertices, 1, [3, 0, 1, 8])


def test_models():
    model = fcl.BVHModel()
    assert (model.buildState(), model.num_tries_()) == (0, 0)
    for call in (lambda: model.addVertex(0, 0, 0), model.endModel):
        with pytest.raises(ValueError, match="beginModel"):
            call()
    with pytest.raises(ValueError, match="endModel"):
        fcl.collide(thing(model), thing(GEOMETRIES["box"]))
    assert model.beginModel(4, 4) == 0 and model.buildState() == 1
    with pytest.raises(ValueError, match="no triangles"):
        model.endModel()
    with pytest.raises(ecods.InvalidMesh, match="index 3"):
        model.addSubModel([[0, 0, 0]] * 3, [[0, 1, 3]])
    assert model.addTriangle([0, 0, 0], [1, 0, 0], [0, 1, 0]) is True and model.addVertex(9, 9, 9) is True
    assert model.addSubModel([[0, 0, 1], [1, 0, 1], [0, 1, 1]], [[0, 1, 2]]) is True and model.num_tries_() == 2
    assert model.endModel() == 0 and (model.buildState(), model.num_tries_()) == (2, 2)
    assert model.shape.faces.tolist() == [[0, 1, 2], [4, 5, 6]] and np.allclose(model.aabb_center, [0.5, 0.5, 0.5])
    with pytest.raises(ValueError, match="has ended"):
        model.addTriangle([0, 0, 0], [1, 0, 0], [0, 1, 0])
    found = measured(thing(model), thing(GEOMETRIES["box"], z=3))
    assert found.min_distance == 1.5 and found.b1 == 1
    assert model.beginModel() == 0 and model.num_tries_() == 0
