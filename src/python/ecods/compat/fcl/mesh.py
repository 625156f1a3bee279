"""Meshes, in the steps in which python-fcl makes them."""
from typing import Any, Dict, List

import numpy as np

from ... import _ecods
from .data import NODE_TYPE
from .geometry import CollisionGeometry

EMPTY, BEGUN, PROCESSED = range(3)


class BVHModel(CollisionGeometry):
    """A triangle mesh, which is a surface: an object inside does not touch it. A model of vertices alone is a cloud.

    beginModel(), then addSubModel(), addTriangle() and addVertex(), then endModel(). Raises ValueError for other orders.
    """
    _node_type = NODE_TYPE.BV_OBBRSS

    def __init__(self) -> None:
        super().__init__()
        self._state = EMPTY
        self._triangle_count = 0
        self._parts: List[Any] = []
        self._pieces: List[Any] = []

    def __repr__(self) -> str:
        return f"<BVHModel of {self.num_tries_()} triangles>"

    def num_tries_(self) -> int:
        """Returns the number of triangles."""
        return self._triangle_count

    def buildState(self) -> int:
        """Returns 0 at first, 1 after beginModel(), 2 after endModel()."""
        return self._state

    def beginModel(self, num_tris_: int = 0, num_vertices_: int = 0) -> int:
        """Begins a model; vertices and triangles added before are dropped. Returns 0. The arguments change nothing."""
        self._state, self._triangle_count, self._parts, self._pieces, self._shape = BEGUN, 0, [], [], None
        self._changes += 1
        return 0

    def addVertex(self, x: float, y: float, z: float) -> bool:
        """Adds a vertex that belongs to no triangle. Returns True."""
        return self._add("addVertex", [[x, y, z]], np.empty((0, 3), dtype=np.int64))

    def addTriangle(self, v1: Any, v2: Any, v3: Any) -> bool:
        """Adds a triangle of three points (3,). Returns True."""
        return self._add("addTriangle", [v1, v2, v3], [[0, 1, 2]])

    def addSubModel(self, verts: Any, triangles: Any) -> bool:
        """Adds vertices (n, 3), and triangles (m, 3) of their indices. Returns True. Raises InvalidMesh, ValueError."""
        return self._add("addSubModel", verts, triangles)

    def endModel(self) -> int:
        """Ends the model; questions may use it from now on. Returns 0. Raises ValueError if it is empty."""
        self._check_is_begun("endModel")
        if not self._parts:
            raise ValueError("BVHModel.endModel: the model has no triangles and no vertices")
        starts = np.cumsum([0] + [len(vertices) for vertices, _ in self._parts])
        vertices = np.concatenate([vertices for vertices, _ in self._parts])
        triangles = np.concatenate([triangles + start for (_, triangles), start in zip(self._parts, starts)])
        self._shape = _ecods.Mesh(vertices, triangles) if len(triangles) else _ecods.point_cloud(vertices)
        self._state, self._parts = PROCESSED, []
        self._changes += 1
        return 0

    def _check_is_begun(self, call: str) -> None:
        if self._state != BEGUN:
            reason = "beginModel() comes first" if self._state == EMPTY else "the model has ended; beginModel() begins again"
            raise ValueError(f"BVHModel.{call}: {reason}")

    def _add(self, call: str, vertices: Any, triangles: Any) -> bool:
        self._check_is_begun(call)
        if len(triangles):
            checked = _ecods.Mesh(vertices, triangles)
            self._parts.append((checked.vertices, checked.faces.astype(np.int64)))
        else:
            self._parts.append((_ecods.point_cloud(vertices).vertices, np.empty((0, 3), dtype=np.int64)))
        self._triangle_count += len(triangles)
        return True

    def pieces(self) -> List[Any]:
        """Returns the parts whose triangles are connected by vertices: a Mesh of each, and its triangles' numbers (n,)."""
        if not self._pieces:
            vertices, faces = self._shape.vertices, self._shape.faces
            roots = _connected(len(vertices), faces)[faces[:, 0]]
            order = np.argsort(roots, kind="stable")
            groups = np.split(order, np.flatnonzero(np.diff(roots[order])) + 1)
            self._pieces = [(_ecods.Mesh(vertices, faces[group]), group) for group in groups]
        return self._pieces


def _connected(vertex_count: int, faces: np.ndarray) -> np.ndarray:
    """Returns, by vertex, the number of its connected component, by union-find over the triangles."""
    parent: Dict[int, int] = {}

    def root(i: int) -> int:
        while parent.setdefault(i, i) != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    for a, b, c in faces.tolist():
        first = root(a)
        parent[root(b)] = first
        parent[root(c)] = first
    return np.array([root(i) for i in range(vertex_count)])
