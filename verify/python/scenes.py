"""Meshes and poses that several tests use."""
import math

import numpy as np

import ecods

TETRAHEDRON = ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]])


def mesh():
    return ecods.Mesh(*TETRAHEDRON)


def at(x, y=0.0, z=0.0):
    return ecods.pose(t=(x, y, z))


def box(x=1.0, y=1.0, z=1.0):
    vertices = [[i, j, k] for i in (0, x) for j in (0, y) for k in (0, z)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return vertices, [f for a, b, c, d in quads for f in ((a, b, c), (a, c, d))]


def turned(angle, t):
    """A turn about z and a translation."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s, 0, t[0]], [s, c, 0, t[1]], [0, 0, 1, t[2]], [0, 0, 0, 1]])


class Trimesh:
    """What the collision manager reads of another library's mesh."""

    def __init__(self, vertices, faces):
        self.vertices = np.array(vertices, dtype=float)
        self.faces = np.array(faces, dtype=np.int64)
