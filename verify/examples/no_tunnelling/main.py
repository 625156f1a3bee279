"""A ball that flies through a thin wall between two frames: looking at the frames shows nothing, asking about the way
does, with the time of contact.
"""
import itertools
import math

import ecods
import numpy as np


def ball(around, along):
    """A sphere of radius 1: poles, and rings of vertices on a grid of 2^-20, so that it is the same on every machine."""
    points, faces = [(0, 0, -1)], []
    for band in range(1, along):
        latitude = math.pi * band / along
        for i in range(around):
            angle = 2 * math.pi * i / around
            points.append((math.sin(latitude) * math.cos(angle), math.sin(latitude) * math.sin(angle),
                           -math.cos(latitude)))
    points.append((0, 0, 1))
    top = len(points) - 1
    for i, j in itertools.pairwise([*range(around), 0]):
        faces.append((0, 1 + j, 1 + i))
        for ring in range(1, top - around, around):
            a, b, c, d = ring + i, ring + j, ring + around + j, ring + around + i
            faces += [(a, b, c), (a, c, d)]
        faces.append((top - around + i, top - around + j, top))
    return ecods.Mesh(np.rint(np.array(points) * 2**20) / 2**20, faces)


wall_corners = list(itertools.product((-0.03125, 0.03125), (-3, 3), (0, 4)))
start, velocity = np.array((-6, -1.5, 1.5)), np.array((10, 3, 0.5))  # a frame is a time step
half = 0.5 * np.eye(3)

world = ecods.World()
wall = world.create_body(ecods.ConvexSolid.hull(wall_corners))
flying = world.create_body(ball(32, 16), ecods.pose(t=start, R=half))

print("Looking at frames alone")
for frame in (0, 1):
    world.set_pose(flying, ecods.pose(t=start + frame * velocity, R=half))
    world.update()
    print(f"  frame {frame}: {len(world.colliding_pairs())} pairs touch")

print("Asking about the way")
world.set_pose(flying, ecods.pose(t=start, R=half))
if first := world.cast(flying, velocity):
    kind = str(first.contact.kind).replace("_", " and ")
    print(f"  the ball meets body {ecods.body_name(first.body)} at time {first.contact.time}, {kind}")

# Everything at once, turning as well: each point goes straight from its old place to its new one, so that a body that
# turns is not rigid between them.
print("Both move")
quarter_turn = np.array([(0, -1, 0), (1, 0, 0), (0, 0, 1)])
ends = [ecods.pose(t=(-5, 0, 0)), ecods.pose(t=start + velocity, R=0.5 * quarter_turn)]
for meeting in world.meetings([wall, flying], ends):
    a, b = (ecods.body_name(body) for body in meeting.bodies)
    print(f"  ({a}, {b}) meet at time {meeting.contact.time}")
