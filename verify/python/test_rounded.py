"""Spheres, capsules and margins in Python: their questions, worlds, copies, traces."""
import copy
import pickle

import numpy as np
import pytest

import ecods
from scenes import at, box, mesh


def test_spheres_and_capsules():
    ball, bone = ecods.sphere(1), ecods.capsule([0, 0, -1], [0, 0, 1], 0.5)
    assert isinstance(ball, ecods.Rounded) and ball.radius == 1 and bone.core.vertices.shape == (2, 3)
    assert ecods.distance(ball, bone.at(at(4))) == 2.5
    assert ecods.intersects(ball, bone.at(at(1.5))) and not ecods.intersects(ball, bone.at(at(1.5000001)))
    assert ecods.relation(ball, ecods.sphere(2**-60, [1, 0, 0])) == ecods.Relation.overlapping
    assert ecods.within(ball, bone.at(at(4)), 2.5)
    points = ecods.closest(ball, bone.at(at(4)))
    assert points.point_a.tolist() == [1, 0, 0] and points.distance == 2.5
    bounds = ecods.distance_bounds(ball, bone.at(at(4)), relative=0.5)
    assert bounds.lower <= 2.5 <= bounds.upper
    witness = ecods.Witness()
    assert ecods.distance(ball, mesh().at(at(4)), witness=witness) == 3
    assert ecods.distance(mesh().at(at(4)), ball) == 3
    assert ball.box(at(2)).tolist()[0][0] == pytest.approx(1)


def test_margins():
    padded = ecods.rounded(mesh(), 0.25)
    assert padded.core.digest == mesh().digest
    assert ecods.rounded(padded, 0.5).radius == 0.75
    with pytest.raises(ecods.NotSupported):
        ecods.rounded(ecods.sphere(1), 2**-60)
    for bad in (-1, np.nan, np.inf):
        with pytest.raises(ecods.InvalidArgument) as refused:
            ecods.sphere(bad)
        assert refused.value.part == "radius"
    with pytest.raises(ecods.InvalidArgument):
        ecods.Rounded(None, 1)
    with pytest.raises(ecods.NotSupported) as refused:
        ecods.relation(ecods.rounded(ecods.surface_of(ecods.Solid(*box())), 1), ecods.sphere(1))
    assert "rounded" in str(refused.value)


def test_signed_distances_and_points():
    ball, solid = ecods.sphere(0.25, [0.25, 0.5, 0.5]), ecods.ConvexSolid(*box())
    found = ecods.signed_distance(ball, solid)
    assert found.distance == -0.5 and ecods.depth(ball, solid).depth == 0.5
    assert found.point_a.tolist() == [0.5, 0.5, 0.5] and found.point_b.tolist() == [0, 0.5, 0.5]
    assert ecods.signed_distance(solid, ball).direction.tolist() == [-x for x in found.direction]
    assert ecods.depth(ball, solid.at(at(9))) is None
    with pytest.raises(ecods.NotSupported):
        ecods.depth(ball, mesh())
    body = ecods.sphere(7, [1, 0, 0]).at(at(0))
    assert ecods.signed_distance([3, 3, 6], body) == 0 and ecods.locate([3, 3, 6], body).side == ecods.Side.on
    assert ecods.closest_point([5, 6, 12], body).point.tolist() == [3, 3, 6]
    with pytest.raises(ecods.InvalidArgument):
        ecods.locate([0, np.nan, 0], body)


def test_hits_and_casts():
    ball = ecods.sphere(5)
    ray = ecods.Ray([-9, 3, 0], [1, 0, 0])
    assert [(hit.parameter, hit.kind) for hit in ecods.all_hits(ray, ball)] == [
        (5, ecods.HitKind.front), (13, ecods.HitKind.back)]
    assert ecods.first_hit(ecods.Segment([-9, 3, 0], [7, 3, 0]), ball).parameter == 0.3125
    assert ecods.first_hit(ecods.Ray([-9, 6, 0], [1, 0, 0]), ball) is None
    assert ecods.cast(ecods.sphere(3), [10, 0, 0], ecods.sphere(2, [8, 3, 0])).time == 0.4
    assert ecods.cast(ball, [10, 0, 0], mesh().at(at(10)), max_time=0.25) is None
    contact = ecods.cast(mesh().at(at(10)), [-10, 0, 0], ball)
    assert contact.time == ecods.cast(ball, [10, 0, 0], mesh().at(at(10))).time > 0
    ground = ecods.HalfSpace([0, 0, 1], 0)
    assert ecods.cast(ecods.sphere(1).at(at(0, 0, 5)), [0, 0, -8], ground).time == 0.5


def test_copies_and_pickles():
    bone = ecods.capsule([0, 0, 0], [1, 0, 0], 0.5)
    assert copy.copy(bone) is bone
    again = pickle.loads(pickle.dumps(bone))
    assert again.digest == bone.digest and "radius 0.5" in repr(again)
    posed = pickle.loads(pickle.dumps(bone.at(at(3))))
    assert posed.pose[0, 3] == 3 and posed.shape.digest == bone.digest and "PosedRounded" in repr(posed)


def test_worlds():
    world = ecods.World()
    ball = world.create_body(ecods.sphere(1))
    cube = world.create_body(mesh(), at(1.5))
    world.set_clearance(0.5)
    world.update()
    assert world.colliding_pairs().shape == (0, 2) and world.close_pairs().tolist() == [[ball, cube]]
    world.set_shape(ball, ecods.sphere(1.5))
    world.update()
    assert world.began().tolist() == [[ball, cube]]
    assert world.shape(ball).radius == 1.5 and world.shape(cube).digest == mesh().digest
    with pytest.raises(ecods.NotSupported):
        world.mesh(ball)
    assert ecods.distance(world.posed(ball), world.posed(cube)) == 0
    assert world.nearest(ecods.sphere(0.25).at(at(-5))).distance == 3.25
    assert world.intersecting_bodies(ecods.sphere(0.25).at(at(-1.5))).tolist() == [ball]
    assert world.closest(ball, cube).kind == ecods.ClosestKind.vertex_vertex
    assert world.first_hit(ecods.Ray([0, 0, 5], [0, 0, -1])).hit.parameter == 3.5
    assert world.cast(ecods.sphere(0.5).at(at(-6)), [8, 0, 0]).contact.time == 0.5
    assert world.signed_distance(ball, cube).distance == ecods.signed_distance(
        world.posed(ball), world.posed(cube)).distance
    again = pickle.loads(pickle.dumps(world))
    again.update()
    assert again.digest() == world.digest()
