"""Contact patches in Python: of two bodies, of a world; depths with points and along a direction."""
import pickle

import numpy as np
import pytest

import ecods
from scenes import at, box, mesh


def cube():
    vertices, faces = box(2, 2, 2)
    return ecods.ConvexSolid(np.array(vertices) - 1.0, faces)


def test_a_stack():
    solid = cube()
    patch = ecods.contact_patch(solid, solid.at(at(1, 0, 1.5)))
    assert patch.distance == -0.5 and patch.normal.tolist() == [0, 0, 1] and patch.corner_count == 4
    assert len(patch.corners) == 4
    for corner in patch.corners:
        assert corner.gap == -0.5
        assert (corner.point_b - corner.point_a).tolist() == [0, 0, -0.5]
        assert (2 * corner.middle).tolist() == (corner.point_a + corner.point_b).tolist()
    assert len(ecods.contact_patch(solid, solid.at(at(1, 0, 1.5)), max_corners=2).corners) == 2
    assert ecods.contact_patch(solid, solid.at(at(0, 0, 3)), max_gap=0.5).corners == []
    assert pickle.loads(pickle.dumps(patch)) == patch
    with pytest.raises(ecods.InvalidArgument):
        ecods.contact_patch(solid, solid, min_cos_squared=0)
    with pytest.raises(ecods.NotSupported):
        ecods.contact_patch(solid, mesh())


def test_other_bodies():
    solid, ground = cube(), ecods.HalfSpace([0, 0, 1], 0)
    soft = ecods.rounded(solid, 0.5)
    assert ecods.contact_patch(solid.at(at(0, 0, 3)), ground).distance == 2
    assert ecods.contact_patch(ground, soft.at(at(0, 0, 3))).distance == 1.5
    assert ecods.contact_patch(soft, solid.at(at(0, 0, 3))).distance == 0.5
    assert ecods.contact_patch(soft, soft.at(at(0, 0, 2.5))).distance == -0.5


def test_depths():
    solid = cube()
    deep = ecods.depth_points(solid, solid.at(at(0, 1.5, 0)))
    assert deep.depth.depth == 0.5 and (deep.point_a - deep.point_b).tolist() == [0, 0.5, 0]
    along = ecods.depth_along(solid, solid.at(at(0, 1.5, 0)), [0, 0, 4])
    assert along.parameter == 0.5 and along.length == 2
    assert ecods.depth_points(solid, solid.at(at(9, 0, 0))) is None
    assert ecods.depth_along(solid, solid.at(at(9, 0, 0)), [1, 0, 0]) is None


def test_a_world():
    world, solid = ecods.World(), cube()
    low, high = world.create_body(solid), world.create_body(solid, at(0, 0, 2))
    world.update()
    (found,) = world.contact_patches(max_corners=3)
    assert found.patch.corner_count == 4 and len(found.patch.corners) == 3
    assert world.contact_patch(low, high).distance == 0
