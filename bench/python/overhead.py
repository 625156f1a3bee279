#!/usr/bin/env python3
"""What Python adds: collide_many and distance_many beside the same loop in C++, and single calls beside collide_many.

usage: PYTHONPATH=build/release/python python3 bench/python/overhead.py build/release/bench/ecods_python_loop
"""
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import ecods

POSES, ROUNDS = 20000, 7


def sphere(rings=16):
    """A round mesh of 2 * rings * (rings - 1) triangles."""
    vertices = [(0, 0, 1), (0, 0, -1)]
    for i in range(1, rings):
        for j in range(rings):
            up, around = np.pi * i / rings, 2 * np.pi * j / rings
            vertices.append((np.sin(up) * np.cos(around), np.sin(up) * np.sin(around), np.cos(up)))

    def at(i, j):
        return 0 if i == 0 else 1 if i == rings else 2 + (i - 1) * rings + j % rings

    faces = [f for i in range(rings) for j in range(rings)
             for f in ((at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1)))
             if len(set(f)) == 3]
    return np.array(vertices, float), np.array(faces, np.uint32)


def random_poses(count, rng):
    q, _ = np.linalg.qr(rng.normal(size=(count, 3, 3)))
    poses = np.tile(np.eye(4), (count, 1, 1))
    poses[:, :3, :3] = q
    direction = rng.normal(size=(count, 3))
    length = rng.uniform(1.8, 2.2, size=(count, 1))
    poses[:, :3, 3] = direction / np.linalg.norm(direction, axis=1, keepdims=True) * length
    return poses


def seconds(call):
    begin = time.perf_counter()
    call()
    return time.perf_counter() - begin


def main(loop):
    vertices, faces = sphere()
    poses = random_poses(POSES, np.random.default_rng(1))
    mesh = ecods.Mesh(vertices, faces)
    ratios = {"collide_many": [], "distance_many": []}
    times = {name: [] for name in ratios}
    with tempfile.NamedTemporaryFile() as scene:
        for array in (vertices, faces, poses):
            scene.write(np.uint64(array.size).tobytes() + array.tobytes())
        scene.flush()
        for _ in range(ROUNDS):
            cpp = subprocess.run([loop, scene.name], check=True, capture_output=True, text=True).stdout.split()
            for k, (name, call) in enumerate((("collide_many", ecods.collide_many), ("distance_many", ecods.distance_many))):
                best = min(seconds(lambda: call(mesh, poses, mesh)) for _ in range(3))
                times[name].append(best)
                ratios[name].append(best / min(float(x) for x in cpp[k::2]))
    for name, each in ratios.items():
        print(f"{name}: {statistics.median(times[name]) / POSES * 1e6:.2f} us a pose, "
              f"{statistics.median(each):.2f} times the loop in C++ (from {min(each):.2f} to {max(each):.2f})")

    def one_by_one():
        for pose in poses:
            ecods.intersects(mesh.at(pose), mesh)

    posed, far = mesh.at(poses[0]), mesh.at(ecods.pose(t=(9, 0, 0)))
    single = statistics.median(seconds(one_by_one) for _ in range(3))
    print(f"a call of intersects and of Mesh.at more than in collide_many: "
          f"{(single - statistics.median(times['collide_many'])) / POSES * 1e6:.2f} us")
    call = statistics.median(seconds(lambda: [ecods.intersects(posed, far) for _ in range(POSES)]) for _ in range(5))
    print(f"a call of intersects of what is far apart: {call / POSES * 1e6:.2f} us")


if __name__ == "__main__":
    main(sys.argv[1])
