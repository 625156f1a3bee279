"""python-fcl's module `fcl`, answered by ECoDS: its classes, arguments, enums, signs and conventions.

    import ecods.compat.fcl as fcl

or, for a program that stays as it is, `sys.modules["fcl"] = ecods.compat.fcl` before it is imported. Answers are exact
for the numbers as given, as all of ECoDS's: touching counts as a collision, and a number is the true one, rounded once.
The docstrings of collide(), distance() and continuousCollide() say where FCL answers otherwise.

Spheres, capsules, boxes, convex polytopes, triangles, half spaces, planes and meshes are exact. A cylinder, a cone or
an ellipsoid is answered as a polytope that contains it; a PolytopeWarning says how far the polytope reaches beyond it.
A BVHModel is a surface. There are no octrees, no cost sources and no times of motions that turn: NotImplementedError,
by name.
"""
from ... import __version__
from .data import (NODE_TYPE, OBJECT_TYPE, CCDMotionType, CCDSolverType, CollisionData, CollisionRequest, CollisionResult,
                   Contact, ContinuousCollisionRequest, ContinuousCollisionResult, CostSource, DistanceData, DistanceRequest,
                   DistanceResult, GJKSolverType)
from .geometry import (Box, Capsule, CollisionGeometry, Cone, Convex, Cylinder, Ellipsoid, Halfspace, OcTree, Plane,
                       PolytopeWarning, Sphere, TriangleP)
from .manager import DynamicAABBTreeCollisionManager
from .mesh import BVHModel
from .queries import collide, continuousCollide, defaultCollisionCallback, defaultDistanceCallback, distance
from .transform import CollisionObject, Transform

__all__ = [
    "CollisionObject", "CollisionGeometry", "Transform", "TriangleP", "Box", "Sphere", "Ellipsoid", "Capsule", "Cone",
    "Convex", "Cylinder", "Halfspace", "Plane", "BVHModel", "OcTree", "DynamicAABBTreeCollisionManager", "collide",
    "continuousCollide", "distance", "defaultCollisionCallback", "defaultDistanceCallback", "OBJECT_TYPE", "NODE_TYPE",
    "CCDMotionType", "CCDSolverType", "GJKSolverType", "Contact", "CostSource", "CollisionRequest", "CollisionResult",
    "ContinuousCollisionRequest", "ContinuousCollisionResult", "DistanceRequest", "DistanceResult", "CollisionData",
    "DistanceData", "PolytopeWarning", "__version__",
]
