"""A robot's arm on its way: how near does it come to what stands around, and does it hit anything between two samples?

Balls, cylinders and boxes are polytopes here, so that every number is that of the shapes as given.
"""
import math

import ecods
import numpy as np

LENGTHS = (1.0, 0.8, 0.5)
STEPS = 20


def prism(sides, radius, length):
    """Along z, from 0 to `length`."""
    angles = [(2 * i + 1) * math.pi / sides for i in range(sides)]
    return ecods.ConvexSolid.hull([(radius * math.cos(a), radius * math.sin(a), z) for a in angles for z in (0, length)])


def turn(angle, axis):
    """A 4x4 matrix, about z (2) or y (1)."""
    c, s, i, j = math.cos(angle), math.sin(angle), (axis + 1) % 3, (axis + 2) % 3
    result = np.eye(4)
    result[i, i] = result[j, j] = c
    result[j, i], result[i, j] = s, -s
    return result


def shift(*t):
    result = np.eye(4)
    result[:3, 3] = t
    return result


def arm_at(time):
    """Where the links are at a time from 0 to 1: each turns about its own joint, the first one about the vertical, too."""
    bends = (0.35 + 0.25 * time, 0.5 + 0.7 * time, 0.6 - 0.4 * time)
    joint = shift(0, 0, 0.3) @ turn(1.2 * (2 * time - 1), 2)
    poses = []
    for bend, length in zip(bends, LENGTHS):
        joint = joint @ turn(bend, 1)
        poses.append(joint)
        joint = joint @ shift(0, 0, length)
    return np.array(poses)


# What is in group 1 stands still, and meets the arm alone, which is in group 2 and does not meet itself.
world = ecods.World()
names = {}
links = []
for i, (length, pose) in enumerate(zip(LENGTHS, arm_at(0))):
    links.append(world.create_body(prism(8, 0.1, length), pose, groups=2, mask=1))
    names[links[-1]] = f"link {i + 1}"
names[world.create_body(prism(16, 0.12, 0.75), shift(1.125, 1.25, 0), groups=1, mask=2)] = "post"
names[world.create_body(prism(4, 0.45, 0.35), shift(1.35, -0.15, 0), groups=1, mask=2)] = "bin"

nearest, contacts = None, 0
for step in range(STEPS + 1):
    poses = arm_at(step / STEPS)
    # Each point goes on a straight line from its old to its new place: nothing is passed through unseen.
    for meeting in world.meetings(links, poses):
        a, b = (names[body] for body in meeting.bodies)
        print(f"  on the way to step {step}: {a} meets {b} at {meeting.contact.time:.4f} of it")
        contacts += 1
    world.set_poses(links, poses)
    # All pairs of convex solids within 0.3.
    for each in world.signed_distances(0.3):
        a, b = (names[body] for body in each.bodies)
        print(f"step {step:2}: {a} and {b}: {each.distance:.6f}")
        if nearest is None or each.distance < nearest.distance:
            nearest = each
a, b = (names[body] for body in nearest.bodies)
print(f"Nearest: {a} and {b}, {nearest.distance:.6f}. {contacts} contacts on the way.")
