#!/usr/bin/env python3
"""A collision engine for ecods_fuzz --engine-command: every pair of triangles, by separating axes, in Python's floats.

README.md beside this file describes the lines that are exchanged. What is wrong here on purpose: nothing. Floats round,
and that is enough.
"""
import json
import sys


def sub(p, q):
    return [p[0] - q[0], p[1] - q[1], p[2] - q[2]]


def cross(p, q):
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def triangles_at(mesh, body):
    """The mesh's triangles, posed: R v + t, rounded."""
    points = [[dot(row, v) + shift for row, shift in zip(body["R"], body["t"])] for v in mesh["vertices"]]
    return [[points[i] for i in triangle] for triangle in mesh["triangles"]]


def box(triangle):
    return [(min(column), max(column)) for column in zip(*triangle)]


def is_separating(axis, one, other):
    first = [dot(axis, p) for p in one]
    second = [dot(axis, p) for p in other]
    return max(first) < min(second) or max(second) < min(first)


def triangles_meet(one, other):
    sides = [[sub(t[1], t[0]), sub(t[2], t[1]), sub(t[0], t[2])] for t in (one, other)]
    normals = [cross(s[0], s[1]) for s in sides]
    axes = normals + [cross(p, q) for p in sides[0] for q in sides[1]]
    axes += [cross(n, side) for n, own in zip(normals, sides) for side in own]  # for two in one plane
    return not any(is_separating(axis, one, other) for axis in axes)


def meshes_meet(one, other):
    boxed = [(box(t), t) for t in other]
    for triangle in one:
        own = box(triangle)
        for their, candidate in boxed:
            if all(a[0] <= b[1] and b[0] <= a[1] for a, b in zip(own, their)) and triangles_meet(triangle, candidate):
                return True
    return False


def main():
    meshes = {}
    for line in sys.stdin:
        message = json.loads(line)
        if "mesh" in message:
            meshes[message["mesh"]] = message
        else:
            posed = [triangles_at(meshes[body["mesh"]], body) for body in (message["a"], message["b"])]
            print(json.dumps({"query": message["query"], "intersects": meshes_meet(*posed)}), flush=True)


if __name__ == "__main__":
    main()
