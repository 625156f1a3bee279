"""Geometries that are made of a few numbers, and convex polytopes."""
import warnings
from typing import Any, Callable, Dict, Optional

import numpy as np

from ... import _ecods
from ...refusals import describe, is_index
from .data import NODE_TYPE


def box_of(shape: Any, pose: Optional[np.ndarray]) -> np.ndarray:
    """Returns a box (2, 3) around a shape, or around the intersection of two half spaces. Its ends may be infinite."""
    if not isinstance(shape, tuple):
        return shape.box(pose)
    boxes = np.array([side.box(pose) for side in shape])
    return np.array([boxes[:, 0].max(axis=0), boxes[:, 1].min(axis=0)])


class PolytopeWarning(UserWarning):
    """Warns that a polytope around a curved body stands for the body. The text says how far it reaches beyond the body."""


class CollisionGeometry:
    """The base of all geometries. By itself it has no shape."""
    _node_type: Optional[NODE_TYPE] = None

    def __init__(self) -> None:
        self._changes = 0
        self._shape: Any = None

    def __repr__(self) -> str:
        return f"<{type(self).__name__} without a shape>"

    @property
    def shape(self) -> Any:
        """The ecods.ConvexSolid, Rounded, Mesh or HalfSpace of the geometry; two half spaces of a Plane; None if it has none."""
        return self._shape

    @property
    def aabb_center(self) -> Optional[np.ndarray]:
        """The middle of a box around the geometry; 0 along axes on which it has no end; None if there is no shape."""
        if self._shape is None:
            return None
        box = box_of(self._shape, None)
        low, high = np.where(np.isfinite(box).all(axis=0), box, 0.0)
        return 0.5 * low + 0.5 * high

    def getNodeType(self) -> Optional[NODE_TYPE]:
        """Returns the class of the geometry; None for a CollisionGeometry."""
        return self._node_type

    def computeLocalAABB(self) -> None:
        """Does nothing: no box is kept that could be out of date."""


def _copied(value: Any) -> Any:
    return value.copy() if isinstance(value, np.ndarray) else value


def _value(name: str, text: str) -> Any:
    """Makes a property for a number of a geometry. Setting it makes another shape, or raises and changes nothing."""

    def get(self: "_Numbers") -> Any:
        return _copied(self._values[name])

    def set(self: "_Numbers", value: Any) -> None:
        self._assign(**{name: value})

    return property(get, set, doc=text)


class _Numbers(CollisionGeometry):
    """A geometry that is made of numbers, which can be changed."""
    _build: Callable[..., Any]

    def __init__(self) -> None:
        super().__init__()
        self._values: Dict[str, Any] = {}

    def __repr__(self) -> str:
        values = ", ".join(f"{name}={np.asarray(value).tolist()}" for name, value in self._values.items())
        return f"{type(self).__name__}({values})"

    def _assign(self, **values: Any) -> None:
        values = {**self._values, **values}
        self._shape = self._build(**values)
        self._values = {name: np.array(value, dtype=float) if np.ndim(value) else value for name, value in values.items()}
        self._changes += 1


class TriangleP(_Numbers):
    """A triangle of three points (3,). A triangle without area is the segment or the point that it spans."""
    _node_type = NODE_TYPE.GEOM_TRIANGLE
    a = _value("a", "The first corner (3,).")
    b = _value("b", "The second corner (3,).")
    c = _value("c", "The third corner (3,).")

    def __init__(self, a: Any, b: Any, c: Any) -> None:
        super().__init__()
        self._assign(a=a, b=b, c=c)

    def _build(self, a: Any, b: Any, c: Any) -> Any:
        return _ecods.Rounded(_ecods.Mesh([a, b, c], [[0, 1, 2]]), 0.0)


class Box(_Numbers):
    """A box of these side lengths, centered at the origin: exact. Raises InvalidArgument."""
    _node_type = NODE_TYPE.GEOM_BOX
    side = _value("side", "The side lengths (3,).")

    def __init__(self, x: float, y: float, z: float) -> None:
        super().__init__()
        self._assign(side=(x, y, z))

    def _build(self, side: Any) -> Any:
        return _ecods.box(side)


class Sphere(_Numbers):
    """A ball around the origin: exact. Raises InvalidArgument."""
    _node_type = NODE_TYPE.GEOM_SPHERE
    radius = _value("radius", "The radius.")

    def __init__(self, radius: float) -> None:
        super().__init__()
        self._assign(radius=radius)

    def _build(self, radius: float) -> Any:
        return _ecods.sphere(radius)


class Capsule(_Numbers):
    """All points within the radius of a segment of length lz along z, centered at the origin: exact. Raises InvalidArgument."""
    _node_type = NODE_TYPE.GEOM_CAPSULE
    radius = _value("radius", "The radius.")
    lz = _value("lz", "The length of the segment.")

    def __init__(self, radius: float, lz: float) -> None:
        super().__init__()
        self._assign(radius=radius, lz=lz)

    def _build(self, radius: float, lz: float) -> Any:
        return _ecods.capsule([0, 0, -0.5 * lz], [0, 0, 0.5 * lz], radius)


class _Curved(_Numbers):
    """A geometry that is represented by a polytope which contains it."""
    deviation: float

    def _assign(self, **values: Any) -> None:
        super()._assign(**values)
        made, self.deviation = self._shape, 0.0
        if isinstance(made, _ecods.Circumscribed):
            self._shape, self.deviation = made.solid, made.deviation
            warnings.warn(f"{self!r} is answered as a polytope of {len(made.solid.vertices)} vertices around it, whose points "
                          f"are up to {made.deviation:.2g} away from it", PolytopeWarning, stacklevel=3)


class _Around(_Curved):
    """A polytope around a body that is round about the z axis; _make is the builder."""
    radius = _value("radius", "The radius, of a cone that of its disc.")
    lz = _value("lz", "The height.")
    sides = _value("sides", "The number of sides.")
    _make: Callable[[float, float, int], Any]

    def __init__(self, radius: float, lz: float, sides: int = 64) -> None:
        super().__init__()
        self._assign(radius=radius, lz=lz, sides=sides)

    def _build(self, radius: float, lz: float, sides: int) -> Any:
        return self._make(radius, lz, sides)


class Cylinder(_Around):
    """A prism around a cylinder along z, centered at the origin. An object that is apart from it is apart from the cylinder.

    `sides` is not an argument of python-fcl's: the prism's number of sides, from 3 to 16384. deviation: no point of the
    prism is farther from the cylinder, 0.12 % of the radius with 64 sides. Issues a PolytopeWarning. Raises
    InvalidArgument.
    """
    _node_type = NODE_TYPE.GEOM_CYLINDER
    _make = staticmethod(_ecods.cylinder)


class Cone(_Around):
    """A pyramid around a cone along z, with its apex at lz / 2 and its disc at -lz / 2; otherwise as a Cylinder."""
    _node_type = NODE_TYPE.GEOM_CONE
    _make = staticmethod(_ecods.cone)


class Ellipsoid(_Curved):
    """A polytope around an ellipsoid with the half axes a, b and c, centered at the origin; exact if these are equal.

    `subdivisions` is not an argument of python-fcl's: 0 to 6, see ecods.ellipsoid. deviation: no point of the polytope
    is farther from the ellipsoid, 0.11 % of the longest half axis with 4 subdivisions. Issues a PolytopeWarning unless
    it is exact. Raises InvalidArgument.
    """
    _node_type = NODE_TYPE.GEOM_ELLIPSOID
    radii = _value("radii", "The half axes (3,).")
    subdivisions = _value("subdivisions", "How often triangles of an icosahedron are divided into four.")

    def __init__(self, a: float, b: float, c: float, subdivisions: int = 4) -> None:
        super().__init__()
        self._assign(radii=(a, b, c), subdivisions=subdivisions)

    def _build(self, radii: Any, subdivisions: int) -> Any:
        is_ball = radii[0] == radii[1] == radii[2]
        return _ecods.sphere(radii[0]) if is_ball else _ecods.ellipsoid(radii, subdivisions)


class _Flat(_Numbers):
    """A geometry that is given by n and d."""
    n = _value("n", "The normal (3,), as given; it points out of a half space.")
    d = _value("d", "The offset, as given.")

    def __init__(self, n: Any, d: float) -> None:
        super().__init__()
        self._assign(n=n, d=d)


class Halfspace(_Flat):
    """The points x with n . x <= d. n need not be a unit vector: it is used as given. Raises InvalidArgument."""
    _node_type = NODE_TYPE.GEOM_HALFSPACE

    def _build(self, n: Any, d: float) -> Any:
        return _ecods.HalfSpace(n, d)


class Plane(_Flat):
    """The points x with n . x = d, as the intersection of the half spaces on both sides. Raises InvalidArgument."""
    _node_type = NODE_TYPE.GEOM_PLANE

    def _build(self, n: Any, d: float) -> Any:
        return _ecods.HalfSpace(n, d), _ecods.HalfSpace(-np.asarray(n, dtype=float), -d)


def _triangles_of(num_faces: int, faces: Any) -> np.ndarray:
    """Returns triangles (m, 3) of polygons. Each polygon is given as its number of corners, followed by their indices."""
    numbers = np.asarray(faces).ravel()
    if numbers.dtype.kind not in "iu":
        whole = numbers.astype(np.int64)
        if not np.array_equal(whole, numbers):
            raise ValueError("Convex: argument 3 (faces) has numbers that are not whole")
        numbers = whole
    made, at = [], 0
    for face in range(num_faces):
        count = int(numbers[at]) if at < len(numbers) else 0
        corners = numbers[at + 1:at + 1 + count]
        if count < 3 or len(corners) < count:
            raise ValueError(f"Convex: face {face} begins at number {at} of argument 3 (faces), which has {len(numbers)}; "
                             "a count of at least 3 and as many indices are expected there")
        made += [(corners[0], corners[i], corners[i + 1]) for i in range(1, count - 1)]
        at += 1 + count
    if at != len(numbers):
        raise ValueError(f"Convex: argument 3 (faces) has {len(numbers)} numbers; {num_faces} faces end after {at}")
    return np.array(made, dtype=np.int64).reshape(-1, 3)


class Convex(CollisionGeometry):
    """The convex polytope of these vertices (n, 3): their hull.

    faces: for each of the num_faces polygons its number of corners, and then their indices. If they bound a convex
    solid with all vertices as corners, the shape has its triangles; otherwise, e.g. after rounding, those of the hull. Raises
    ValueError for bad lists; InvalidMesh, NotSolid.
    """
    _node_type = NODE_TYPE.GEOM_CONVEX

    def __init__(self, vertices: Any, num_faces: int, faces: Any) -> None:
        super().__init__()
        if not is_index(num_faces):
            raise TypeError(f"Convex: argument 2 (num_faces) is {describe(num_faces)}; a whole number is expected")
        self._num_faces = int(num_faces)
        self._shape = self._solid(np.asarray(vertices, dtype=float), _triangles_of(self._num_faces, faces))

    def __repr__(self) -> str:
        return f"<Convex of {len(self._shape.vertices)} vertices, {self._num_faces} faces>"

    @staticmethod
    def _solid(vertices: np.ndarray, triangles: np.ndarray) -> Any:
        try:
            solid = _ecods.ConvexSolid(vertices, triangles)
        except _ecods.NotSolid:
            return _ecods.ConvexSolid.hull(vertices)
        return solid if solid.uses_all_vertices else _ecods.ConvexSolid.hull(vertices)

    @property
    def num_faces(self) -> int:
        """The number of faces, as given."""
        return self._num_faces


class OcTree(CollisionGeometry):
    """An octree, which ECoDS does not have."""

    def __init__(self, r: float, data: Any) -> None:
        raise NotImplementedError("OcTree: ECoDS has no octrees; a BVHModel of the surface, or ecods.point_cloud, may do")
