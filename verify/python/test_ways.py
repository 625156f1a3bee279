"""Ways of several turns, and the gap between a real end and the pose from which a body goes on."""
import math

import numpy as np
import pytest

import ecods
from ecods import WayNode
from scenes import at

# A whole turn about z in two legs: (5, 0, 0) is at (3, 4, 0) at the time 1/3 of leg 0, at (3, -4, 0) at 2/3 of leg 1.
WHOLE = [WayNode((1, 0, 0, 0)), WayNode((0, 0, 0, 1)), WayNode((-1, 0, 0, 0))]
POINT = ecods.point_cloud([(5, 0, 0)])
HALF = ecods.Turn((0, 0, 0, 1), (0, 0, 0), (0, 0, 0))
WAY = ecods.Way(POINT, None, WHOLE)
AROUND = np.diag([-1.0, -1, 1, 1])


def cloud(*place):
    return ecods.point_cloud([place])


def test_a_way_has_values():
    node = WayNode(q=[2, 0, 0, 0.5], pivot=[1, 2, 3])
    assert node.q == (2, 0, 0, 0.5) and node.pivot.tolist() == [1, 2, 3]
    assert node == WayNode((2, 0, 0, 0.5), (1, 2, 3)) != WayNode((2, 0, 0, 0.5))
    assert repr(node) == "WayNode(q=(2.0, 0.0, 0.0, 0.5), pivot=[1.0, 2.0, 3.0])"
    way = ecods.Way(mesh=POINT, start=at(1), nodes=tuple(WHOLE))
    assert way.mesh is POINT and way.start.tolist() == at(1).tolist() and way.nodes == WHOLE
    way.nodes.clear()
    assert way.nodes == WHOLE


def test_contacts():
    met = ecods.cast(WAY, cloud(3, 4, 0))
    assert (met.leg, met.contact.time, met.contact.kind) == (0, 1 / 3, ecods.ClosestKind.vertex_vertex)
    witness = ecods.Witness()
    met = ecods.cast(WAY, cloud(3, -4, 0), witness=witness)
    assert (met.leg, met.contact.time) == (1, 2 / 3) and witness != ecods.Witness()
    # A contact at a node is the last one of the leg that ends there.
    met = ecods.cast(WAY, cloud(-5, 0, 0))
    assert (met.leg, met.contact.time) == (0, 1)
    assert ecods.cast(WAY, cloud(5, 0, 0)).contact.time == 0 and ecods.cast(WAY, cloud(3, 5, 0)) is None
    one_leg = ecods.cast(ecods.Way(POINT, None, WHOLE[:2]), cloud(3, 4, 0))
    assert one_leg.contact == ecods.cast(POINT.turning(None, HALF), cloud(3, 4, 0))


def test_poses():
    assert ecods.pose_at(None, WHOLE, 0, 1).tolist() == AROUND.tolist() == ecods.pose_at(None, WHOLE, 1, 0).tolist()
    assert ecods.pose_at(at(7), WHOLE, leg=1, time=1).tolist() == at(7).tolist()
    there = ecods.pose_at(None, [WayNode((1, 0, 0, 0)), WayNode((1, 0, 0, 0), (4, 0, 0))], 0, 0.25)
    assert there.tolist() == at(1).tolist()


@pytest.mark.parametrize("nodes, part, index", [
    ([], "nodes", None),
    (WHOLE[:1], "nodes", None),
    (WHOLE[1:], "q", 0),
    ([WHOLE[0], WHOLE[2]], "q", 1),
    ([WHOLE[0], WayNode((0, 0, 0, 0))], "q", 1),
    ([WHOLE[0], WayNode((0, 0, math.nan, 1))], "q.y", 1),
    ([WHOLE[0], WHOLE[1], WayNode((1, 0, 0, 1), (0, math.inf, 0))], "pivot(1)", 2),
])
def test_nodes_that_are_no_way(nodes, part, index):
    for call in (lambda: ecods.Way(POINT, None, nodes), lambda: ecods.pose_at(None, nodes, 0, 0.5)):
        with pytest.raises(ecods.InvalidArgument) as caught:
            call()
        error = caught.value
        assert (error.argument, error.part, error.index) == (ecods.Argument.turn, part, index)


def test_other_bad_arguments():
    with pytest.raises(ecods.InvalidArgument) as caught:
        ecods.pose_at(None, WHOLE, 2, 0.5)
    assert (caught.value.argument, caught.value.part) == (ecods.Argument.turn, "nodes")
    with pytest.raises(ecods.InvalidArgument) as caught:
        ecods.pose_at(None, WHOLE, 0, 1.5)
    assert caught.value.argument == ecods.Argument.time
    with pytest.raises(ecods.InvalidArgument):
        ecods.Way(POINT, at(math.nan), WHOLE)
    with pytest.raises(ecods.InvalidArgument):
        ecods.Way(None, None, WHOLE)
    for call in (lambda: ecods.Way(POINT, None, [1, 2]), lambda: ecods.pose_at(None, WHOLE, -1, 0.5)):
        with pytest.raises(TypeError):
            call()
    for q in ((1, 0, 0), [[1, 0, 0, 0]]):
        with pytest.raises(ValueError, match="^quaternion: the shape"):
            WayNode(q)


def test_the_gap_at_the_end():
    raised = AROUND.copy()
    raised[2, 3] = 1  # from (-5, 0, 0) to (-5, 0, 1)
    one_leg = ecods.Way(POINT, None, WHOLE[:2])
    for moving in (POINT.turning(None, HALF), one_leg):
        found = ecods.settle(moving, raised, cloud(-5, 0, 0.25))
        assert found.time == 0.25 and found.kind == ecods.ClosestKind.vertex_vertex
        witness = ecods.Witness()
        assert ecods.settle(moving, to=raised, b=cloud(-5, 0, 1), witness=witness).time == 1
        assert ecods.settle(moving, AROUND, cloud(-5, 0, 0.25)) is None
        assert ecods.settle(moving, raised, cloud(-5, 0, 1.25)) is None
        with pytest.raises(ecods.InvalidArgument):
            ecods.settle(moving, at(math.nan), cloud(0, 0, 0))
    assert ecods.settle(WAY, at(0, 0, 2), cloud(5, 0, 1)).time == 0.5


def test_points_and_normals():
    wall = ecods.Mesh([(3, -1, 0), (3, -9, 9), (3, -9, -9)], [[0, 1, 2]])
    met = ecods.cast(WAY, wall)
    touch = ecods.contact_point(WAY, wall, met)
    assert (met.leg, met.contact.time, met.contact.kind) == (1, 2 / 3, ecods.ClosestKind.vertex_face)
    assert touch.point.tolist() == [3, -4, 0] and touch.normal.tolist() == [1, 0, 0]
    vertex = cloud(3, -4, 0)
    touch = ecods.contact_point(WAY, vertex, ecods.cast(WAY, vertex))
    assert touch.point.tolist() == [3, -4, 0] and touch.normal is None
    for way, body in ((ecods.Way(POINT, None, WHOLE[:2]), wall), (WAY, wall.at(at(1)))):
        with pytest.raises(ecods.NotSupported):
            ecods.contact_point(way, body, met)
