"""Transforms, and objects: geometries at transforms."""
from typing import Any, Optional, Tuple

import numpy as np

from ... import _ecods
from ...refusals import describe
from .data import NODE_TYPE, OBJECT_TYPE
from .geometry import CollisionGeometry


def _quaternion_of(matrix: np.ndarray) -> np.ndarray:
    """Returns the quaternion (w, x, y, z) of a rotation: Shoemake's way, as in Eigen, from the largest of its numbers."""
    trace = np.trace(matrix)
    quaternion = np.zeros(4)
    if trace > 0:
        root = np.sqrt(trace + 1)
        skew = [matrix[(i + 2) % 3, (i + 1) % 3] - matrix[(i + 1) % 3, (i + 2) % 3] for i in range(3)]
        quaternion[0] = 0.5 * root
        quaternion[1:] = np.array(skew) * (0.5 / root)
        return quaternion
    i = int(np.argmax(np.diag(matrix)))
    j, k = (i + 1) % 3, (i + 2) % 3
    root = np.sqrt(matrix[i, i] - matrix[j, j] - matrix[k, k] + 1)
    quaternion[1 + i] = 0.5 * root
    quaternion[0] = (matrix[k, j] - matrix[j, k]) * (0.5 / root)
    quaternion[1 + j] = (matrix[j, i] + matrix[i, j]) * (0.5 / root)
    quaternion[1 + k] = (matrix[k, i] + matrix[i, k]) * (0.5 / root)
    return quaternion


class _Placed:
    """A pose, with python-fcl's calls to read and to set its parts."""
    _pose: np.ndarray

    def getRotation(self) -> np.ndarray:
        """Returns the matrix (3, 3), a copy."""
        return self._pose[:3, :3].copy()

    def getTranslation(self) -> np.ndarray:
        """Returns the translation (3,), a copy."""
        return self._pose[:3, 3].copy()

    def getQuatRotation(self) -> np.ndarray:
        """Returns the rotation as a quaternion (w, x, y, z), rounded."""
        return _quaternion_of(self._pose[:3, :3])

    def setRotation(self, R: Any) -> None:
        """Sets the matrix (3, 3), which is taken as it is. Raises InvalidArgument, and ValueError for other shapes."""
        self._place(_ecods.pose(t=self._pose[:3, 3], R=R))

    def setTranslation(self, T: Any) -> None:
        """Sets the translation (3,). Raises InvalidArgument, and ValueError for other shapes."""
        self._place(_ecods.pose(t=T, R=self._pose[:3, :3]))

    def setQuatRotation(self, q: Any) -> None:
        """Sets the rotation of a quaternion (w, x, y, z), which is not normalised. Raises as setRotation() does."""
        self._place(_ecods.pose(t=self._pose[:3, 3], quaternion=q))

    def _place(self, pose: np.ndarray) -> None:
        self._pose = pose


class Transform(_Placed):
    """A rotation and a translation: Transform(), Transform(rotation, translation), or one of the two, or a Transform.

    A rotation is a matrix (3, 3) or a quaternion (w, x, y, z), as numbers of any sequence; both are taken as they are,
    and nothing is normalised. Raises ValueError for other shapes, and InvalidArgument for numbers that are not finite.
    """

    def __init__(self, *args: Any) -> None:
        if len(args) > 2:
            raise ValueError(f"Transform: {len(args)} arguments are given; a rotation and a translation are expected")
        if len(args) == 1 and isinstance(args[0], Transform):
            self._pose = args[0]._pose.copy()
            return
        arrays = [np.asarray(each) for each in args]
        if len(args) == 2:
            arrays[1] = arrays[1].squeeze()
            if arrays[1].shape != (3,):
                raise ValueError(f"Transform: the translation is {describe(args[1])}, not (3,)")
        named = {(3, 3): "R", (4,): "quaternion", (3,): "t"}
        if len(args) == 2:
            del named[3,]
        if args and arrays[0].shape not in named:
            wanted = "a matrix (3, 3) or a quaternion (4,)" + (", a translation (3,) or a Transform" if len(args) == 1 else "")
            raise ValueError(f"Transform: argument 1 is {describe(args[0])}, not {wanted}")
        parts = {named[arrays[0].shape]: arrays[0]} if args else {}
        if len(args) == 2:
            parts["t"] = arrays[1]
        self._pose = _ecods.pose(**parts)

    def __repr__(self) -> str:
        return f"<Transform of rotation {self._pose[:3, :3].tolist()} and translation {self._pose[:3, 3].tolist()}>"


class CollisionObject(_Placed):
    """A geometry at a transform, which is copied. Raises ValueError if there is no geometry, and TypeError."""

    def __init__(self, geom: Optional[CollisionGeometry] = None, tf: Optional[Transform] = None) -> None:
        if geom is None or type(geom) is CollisionGeometry:
            raise ValueError("CollisionObject: there is no geometry; a Box, a BVHModel or another shape is expected")
        if not isinstance(geom, CollisionGeometry):
            raise TypeError(f"CollisionObject: argument 1 (geom) is {describe(geom)}; a CollisionGeometry is expected")
        self._geometry = geom
        self._moves = 0
        self._body: Optional[Tuple[int, Tuple[Any, ...]]] = None
        self._pose = _ecods.pose()
        if tf is not None:
            self.setTransform(tf)

    def __repr__(self) -> str:
        return f"<CollisionObject of {self._geometry!r} at {self.getTransform()!r}>"

    def getTransform(self) -> Transform:
        """Returns the transform, a copy."""
        return Transform(self.getRotation(), self.getTranslation())

    def setTransform(self, tf: Transform) -> None:
        """Moves the object."""
        if not isinstance(tf, Transform):
            raise TypeError(f"CollisionObject.setTransform: argument 1 (tf) is {describe(tf)}; a Transform is expected")
        self._place(tf._pose.copy())

    def getObjectType(self) -> OBJECT_TYPE:
        """Returns OT_BVH for a mesh, otherwise OT_GEOM."""
        return OBJECT_TYPE.OT_BVH if self.getNodeType() == NODE_TYPE.BV_OBBRSS else OBJECT_TYPE.OT_GEOM

    def getNodeType(self) -> Optional[NODE_TYPE]:
        """Returns the class of the geometry."""
        return self._geometry.getNodeType()

    def computeAABB(self) -> None:
        """Does nothing: no box is kept that could be out of date."""

    def isOccupied(self) -> bool:
        """Returns True: there are no costs here, and FCL's default is a full object."""
        return True

    def isFree(self) -> bool:
        """Returns False, as isOccupied() says."""
        return False

    def isUncertain(self) -> bool:
        """Returns False, as isOccupied() says."""
        return False

    def _place(self, pose: np.ndarray) -> None:
        self._pose = pose
        self._moves += 1

    @property
    def _version(self) -> int:
        """A number that grows with each change of the object or of its geometry."""
        return self._moves + self._geometry._changes
