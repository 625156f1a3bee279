"""Picking with the mouse, and a haptic probe: what does a line from the eye meet first, and what does the tip of a probe
run into as it moves? Nothing slips through an edge or a vertex.
"""
import itertools
import math

import ecods
import numpy as np


def torus(around, along, tube):
    """About z, its circle of radius 1, with vertices on a grid of 2^-20, so that it is the same on every machine."""
    points, faces = [], []
    for angle in (2 * math.pi * i / around for i in range(around)):
        for turn in (2 * math.pi * k / along for k in range(along)):
            distance = 1 + tube * math.cos(turn)
            points.append((distance * math.cos(angle), distance * math.sin(angle), -tube * math.sin(turn)))
    for ring, after in itertools.pairwise([*range(around), 0]):
        for k, following in itertools.pairwise([*range(along), 0]):
            a, b = ring * along + k, ring * along + following
            c, d = after * along + following, after * along + k
            faces += [(a, b, c), (a, c, d)]
    return ecods.Mesh(np.rint(np.array(points) * 2**20) / 2**20, faces)


def text(v):
    return "(" + ", ".join(f"{x:.6f}" for x in v) + ")"


ring = torus(48, 24, 0.35)
cube = ecods.ConvexSolid.hull(list(itertools.product((-0.5, 0.5), repeat=3)))
world = ecods.World()
names = {world.create_body(ring): "torus", world.create_body(cube, ecods.pose(t=(2.25, 0, 0))): "cube"}

print("Picking")
eye = np.array((1, -3, 3))
for target in ((2.25, 0, 0.5), (0, 0, 0), (0, -1, 0)):
    picked = world.first_hit(ecods.Ray(eye, target - eye))
    if picked is None:
        print(f"  towards {text(target)}: nothing")
    else:
        hit = picked.hit
        print(f"  towards {text(target)}: the {names[picked.body]}, triangle {hit.triangle} ({hit.kind}) at {text(hit.point)}")

# A whole picture of rays at once, on two threads; NaN is where there is nothing.
pixels = np.array([(x, y, -1) for y in np.linspace(-1, 1, 11) for x in np.linspace(-1, 1, 23)])
depths, triangles = ecods.first_hits(np.tile((0.0, 0.0, 3.0), (len(pixels), 1)), pixels, ring, threads=2)
for row in np.isfinite(depths).reshape(11, 23):
    print("  " + "".join("#" if hit else "." for hit in row))

# The tip goes in small steps; the segment from its last place to its new one is asked about, so however fast it is, it
# does not get through.
print("A probe")
tip, step = np.array((0.25, -2, 0.125)), np.array((0.015625, 0.03125, -0.00390625))  # a time step of a millisecond
for i in range(1, 101):
    after = tip + step
    if hit := ecods.first_hit(ecods.Segment(tip, after), ring):
        corners = ring.vertices[ring.faces[hit.triangle]]
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        normal /= np.linalg.norm(normal)
        print(f"  step {i} meets triangle {hit.triangle} from its {hit.kind} at {hit.parameter:.6f} of the step, "
              f"at {text(hit.point)}")
        force = -400 * (normal @ (after - hit.point)) * normal  # newtons, of a spring of 400 N/m
        print(f"  force on the hand {text(force)}")
        break
    tip = after
