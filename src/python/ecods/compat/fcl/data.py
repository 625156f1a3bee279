"""Requests, results and enums, with the names, arguments and defaults of python-fcl."""
import enum
import sys
from typing import Any, List, Optional

import numpy as np


class OBJECT_TYPE(enum.IntEnum):
    """The kind of a geometry: a mesh is OT_BVH, every other shape OT_GEOM."""
    OT_UNKNOWN, OT_BVH, OT_GEOM, OT_OCTREE, OT_COUNT = range(5)


class NODE_TYPE(enum.IntEnum):
    """The class of a geometry; a BVHModel is BV_OBBRSS, as in python-fcl."""
    (BV_UNKNOWN, BV_AABB, BV_OBB, BV_RSS, BV_kIOS, BV_OBBRSS, BV_KDOP16, BV_KDOP18, BV_KDOP24, GEOM_BOX, GEOM_SPHERE,
     GEOM_ELLIPSOID, GEOM_CAPSULE, GEOM_CONE, GEOM_CYLINDER, GEOM_CONVEX, GEOM_PLANE, GEOM_HALFSPACE, GEOM_TRIANGLE,
     GEOM_OCTREE, NODE_COUNT) = range(21)


class CCDMotionType(enum.IntEnum):
    """The motion between two transforms."""
    CCDM_TRANS, CCDM_LINEAR, CCDM_SCREW, CCDM_SPLINE = range(4)


class CCDSolverType(enum.IntEnum):
    """FCL's ways to find a time of contact. No answer depends on them here."""
    CCDC_NAIVE, CCDC_CONSERVATIVE_ADVANCEMENT, CCDC_RAY_SHOOTING, CCDC_POLYNOMIAL_SOLVER = range(4)


class GJKSolverType(enum.IntEnum):
    """FCL's ways to ask about convex shapes. No answer depends on them here."""
    GST_LIBCCD, GST_INDEP = range(2)


class _Record:
    """A class whose repr shows its attributes."""

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in vars(self).items())})"


class Contact(_Record):
    """A point at which two geometries meet.

    o1, o2: the geometries of the first and the second object. b1, b2: the triangles that meet, for meshes; otherwise -1.
    The following are set only if the request has enable_contact. normal: the unit vector from o1 to o2 along which o2
    would have to move to part them; penetration_depth: how far it would have to move, 0 if they touch; pos: the middle of
    the two points that this move brings together. For a mesh these are those of the triangle, not of the mesh.
    """

    def __init__(self) -> None:
        self.o1: Any = None
        self.o2: Any = None
        self.b1 = 0
        self.b2 = 0
        self.normal = np.zeros(3)
        self.pos = np.zeros(3)
        self.penetration_depth = 0.0


class CostSource(_Record):
    """A box with a cost. No call makes one: a CollisionRequest with enable_cost is refused."""

    def __init__(self) -> None:
        self.aabb_min = np.zeros(3)
        self.aabb_max = np.zeros(3)
        self.cost_density = 0.0
        self.total_cost = 0.0


class CollisionRequest(_Record):
    """What collide() should find: at most num_max_contacts contacts, with points and depths if enable_contact is True.

    enable_cost is refused by collide(). use_approximate_cost, num_max_cost_sources and gjk_solver_type change nothing.
    """

    def __init__(self, num_max_contacts: int = 1, enable_contact: bool = False, num_max_cost_sources: int = 1,
                 enable_cost: bool = False, use_approximate_cost: bool = True,
                 gjk_solver_type: int = GJKSolverType.GST_LIBCCD) -> None:
        self.num_max_contacts = num_max_contacts
        self.enable_contact = enable_contact
        self.num_max_cost_sources = num_max_cost_sources
        self.enable_cost = enable_cost
        self.use_approximate_cost = use_approximate_cost
        self.gjk_solver_type = gjk_solver_type


class CollisionResult(_Record):
    """What collide() found: is_collision, and a list of Contact. Each further call with it adds contacts."""

    def __init__(self, is_collision: bool = False) -> None:
        self.is_collision = is_collision
        self.contacts: List[Contact] = []
        self.cost_sources: List[CostSource] = []


class ContinuousCollisionRequest(_Record):
    """The motion of continuousCollide(). The other arguments change nothing: the time is exact, rounded once."""

    def __init__(self, num_max_iterations: int = 10, toc_err: float = 0.0001,
                 ccd_motion_type: int = CCDMotionType.CCDM_TRANS, gjk_solver_type: int = GJKSolverType.GST_LIBCCD,
                 ccd_solver_type: int = CCDSolverType.CCDC_CONSERVATIVE_ADVANCEMENT) -> None:
        self.num_max_iterations = num_max_iterations
        self.toc_err = toc_err
        self.ccd_motion_type = ccd_motion_type
        self.gjk_solver_type = gjk_solver_type
        self.ccd_solver_type = ccd_solver_type


class ContinuousCollisionResult(_Record):
    """What continuousCollide() found: is_collide, and the least time_of_contact, 1.0 if there is none."""

    def __init__(self, is_collide: bool = False, time_of_contact: float = 1.0) -> None:
        self.is_collide = is_collide
        self.time_of_contact = time_of_contact


class DistanceRequest(_Record):
    """What distance() should find: also nearest_points, and how deep the objects are in each other if they meet."""

    def __init__(self, enable_nearest_points: bool = False, enable_signed_distance: bool = False,
                 gjk_solver_type: int = GJKSolverType.GST_LIBCCD) -> None:
        self.enable_nearest_points = enable_nearest_points
        self.enable_signed_distance = enable_signed_distance
        self.gjk_solver_type = gjk_solver_type


class DistanceResult(_Record):
    """The least distance that distance() found, over all calls with this result.

    o1, o2: the geometries. b1, b2: their triangles, for meshes; otherwise -1. nearest_points: a point of each, in the
    world's coordinates; None unless the request has enable_nearest_points.
    """

    def __init__(self, min_distance_: float = sys.float_info.max) -> None:
        self.min_distance = min_distance_
        self.nearest_points: List[Optional[np.ndarray]] = [None, None]
        self.o1: Any = None
        self.o2: Any = None
        self.b1 = -1
        self.b2 = -1


class CollisionData(_Record):
    """A request and a result for defaultCollisionCallback(), and `done`, which is True once no more pairs are wanted."""

    def __init__(self, request: Optional[CollisionRequest] = None, result: Optional[CollisionResult] = None) -> None:
        self.request = CollisionRequest() if request is None else request
        self.result = CollisionResult() if result is None else result
        self.done = False


class DistanceData(_Record):
    """A request and a result for defaultDistanceCallback(), and `done`, which is True once no more pairs are wanted."""

    def __init__(self, request: Optional[DistanceRequest] = None, result: Optional[DistanceResult] = None) -> None:
        self.request = DistanceRequest() if request is None else request
        self.result = DistanceResult() if result is None else result
        self.done = False
