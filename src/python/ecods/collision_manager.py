"""Collisions and distances of named meshes, with the calls of trimesh's collision manager; answers are about surfaces."""
import math

import numpy as np

from . import _ecods
from .refusals import describe

EXTERNAL = "__external"


def as_mesh(mesh):
    """Returns the Mesh of a Mesh, an object with `vertices` and `faces`, or a tuple of the two. Raises TypeError."""
    if isinstance(mesh, _ecods.Mesh):
        return mesh
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return _ecods.Mesh(mesh.vertices, mesh.faces)
    if not isinstance(mesh, (tuple, list)) or len(mesh) != 2:
        raise TypeError(f"mesh: {describe(mesh)} is no mesh; an ecods.Mesh, an object with `vertices` and `faces`, or the "
                        "two in a tuple is expected")
    return _ecods.Mesh(*mesh)


def _text_of(data, **numbers):
    """Returns the text of a result: names with their faces, then numbers."""
    parts = [f"{name!r}: face {face}" for name, face in data._indices.items()]
    return f"{type(data).__name__}({', '.join(parts + [f'{name}={value}' for name, value in numbers.items()])})"


class ContactData:
    """Two triangles that share a point.

    point: (3,) float, the least corner of the shared points. normal: (3,) float, the unit normal that a face or two
    edges define there, or the direction of the depth; NaN if there is none. depth: the exact depth of two ConvexSolids in
    each other; otherwise NaN, as two surfaces have no depth.
    """

    def __init__(self, names, contact, depth):
        self.names = set(names)
        self._indices = dict(zip(names, contact.triangles))
        self.point = contact.corners[0]
        normal = contact.normal if depth is None else depth.direction
        self.normal = np.full(3, np.nan) if normal is None else normal
        self.depth = math.nan if depth is None else depth.depth

    def __repr__(self):
        return _text_of(self, point=self.point.tolist(), normal=self.normal.tolist(), depth=self.depth)

    def index(self, name):
        """The index of the face of the mesh with that name."""
        return self._indices[name]


class DistanceData:
    """The closest points of two meshes, and the distance."""

    def __init__(self, names, closest):
        self.names = set(names)
        self.distance = closest.distance
        self._indices = dict(zip(names, closest.triangles))
        self._points = dict(zip(names, (closest.point_a, closest.point_b)))

    def __repr__(self):
        return _text_of(self, distance=self.distance, points=[point.tolist() for point in self._points.values()])

    def index(self, name):
        """The index of the closest face of the mesh with that name."""
        return self._indices[name]

    def point(self, name):
        """The closest point (3,) of the mesh with that name."""
        return self._points[name]


def _contacts(names, a, b):
    depth = None
    if isinstance(a.mesh, _ecods.ConvexSolid) and isinstance(b.mesh, _ecods.ConvexSolid):
        depth = _ecods.depth(a, b)
    return [ContactData(names, contact, depth) for contact in _ecods.intersections(a, b)]


def _answer(first, *rest):
    """Returns `first`, or a tuple of `first` and the wanted values in `rest`, which has pairs (is_wanted, value)."""
    wanted = [what for is_wanted, what in rest if is_wanted]
    return (first, *wanted) if wanted else first


class CollisionManager:
    """Named meshes: which collide, and how far are they apart?

    The methods have the names and arguments of trimesh.collision.CollisionManager. Answers are exact, and about
    surfaces: touching counts, and a distance is the true one, rounded once; 0 if surfaces share a point, never
    negative, infinity if there is nothing to measure to. A mesh inside another mesh does not collide with that, even if
    trimesh would take a convex mesh for a solid; solid_relation() and World.set_solids() say what is inside. Contacts
    are all pairs of triangles that meet; their depth is NaN but for two ConvexSolids. Pass an ecods.Mesh in place of
    another object if you ask about it again: its tree is then made once. Names are any hashable values. Copies and
    pickles work as those of a World.
    """

    def __init__(self, threads=1):
        self._world = _ecods.World(threads=threads)
        self._bodies = {}
        self._names = {}

    def __repr__(self):
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

    def add_object(self, name, mesh, transform=None):
        """Adds a mesh at a transform (4, 4); replaces an object of the same name."""
        body = self._world.create_body(as_mesh(mesh), transform)
        if name in self._bodies:
            self.remove_object(name)
        self._bodies[name] = body
        self._names[body] = name

    def remove_object(self, name):
        """Removes the object with that name. Raises ValueError if there is none."""
        body = self._body(name)
        self._world.destroy_body(body)
        del self._bodies[name], self._names[body]

    def set_transform(self, name, transform):
        """Moves the object with that name to a transform (4, 4). Raises ValueError if there is none."""
        self._world.set_pose(self._body(name), transform)

    def in_collision_single(self, mesh, transform=None, return_names=False, return_data=False):
        """Returns True if a mesh collides with any object; on demand also the objects' names and a list of ContactData."""
        external = as_mesh(mesh).at(transform)
        bodies = self._world.intersecting_bodies(external)
        names = {self._names[body] for body in bodies}
        data = []
        if return_data:
            for body in bodies:
                data += _contacts((self._names[body], EXTERNAL), self._world.posed(body), external)
        return _answer(len(bodies) > 0, (return_names, names), (return_data, data))

    def in_collision_internal(self, return_names=False, return_data=False):
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

    def in_collision_other(self, other_manager, return_names=False, return_data=False):
        """Returns True if an object collides with an object of another manager; pairs of names begin with this manager's."""
        names, data = set(), []
        for other_name, other in other_manager._posed():
            for body in self._world.intersecting_bodies(other):
                names.add((self._names[body], other_name))
                if return_data:
                    data += _contacts((self._names[body], other_name), self._world.posed(body), other)
        return _answer(len(names) > 0, (return_names, names), (return_data, data))

    def min_distance_single(self, mesh, transform=None, return_name=False, return_data=False):
        """Returns the least distance of a mesh from any object; on demand also the object's name, and the DistanceData."""
        external = as_mesh(mesh).at(transform)
        nearest = self._world.nearest(external)
        if nearest is None:
            return _answer(math.inf, (return_name, None), (return_data, None))
        name = self._names[nearest.body]
        data = None
        if return_data:
            data = DistanceData((name, EXTERNAL), _ecods.closest(self._world.posed(nearest.body), external))
        return _answer(nearest.distance, (return_name, name), (return_data, data))

    def min_distance_internal(self, name=None, return_names=False, return_data=False):
        """Returns the least distance of two objects, or of the named one from the others; on demand also names and data."""
        if name is None:
            closest = self._world.closest_pair()
            bodies = None if closest is None else closest.bodies
        else:
            closest = self._world.nearest(self._body(name))
            bodies = None if closest is None else (self._body(name), closest.body)
        if bodies is None:
            return _answer(math.inf, (return_names, None), (return_data, None))
        pair = tuple(self._names[body] for body in bodies)
        data = DistanceData(pair, self._world.closest(*bodies)) if return_data else None
        return _answer(closest.distance, (return_names, self._names_in_order(bodies)), (return_data, data))

    def min_distance_other(self, other_manager, return_names=False, return_data=False):
        """Returns the least distance from the objects of another manager; names begin with this manager's."""
        best, pair, other_posed = math.inf, None, None
        for other_name, other in other_manager._posed():
            nearest = self._world.nearest(other, max_distance=best)
            if nearest is not None and (pair is None or nearest.distance < best):
                best, pair, other_posed = nearest.distance, (self._names[nearest.body], other_name), other
        data = None
        if return_data and pair is not None:
            data = DistanceData(pair, _ecods.closest(self._world.posed(self._bodies[pair[0]]), other_posed))
        return _answer(best, (return_names, pair), (return_data, data))
