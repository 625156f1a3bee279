"""How do I ...? Capsules, clouds, terrain and other bodies, a function of a few lines each."""
import itertools
import math

import numpy as np

import ecods


def box(least, greatest):
    """The solid box between two corners."""
    return ecods.ConvexSolid.hull(list(itertools.product(*zip(least, greatest))))


def sphere_or_capsule():
    """A capsule is all points within a radius of a segment; ecods.sphere() and ecods.rounded() make other such bodies."""
    capsule, wall = ecods.capsule((0, 0, 0), (0, 0, 2), 0.5), box((2, -1, 0), (3, 1, 2))
    print(f"capsule: {ecods.distance(capsule, wall)} from the wall, touches: {ecods.intersects(capsule, wall)}")


def point_cloud():
    """A cloud is a mesh of one triangle {i, i, i} for each point; its tree makes questions fast."""
    cloud = ecods.point_cloud([(x, y, 5) for x in range(20) for y in range(20)])
    nearest = ecods.closest(cloud, box((3, 4, 0), (6, 8, 3)))
    print(f"point cloud: {nearest.distance} from the box, at {tuple(nearest.point_a.tolist())}")


def signed_distance():
    """A distance from the surface of a solid is negative for points inside."""
    cube = box((0, 0, 0), (2, 2, 2))
    points = np.array([(1, 1, 1.75), (1, 1, 2), (1, 1, 5)])
    print("signed distances:", ecods.signed_distance_many(points, cube).tolist())


def compound():
    """A body of many parts is one mesh; parts that are closed and apart make one solid."""
    cube = box((0, 0, 0), (1, 1, 1))
    count = len(cube.vertices)
    vertices = np.concatenate([cube.vertices, cube.vertices + (3, 0, 0)])
    both = ecods.Solid(vertices, np.concatenate([cube.faces, cube.faces + count]))
    print("compound:", ecods.relation(both, box((1, 0, 0), (3, 1, 1))))


def link_of_urdf():
    """An origin of URDF, xyz and rpy, is t and R = Rz(yaw) Ry(pitch) Rx(roll)."""
    xyz, (roll, pitch, yaw) = (1, 0, 0.5), (0, 0, math.pi / 2)

    def turn(angle, i, j):
        matrix = np.eye(3)
        matrix[i, i] = matrix[j, j] = math.cos(angle)
        matrix[j, i], matrix[i, j] = math.sin(angle), -math.sin(angle)
        return matrix

    link = ecods.pose(t=xyz, R=turn(yaw, 0, 1) @ turn(pitch, 2, 0) @ turn(roll, 1, 2))
    base = ecods.pose(t=(0, 0, 1))
    at = base @ link  # poses are chained by multiplication of (4, 4)
    print("link of URDF: at", tuple(at[:3, 3].tolist()))


def ground():
    """The ground is a half space: what is below its plane is inside it, and collides."""
    floor = ecods.HalfSpace((0, 0, 1), 0)
    crate = box((0, 0, 0), (1, 1, 1))
    signed = [ecods.signed_distance(crate.at(ecods.pose(t=(0, 0, z))), floor) for z in (0.5, 0, -0.25)]
    print("ground:", [each.distance for each in signed])


def terrain():
    """A field of heights is a mesh of two triangles a cell; a ray down finds the ground."""
    steps = np.arange(30)
    land = ecods.height_field(np.outer(steps, steps) / 64, (1, 1))
    hit = ecods.first_hit(ecods.Ray((8, 12, 100), (0, 0, -1)), land)
    print("terrain: the ground is at", hit.point[2])


for example in (sphere_or_capsule, point_cloud, signed_distance, compound, link_of_urdf, ground, terrain):
    example()
