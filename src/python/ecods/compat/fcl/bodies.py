"""Posed bodies, and questions about two of them.

A body is a tuple of posed shapes, and stands for their intersection: one shape, or the half spaces on both sides of a
plane. A connected set meets a plane exactly if it meets both half spaces; so beside a plane, an object that is not
connected counts as several bodies.
"""
from typing import Any, List, NamedTuple, Optional, Tuple

import numpy as np

from ... import _ecods
from .mesh import BVHModel
from .transform import CollisionObject

Body = Tuple[Any, ...]
NO_TRIANGLE = -1
NOWHERE = np.full(3, np.nan)


class Measure(NamedTuple):
    """A signed distance, a point of each body, the direction out of the first one, and the triangles that hold the points.

    Points and the direction are NaN where there are none.
    """
    distance: float
    point_a: np.ndarray = NOWHERE
    point_b: np.ndarray = NOWHERE
    direction: np.ndarray = NOWHERE
    triangle_a: int = NO_TRIANGLE
    triangle_b: int = NO_TRIANGLE

    def swapped(self) -> "Measure":
        return Measure(self.distance, self.point_b, self.point_a, -self.direction, self.triangle_b, self.triangle_a)


def is_mesh(thing: CollisionObject) -> bool:
    return isinstance(thing._geometry, BVHModel)


def sides_of(thing: CollisionObject) -> Tuple[Any, ...]:
    """Returns the shapes whose intersection is the object. Raises ValueError if its model is not finished."""
    shape = thing._geometry.shape
    if shape is None:
        raise ValueError(f"{thing._geometry!r} has no shape: endModel() has not been called")
    return shape if isinstance(shape, tuple) else (shape,)


def body_of(thing: CollisionObject) -> Body:
    """Returns the body of an object. The body is stored with the object until the object changes."""
    version = thing._version
    if thing._body is None or thing._body[0] != version:
        thing._body = version, tuple(side.at(thing._pose) for side in sides_of(thing))
    return thing._body[1]


class _Piece(tuple):
    """A body that is a connected part of a mesh, with the numbers (n,) that its triangles have in the mesh."""
    numbers: np.ndarray

    @classmethod
    def of(cls, posed: Any, numbers: np.ndarray) -> "_Piece":
        piece = cls((posed,))
        piece.numbers = numbers
        return piece


def _number(body: Body, triangle: int) -> int:
    """Returns the number of a body's triangle in its mesh."""
    return int(body.numbers[triangle]) if isinstance(body, _Piece) and triangle != NO_TRIANGLE else triangle


def _bodies_for(thing: CollisionObject, other: CollisionObject) -> List[Body]:
    model = thing._geometry
    if isinstance(model, BVHModel) and len(sides_of(other)) > 1:
        return [_Piece.of(mesh.at(thing._pose), numbers) for mesh, numbers in model.pieces()]
    return [body_of(thing)]


def bodies_of(o1: CollisionObject, o2: CollisionObject) -> List[Tuple[Body, Body]]:
    """Returns pairs of bodies. The objects meet if the bodies of a pair meet; their distance is the least of the pairs."""
    return [(a, b) for a in _bodies_for(o1, o2) for b in _bodies_for(o2, o1)]


def is_half_space(body: Body) -> bool:
    return isinstance(body[0], _ecods.PosedHalfSpace)


def _sides(a: Body, b: Body) -> List[Tuple[Any, Any]]:
    """Returns all pairs of sides, with half spaces second, as the library's questions require."""
    pairs = [(x, y) for x in a for y in b]
    return [(y, x) for x, y in pairs] if is_half_space(a) else pairs


def meet(a: Body, b: Body) -> bool:
    """Returns True if two bodies share a point."""
    return all(_ecods.intersects(*pair) for pair in _sides(a, b))


def touch(a: Body, b: Body) -> bool:
    """Returns True if two bodies that meet share no inner points."""
    return any(_ecods.relation(*pair) == _ecods.Relation.touching for pair in _sides(a, b))


def nearest(a: Body, b: Body) -> Measure:
    """Returns the distance of two bodies, 0 if they meet, with points unless both are half spaces or planes."""
    if is_half_space(a) and is_half_space(b):
        return Measure(max(_ecods.distance(*pair) for pair in _sides(a, b)))
    if is_half_space(a):
        return nearest(b, a).swapped()
    found = max((_ecods.closest(*pair) for pair in _sides(a, b)), key=lambda each: each.distance)
    return Measure(found.distance, found.point_a, found.point_b, triangle_a=_number(a, found.a.triangle),
                   triangle_b=found.b.triangle)


def signed(a: Body, b: Body) -> Optional[Measure]:
    """Returns the signed distance of two convex bodies, or of a body and half spaces; None if they have none."""
    if is_half_space(a):
        other = None if is_half_space(b) else signed(b, a)
        return other and other.swapped()
    try:
        # The shortest translation to one side of a plane is the shortest one out of one of its half spaces.
        found = max((_ecods.signed_distance(*pair) for pair in _sides(a, b)), key=lambda each: each.distance)
    except (_ecods.NotSupported, _ecods.SingularPose):
        return None
    return Measure(found.distance, found.point_a, found.point_b, found.direction, _number(a, found.a.triangle),
                   found.b.triangle)


def _shape(posed: Any) -> Any:
    """Returns the shape that is posed; the core of a Rounded without a radius."""
    shape = posed.mesh if isinstance(posed, _ecods.Posed) else posed.shape
    return shape.core if isinstance(shape, _ecods.Rounded) and shape.radius == 0 else shape


def _time(x: Any, end_x: np.ndarray, y: Any, end_y: np.ndarray) -> Optional[float]:
    shapes = _shape(x), _shape(y)
    if any(isinstance(shape, _ecods.Rounded) for shape in shapes):
        if isinstance(x, _ecods.PosedHalfSpace):
            return _time(y, end_y, x, end_x)
        motion = (end_x - x.pose)[:3, 3] - (end_y - y.pose)[:3, 3]
        contact = _ecods.cast(shapes[0].at(x.pose), motion, shapes[1].at(y.pose))
        return None if contact is None else contact.time
    # A world takes both motions, so no difference of translations is rounded.
    world = _ecods.World()
    met = world.meetings([world.create_body(shape, each.pose) for shape, each in zip(shapes, (x, y))], [end_x, end_y])
    return met[0].contact.time if met else None


def first_time(a: Body, end_a: np.ndarray, b: Body, end_b: np.ndarray) -> Optional[float]:
    """Returns the time, from 0 to 1, at which two bodies on straight paths to these poses first meet; None if they do not.

    A body that is apart from a plane is in one of its half spaces, and meets the plane when it meets the other one.
    """
    times = [_time(x, end_a, y, end_b) for x in a for y in b]
    known = [time for time in times if time is not None]
    return max(known) if len(known) == len(times) else None
