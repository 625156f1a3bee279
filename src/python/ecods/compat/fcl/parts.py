"""The parts of two objects that meet, and how far apart or deep in each other objects are."""
import itertools
import sys
from typing import Iterator, List, NamedTuple, Optional, Tuple

import numpy as np

from ... import _ecods
from .bodies import (NO_TRIANGLE, Body, Measure, bodies_of, body_of, is_half_space, is_mesh, meet, nearest, signed,
                     touch)
from .geometry import box_of
from .transform import CollisionObject


class Part(NamedTuple):
    """Bodies that meet, each a triangle of a mesh with its number, or a whole object."""
    a: Body
    b: Body
    triangle_a: int = NO_TRIANGLE
    triangle_b: int = NO_TRIANGLE

    def swapped(self) -> "Part":
        return Part(self.b, self.a, self.triangle_b, self.triangle_a)


def _may_meet(thing: CollisionObject, box: np.ndarray) -> np.ndarray:
    """Returns the triangles of a mesh whose boxes, rounded outwards, share a point with a box (2, 3).

    A coordinate of R v + t has three products and three sums, in any order, each of which rounds by at most u times a
    partial sum of |R| |v| + |t|, or by 2^-1074. The bound is computed in as many steps, and subtracted in one more. So
    16 u (|R| |v| + |t|) + 16 * 2^-1074 contains all errors.
    """
    u = 2.0**-53
    mesh, matrix, t = thing._geometry.shape, thing._pose[:3, :3], thing._pose[:3, 3]
    with np.errstate(all="ignore"):
        points = mesh.vertices @ matrix.T + t
        reach = 16 * u * (abs(mesh.vertices) @ abs(matrix).T + abs(t)) + 16 * 2.0**-1074
        low = (points - reach)[mesh.faces].min(axis=1)
        high = (points + reach)[mesh.faces].max(axis=1)
    # A comparison with NaN, after an overflow, is False, so its triangle is kept.
    return np.flatnonzero(~((low > box[1]) | (high < box[0])).any(axis=1))


def _triangle(thing: CollisionObject, triangle: int) -> Body:
    """Returns a posed triangle of a mesh: a Rounded of radius 0, which is convex."""
    mesh = thing._geometry.shape
    return (_ecods.Rounded(_ecods.Mesh(mesh.vertices[mesh.faces[triangle]], [[0, 1, 2]]), 0.0).at(thing._pose),)


def _named_part(o1: CollisionObject, o2: CollisionObject, triangles: Tuple[int, int]) -> Part:
    """Returns the part of two objects: for an object that is a mesh, this triangle; otherwise the whole object."""
    of = [(_triangle(thing, i), i) if is_mesh(thing) else (body_of(thing), NO_TRIANGLE)
          for thing, i in zip((o1, o2), triangles)]
    return Part(of[0][0], of[1][0], of[0][1], of[1][1])


def _triangles_in(mesh: CollisionObject, other: CollisionObject) -> Iterator[Part]:
    """Yields the triangles of a mesh that meet an object which is no mesh."""
    body = body_of(other)
    for i in _may_meet(mesh, box_of(other._geometry.shape, other._pose)).tolist():
        part = Part(_triangle(mesh, i), body, i)
        if meet(part.a, body):
            yield part


def _all_parts(o1: CollisionObject, o2: CollisionObject) -> Iterator[Part]:
    if is_mesh(o1) and is_mesh(o2):
        pairs = _ecods.intersecting_triangles(body_of(o1)[0], body_of(o2)[0]).tolist()
        return (_named_part(o1, o2, pair) for pair in pairs)
    if is_mesh(o1):
        return _triangles_in(o1, o2)
    return (part.swapped() for part in _triangles_in(o2, o1))


def meeting_parts(o1: CollisionObject, o2: CollisionObject, limit: Optional[int] = None) -> List[Part]:
    """Returns the parts of two objects that meet, up to a limit: triangles of meshes, ascending; otherwise whole objects.

    A mesh and a half space meet as wholes; so do a plane and each connected part of a mesh.
    """
    limit = None if limit is None else min(limit, sys.maxsize)
    found = (Part(a, b) for a, b in bodies_of(o1, o2) if meet(a, b))
    first = next(found, None)
    if first is None:
        return []
    if is_half_space(first.a) or is_half_space(first.b) or not (is_mesh(o1) or is_mesh(o2)):
        return list(itertools.islice(itertools.chain([first], found), limit))
    if limit == 1:
        return [_named_part(o1, o2, _ecods.closest(first.a[0], first.b[0]).triangles)]
    return list(itertools.islice(_all_parts(o1, o2), limit))


def measured(part: Part) -> Optional[Measure]:
    """Returns the signed distance of a part, with the triangles of meshes; None if the part has none."""
    found = signed(part.a, part.b)
    if found is None:
        return None
    names = [name if name != NO_TRIANGLE else own
             for name, own in ((part.triangle_a, found.triangle_a), (part.triangle_b, found.triangle_b))]
    return found._replace(triangle_a=names[0], triangle_b=names[1])


def _deepest(o1: CollisionObject, o2: CollisionObject) -> Optional[Measure]:
    """Returns the least signed distance of parts that meet; None if one has none."""
    found = [measured(part) for part in meeting_parts(o1, o2)]
    known = [each for each in found if each is not None]
    return min(known, key=lambda each: each.distance) if len(known) == len(found) else None


def measure(o1: CollisionObject, o2: CollisionObject, is_signed: bool) -> Measure:
    """Returns the distance of two objects; if they share inner points, the number that distance() promises."""
    least = min((nearest(a, b) for a, b in bodies_of(o1, o2)), key=lambda each: each.distance)
    if least.distance > 0 or is_mesh(o1) and is_mesh(o2):
        return least
    found = _deepest(o1, o2) if is_signed else None
    if found is not None:
        return found
    is_touch = all(touch(a, b) for a, b in bodies_of(o1, o2) if meet(a, b))
    return least if is_touch else least._replace(distance=-1.0)
