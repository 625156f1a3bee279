"""Questions about two objects, and the callbacks for managers that ask them."""
import math
from typing import Any, Optional, Tuple

import numpy as np

from ... import _ecods
from ...refusals import describe, is_index
from .bodies import NO_TRIANGLE, NOWHERE, Measure, bodies_of, first_time, is_mesh, nearest
from .data import (CCDMotionType, CollisionData, CollisionRequest, CollisionResult, Contact, ContinuousCollisionRequest,
                   ContinuousCollisionResult, DistanceData, DistanceRequest, DistanceResult)
from .parts import Part, measure, measured, meeting_parts
from .transform import CollisionObject, Transform


def _check(call: str, **arguments: Tuple[Any, type]) -> None:
    for name, (value, kind) in arguments.items():
        if not isinstance(value, kind):
            raise TypeError(f"{call}: argument {name} is {describe(value)}; a {kind.__name__} is expected")


def _contact(o1: CollisionObject, o2: CollisionObject, part: Part, has_data: bool) -> Contact:
    made = Contact()
    made.o1, made.o2, made.b1, made.b2 = o1._geometry, o2._geometry, part.triangle_a, part.triangle_b
    if not has_data:
        if is_mesh(o1) and made.b1 == NO_TRIANGLE or is_mesh(o2) and made.b2 == NO_TRIANGLE:
            made.b1, made.b2 = _names(o1, o2, nearest(part.a, part.b))
        return made
    found = measured(part)
    if found is None:
        made.pos, made.normal, made.penetration_depth = nearest(part.a, part.b).point_a.copy(), NOWHERE.copy(), math.nan
        return made
    made.pos = 0.5 * found.point_a + 0.5 * found.point_b
    made.normal, made.penetration_depth = found.direction, 0.0 - found.distance
    made.b1, made.b2 = _names(o1, o2, found)
    return made


def _names(o1: CollisionObject, o2: CollisionObject, found: Measure) -> Tuple[int, int]:
    return found.triangle_a if is_mesh(o1) else -1, found.triangle_b if is_mesh(o2) else -1


def collide(o1: CollisionObject, o2: CollisionObject, request: Optional[CollisionRequest] = None,
            result: Optional[CollisionResult] = None) -> int:
    """Returns the number of contacts of two objects, at most request.num_max_contacts, and adds them to the result.

    The number is 0 exactly if the objects share no point: touching counts. Two shapes have one contact (FCL returns up to
    eight for two boxes). A mesh has one for each of its triangles that meets the other object, two meshes one for each
    pair of triangles; a mesh and a half space have one. Contacts are as Contact says; o1 and o2 are in the order of the
    arguments (FCL may swap a mesh to the front). Where the library has no depth, normal and depth are NaN, and pos is a
    common point; for two half spaces it is NaN. Raises NotImplementedError for request.enable_cost, and ValueError if
    num_max_contacts is not positive: FCL then says that nothing collides.
    """
    _check("collide", o1=(o1, CollisionObject), o2=(o2, CollisionObject))
    request = CollisionRequest() if request is None else request
    result = CollisionResult() if result is None else result
    if not is_index(request.num_max_contacts) or request.num_max_contacts < 1:
        raise ValueError(f"collide: num_max_contacts is {describe(request.num_max_contacts)}; a positive whole number is "
                         "expected")
    if request.enable_cost:
        raise NotImplementedError("collide: enable_cost is set, but ECoDS has no cost sources")
    parts = meeting_parts(o1, o2, request.num_max_contacts)
    result.is_collision = result.is_collision or len(parts) > 0
    result.contacts += [_contact(o1, o2, part, request.enable_contact) for part in parts]
    return len(parts)


def distance(o1: CollisionObject, o2: CollisionObject, request: Optional[DistanceRequest] = None,
             result: Optional[DistanceResult] = None) -> float:
    """Returns the distance of two objects, and stores it in the result if it is less than what the result has.

    It is the true number, rounded once. It is 0 if the objects touch, and for two meshes also if they cross. Other objects
    that share inner points have the distance -1; with request.enable_signed_distance, minus their depth, which is the
    length of the shortest translation that parts them. For a mesh it is the depth of its deepest triangle, so the whole
    mesh may have to move further. The distance stays -1 for two half spaces or planes, and where the library has no number
    for the depth. (For a mesh and a shape, FCL returns -1 and stores minus the depth of one triangle.)
    """
    _check("distance", o1=(o1, CollisionObject), o2=(o2, CollisionObject))
    request = DistanceRequest() if request is None else request
    result = DistanceResult() if result is None else result
    found = measure(o1, o2, bool(request.enable_signed_distance))
    if found.distance < result.min_distance:
        result.min_distance = found.distance
        result.o1, result.o2 = o1._geometry, o2._geometry
        result.b1, result.b2 = _names(o1, o2, found)
        has_points = request.enable_nearest_points and found.point_a is not NOWHERE
        result.nearest_points = [found.point_a, found.point_b] if has_points else [None, None]
    return found.distance


def _end(thing: CollisionObject, tf: Transform, motion: int) -> np.ndarray:
    end = tf._pose.copy()
    is_turned = not np.array_equal(end[:3, :3], thing._pose[:3, :3])
    if motion == CCDMotionType.CCDM_SPLINE or is_turned and motion != CCDMotionType.CCDM_TRANS:
        raise NotImplementedError(f"continuousCollide: {CCDMotionType(motion).name} of an object that turns; ECoDS has exact "
                                  "times of translations: CCDM_TRANS, or CCDM_LINEAR and CCDM_SCREW without a turn")
    end[:3, :3] = thing._pose[:3, :3]
    return end


def continuousCollide(o1: CollisionObject, tf1_end: Transform, o2: CollisionObject, tf2_end: Transform,
                      request: Optional[ContinuousCollisionRequest] = None,
                      result: Optional[ContinuousCollisionResult] = None) -> float:
    """Returns the time from 0 to 1 at which two objects first meet while they are translated to the given transforms.

    It is the true time, rounded once; 0 if they meet at the start, 1.0 if they never meet: the result says which. (If an
    object is a Sphere or a Capsule, the difference of the two translations is first rounded to doubles.) With CCDM_TRANS,
    the default, an object keeps its rotation, whatever the transform has, as in FCL. Raises NotImplementedError for
    rotations (CCDM_LINEAR, CCDM_SCREW), for CCDM_SPLINE, and where the library has no times.
    (FCL's default solver misses contacts: two unit boxes, of which one passes through the other, never meet there.)
    """
    _check("continuousCollide", o1=(o1, CollisionObject), tf1_end=(tf1_end, Transform), o2=(o2, CollisionObject),
           tf2_end=(tf2_end, Transform))
    request = ContinuousCollisionRequest() if request is None else request
    result = ContinuousCollisionResult() if result is None else result
    ends = [_end(thing, tf, request.ccd_motion_type) for thing, tf in ((o1, tf1_end), (o2, tf2_end))]
    try:
        found = [first_time(a, ends[0], b, ends[1]) for a, b in bodies_of(o1, o2)]
    except _ecods.NotSupported as error:
        raise NotImplementedError(f"continuousCollide of {o1._geometry!r} and {o2._geometry!r}: {error}") from error
    times = [time for time in found if time is not None]
    result.is_collide = result.is_collide or len(times) > 0
    time = min(times, default=1.0)
    result.time_of_contact = min(result.time_of_contact, time)
    return time


def defaultCollisionCallback(o1: CollisionObject, o2: CollisionObject, cdata: CollisionData) -> bool:
    """Calls collide() with cdata.request and cdata.result. Returns True, for the manager to stop, once cdata.done is True.

    As in python-fcl, cdata.done becomes True when the result has more contacts than the request's num_max_contacts.
    """
    if not cdata.done:
        collide(o1, o2, cdata.request, cdata.result)
        if cdata.result.is_collision and len(cdata.result.contacts) > cdata.request.num_max_contacts:
            cdata.done = True
    return cdata.done


def defaultDistanceCallback(o1: CollisionObject, o2: CollisionObject, cdata: DistanceData) -> Tuple[bool, float]:
    """Calls distance() with cdata.request and cdata.result. Returns whether the manager may stop, and the least distance.

    As in python-fcl, it may stop when two objects meet, or when cdata.done is True. So if objects meet, the first two that
    are found are measured, which need not be the deepest; a callback that returns (False, math.inf) sees all pairs.
    """
    if not cdata.done:
        distance(o1, o2, cdata.request, cdata.result)
    return cdata.done or cdata.result.min_distance <= 0, cdata.result.min_distance
