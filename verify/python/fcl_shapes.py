"""Geometries of ecods.compat.fcl that all reach from z = -1/2 to z = 1/2, exactly, and objects of them."""
import warnings

import numpy as np

import ecods.compat.fcl as fcl
from scenes import box


def cube_mesh(x=0.0):
    """A model of the surface of a unit cube around (x, 0, 0)."""
    vertices, faces = box()
    model = fcl.BVHModel()
    model.beginModel(len(vertices), len(faces))
    model.addSubModel(np.array(vertices) + [x - 0.5, -0.5, -0.5], np.array(faces))
    model.endModel()
    return model


def polygons():
    """The vertices of a unit cube, the number of its faces, and the list of these."""
    vertices = np.array(box()[0]) - 0.5
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return vertices, len(quads), np.array([(4, *quad) for quad in quads]).flatten()


with warnings.catch_warnings():
    warnings.simplefilter("ignore", fcl.PolytopeWarning)
    SOLIDS = {
        "box": fcl.Box(1, 1, 1), "sphere": fcl.Sphere(0.5), "capsule": fcl.Capsule(0.25, 0.5),
        "cylinder": fcl.Cylinder(0.5, 1), "cone": fcl.Cone(0.5, 1), "ball": fcl.Ellipsoid(0.5, 0.5, 0.5),
        "convex": fcl.Convex(*polygons()), "triangle": fcl.TriangleP([0, 0, -0.5], [0, 0, 0.5], [0.25, 0, 0])}
GEOMETRIES = {**SOLIDS, "mesh": cube_mesh()}
# These are below: their top is z = 1/2.
GROUNDS = {"half space": fcl.Halfspace([0, 0, 2], 1), "plane": fcl.Plane([0, 0, -2], -1)}


def thing(geometry, x=0.0, y=0.0, z=0.0):
    return fcl.CollisionObject(geometry, fcl.Transform([x, y, z]))


def contacts(o1, o2, limit=1000, **arguments):
    result = fcl.CollisionResult()
    count = fcl.collide(o1, o2, fcl.CollisionRequest(limit, **{"enable_contact": True, **arguments}), result)
    assert count == len(result.contacts) and result.is_collision is (count > 0)
    return result.contacts


def measured(o1, o2, is_signed=True):
    result = fcl.DistanceResult()
    number = fcl.distance(o1, o2, fcl.DistanceRequest(True, is_signed), result)
    assert number == result.min_distance and result.o1 is o1._geometry and result.o2 is o2._geometry
    return result
