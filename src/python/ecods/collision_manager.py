"""Collisions and signed distances of named bodies, with the calls of trimesh's collision manager."""
import math
from typing import Any, Dict, Hashable, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _ecods
from .refusals import describe

EXTERNAL = "__external"


def _as_convex(vertices, faces):
    """Returns the ConvexSolid of a mesh that is convex up to rounding: its hull if it has a dent. None if it bounds none."""
    try:
        return _ecods.ConvexSolid(vertices, faces)
    except _ecods.NotSolid as error:
        return _ecods.ConvexSolid.hull(vertices) if error.reason == _ecods.NotSolidReason.dent else None


def as_mesh(mesh: Any) -> Any:
    """Returns the body of a Mesh, an object with `vertices` and `faces`, or a tuple of the two. Raises TypeError.

    If the object is not a Mesh, the body is a ConvexSolid if the object says that it `is_convex` and bounds a solid;
    otherwise it is a surface.
    """
    if isinstance(mesh, _ecods.Mesh):
        return mesh
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        convex = _as_convex(mesh.vertices, mesh.faces) if getattr(mesh, "is_convex", False) else None
        return convex or _ecods.Mesh(mesh.vertices, mesh.faces)
    if not isinstance(mesh, (tuple, list)) or len(mesh) != 2:
        raise TypeError(f"mesh: {describe(mesh)} is no mesh; an ecods.Mesh, an object with `vertices` and `faces`, or the "
                        "two in a tuple is expected")
    return _ecods.Mesh(*mesh)


def _text_of(data, **numbers):
    """Returns the text of a result: names with their faces, then numbers."""
    parts = [f"{name!r}: " + ("no face" if face is None else f"face {face}") for name, face in data._indices.items()]
    return f"{type(data).__name__}({', '.join(parts + [f'{name}={value}' for name, value in numbers.items()])})"


def _faces(names, a, b):
    """Returns the face of each feature, by name; None for a point inside a solid, which is on no feature."""
    return {name: None if feature.kind == _ecods.FeatureKind.none else feature.triangle
            for name, feature in zip(names, (a, b))}


def _signed_distance(a, b):
    """Returns the SignedDistance of two posed ConvexSolids; None for other bodies, and if a pose is singular."""
    if a.mesh.form != _ecods.MeshForm.convex or b.mesh.form != _ecods.MeshForm.convex:
        return None
    try:
        return _ecods.signed_distance(a, b)
    except _ecods.SingularPose:
        return None


class ContactData:
    """A contact of two bodies that share a point. Two ConvexSolids have one contact; other bodies have one for each pair
    of triangles that share a point.

    point: (3,) float. For two ConvexSolids it is the middle of the two points of their SignedDistance, which the shortest
    translation brings together. Otherwise it is a point that both share: the lexicographically least corner of the set
    that two triangles share, or, if no two triangles share a point, a corner of the part that is inside. normal: (3,)
    float, the direction of the depth; for two triangles the unit normal that a face or two edges define there; NaN if
    there is none. depth: the exact depth of two ConvexSolids in each other; otherwise NaN.
    """

    def __init__(self, names, faces, point, normal, depth):
        self.names = set(names)
        self._indices = faces
        self.point = point
        self.normal = np.full(3, np.nan) if normal is None else normal
        self.depth = depth

    def __repr__(self) -> str:
        return _text_of(self, point=self.point.tolist(), normal=self.normal.tolist(), depth=self.depth)

    def index(self, name: Hashable) -> Optional[int]:
        """The index of the face of the mesh with that name; None if the point is inside it, and on no face."""
        return self._indices[name]


class DistanceData:
    """Two points of two bodies, and their signed distance: negative is how deep two ConvexSolids are in each other.

    The points are the closest ones. If two ConvexSolids share a point, they are the two points that the shortest
    translation brings together. If other bodies share a point, both are one shared point.
    """

    def __init__(self, names, a, b):
        at = _signed_distance(a, b) or _ecods.closest(a, b)
        self.names = set(names)
        self.distance = at.distance
        self._indices = _faces(names, at.a, at.b)
        self._points = dict(zip(names, (at.point_a, at.point_b)))

    def __repr__(self) -> str:
        return _text_of(self, distance=self.distance, points=[point.tolist() for point in self._points.values()])

    def index(self, name: Hashable) -> Optional[int]:
        """The index of the closest face of the mesh with that name; None if the point is inside it, and on no face."""
        return self._indices[name]

    def point(self, name: Hashable) -> np.ndarray:
        """The closest point (3,) of the mesh with that name."""
        return self._points[name]


def _contacts(names, a, b):
    """Returns the list of ContactData of two posed bodies that share a point."""
    deep = _signed_distance(a, b)
    if deep is not None:
        middle = 0.5 * deep.point_a + 0.5 * deep.point_b
        return [ContactData(names, _faces(names, deep.a, deep.b), middle, deep.direction, 0.0 - deep.distance)]
    shared = _ecods.intersections(a, b)
    if not shared:
        inner = _ecods.closest(a, b)
        return [ContactData(names, _faces(names, inner.a, inner.b), inner.point_a, None, math.nan)]
    return [ContactData(names, dict(zip(names, each.triangles)), each.corners[0], each.normal, math.nan)
            for each in shared]


def _signed(a, b):
    """Returns the signed distance of two posed bodies that share a point."""
    deep = _signed_distance(a, b)
    return 0.0 if deep is None else deep.distance


def _answer(first, *rest):
    """Returns `first`, or a tuple of `first` and the wanted values in `rest`, which has pairs (is_wanted, value)."""
    wanted = [what for is_wanted, what in rest if is_wanted]
    return (first, *wanted) if wanted else first


class CollisionManager:
    """Named bodies: which collide, and how far are they apart, or how deep in each other?

    The methods have the names and arguments of trimesh.collision.CollisionManager. A mesh that says that it `is_convex`,
    as a watertight convex mesh of trimesh does, becomes a ConvexSolid; if rounding has left a dent, its convex hull does.
    Other meshes are surfaces; an ecods.Solid is a solid, too. A body inside a solid collides with it, and touching counts.
    Answers are exact, and a distance is the true one, rounded once: infinity if there is nothing to measure to; 0 if two
    bodies share a point, but minus their depth if both are ConvexSolids. If there are several distances, the least is
    given. To ask about an object again, pass an ecods.Mesh or ecods.ConvexSolid in its place, which is made only once.
    Names are any hashable values. Copies and pickles work as those of a World.
    """

    def __init__(self, threads: int = 1) -> None:
        self._world = _ecods.World(threads=threads)
        self._bodies: Dict[Hashable, int] = {}
        self._names: Dict[int, Hashable] = {}

    def __repr__(self) -> str:
        names = ", ".join(repr(name) for name in list(self._bodies)[:3]) + (", ..." if len(self._bodies) > 3 else "")
        return f"<ecods.CollisionManager of {len(self._bodies)} meshes{': ' if names else ''}{names}>"

    def _body(self, name):
        if name not in self._bodies:
            raise ValueError(f"{name} not in collision manager!")
        return self._bodies[name]

    def _names_in_order(self, bodies):
        """Returns names sorted, as trimesh does; names without an order, as an int and a str, in the order of adding."""
        names = tuple(self._names[body] for body in sorted(bodies))
        try:
            return tuple(sorted(names))
        except TypeError:
            return names

    def _posed(self):
        return [(name, self._world.posed(body)) for name, body in self._bodies.items()]

    def add_object(self, name: Hashable, mesh: Any, transform: Optional[ArrayLike] = None) -> None:
        """Adds a mesh at a transform (4, 4); replaces an object of the same name. Raises TypeError, InvalidMesh."""
        body = self._world.create_body(as_mesh(mesh), transform)
        if name in self._bodies:
            self.remove_object(name)
        self._bodies[name] = body
        self._names[body] = name

    def remove_object(self, name: Hashable) -> None:
        """Removes the object with that name. Raises ValueError if there is none."""
        body = self._body(name)
        self._world.destroy_body(body)
        del self._bodies[name], self._names[body]

    def set_transform(self, name: Hashable, transform: ArrayLike) -> None:
        """Moves the object with that name to a transform (4, 4). Raises ValueError if there is none."""
        self._world.set_pose(self._body(name), transform)

    def in_collision_single(self, mesh: Any, transform: Optional[ArrayLike] = None, return_names: bool = False,
                            return_data: bool = False) -> Any:
        """Returns True if a mesh collides with any object; on demand also the objects' names and a list of ContactData."""
        external = as_mesh(mesh).at(transform)
        bodies = self._world.intersecting_bodies(external)
        names = {self._names[body] for body in bodies}
        data = []
        if return_data:
            for body in bodies:
                data += _contacts((self._names[body], EXTERNAL), self._world.posed(body), external)
        return _answer(len(bodies) > 0, (return_names, names), (return_data, data))

    def in_collision_internal(self, return_names: bool = False, return_data: bool = False) -> Any:
        """Returns True if any two objects collide; on demand also pairs of names, sorted, and a list of ContactData."""
        self._world.update()
        pairs = self._world.colliding_pairs()
        names, data = set(), []
        for a, b in pairs:
            pair = (self._names[a], self._names[b])
            names.add(self._names_in_order((a, b)))
            if return_data:
                data += _contacts(pair, self._world.posed(a), self._world.posed(b))
        return _answer(len(pairs) > 0, (return_names, names), (return_data, data))

    def in_collision_other(self, other_manager: "CollisionManager", return_names: bool = False,
                           return_data: bool = False) -> Any:
        """Returns True if an object collides with an object of another manager; pairs of names begin with this manager's."""
        names, data = set(), []
        for other_name, other in other_manager._posed():
            for body in self._world.intersecting_bodies(other):
                names.add((self._names[body], other_name))
                if return_data:
                    data += _contacts((self._names[body], other_name), self._world.posed(body), other)
        return _answer(len(names) > 0, (return_names, names), (return_data, data))

    def _nearest(self, what, limit=math.inf):
        """Returns the least signed distance, within the limit, of a posed body from an object, and that body; or None.

        If distances are equal, the least body is returned.
        """
        nearest = self._world.nearest(what, max_distance=max(limit, 0.0))
        if nearest is None or nearest.distance > 0:
            return None if nearest is None else (nearest.distance, nearest.body)
        return min((_signed(self._world.posed(body), what), body) for body in self._world.intersecting_bodies(what).tolist())

    def _nearest_to(self, body):
        """Returns the least signed distance of an object from the others, and the bodies; or None."""
        nearest = self._world.nearest(body)
        if nearest is None or nearest.distance > 0:
            return None if nearest is None else (nearest.distance, (body, nearest.body))
        return min((_signed(self._world.posed(body), self._world.posed(other)), (body, other))
                   for other in self._world.intersecting_bodies(body).tolist())

    def _closest_pair(self):
        """Returns the least signed distance of two objects, and the bodies; or None."""
        closest = self._world.closest_pair()
        return None if closest is None else (closest.distance, closest.bodies)

    def min_distance_single(self, mesh: Any, transform: Optional[ArrayLike] = None, return_name: bool = False,
                            return_data: bool = False) -> Any:
        """Returns the least distance of a mesh from any object; on demand also the object's name, and the DistanceData."""
        external = as_mesh(mesh).at(transform)
        nearest = self._nearest(external)
        if nearest is None:
            return _answer(math.inf, (return_name, None), (return_data, None))
        distance, body = nearest
        name = self._names[body]
        data = None
        if return_data:
            data = DistanceData((name, EXTERNAL), self._world.posed(body), external)
        return _answer(distance, (return_name, name), (return_data, data))

    def min_distance_internal(self, name: Optional[Hashable] = None, return_names: bool = False,
                              return_data: bool = False) -> Any:
        """Returns the least distance of two objects, or of the named one from the others; on demand also names and data."""
        found = self._closest_pair() if name is None else self._nearest_to(self._body(name))
        if found is None:
            return _answer(math.inf, (return_names, None), (return_data, None))
        distance, bodies = found
        pair = tuple(self._names[body] for body in bodies)
        data = DistanceData(pair, *map(self._world.posed, bodies)) if return_data else None
        return _answer(distance, (return_names, self._names_in_order(bodies)), (return_data, data))

    def min_distance_other(self, other_manager: "CollisionManager", return_names: bool = False,
                           return_data: bool = False) -> Any:
        """Returns the least distance from the objects of another manager; names begin with this manager's."""
        best, pair, data = math.inf, None, None
        closest: Any = None
        for other_name, other in other_manager._posed():
            nearest = self._nearest(other, best)
            if nearest is not None and (pair is None or nearest[0] < best):
                best, pair = nearest[0], (self._names[nearest[1]], other_name)
                closest = self._world.posed(nearest[1]), other
        if return_data and pair is not None:
            data = DistanceData(pair, *closest)
        return _answer(best, (return_names, pair), (return_data, data))
