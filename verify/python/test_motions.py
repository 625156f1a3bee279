"""Motions: Translation, Straight and Turn, of two bodies and of a world; and where bodies that move touch first."""
import math

import numpy as np
import pytest

import ecods
from scenes import at, box

STAY = ecods.Translation()
HALF = ecods.Turn((0, 0, 0, 1), (0, 0, 0), (0, 0, 0))  # about z: (5, 0, 0) is at (3, 4, 0) at the time 1/3
BACK = ecods.Turn((0, 0, 0, -1), (6, 0, 0), (6, 0, 0))
POINT, TARGET = (ecods.point_cloud([place]) for place in ((5, 0, 0), (3, 4, 0)))
CUBE = ecods.Solid(*box())
WALL = ecods.Mesh([(3, -9, -9), (3, 9, -9), (3, 0, 9)], [[0, 1, 2]])  # x = 3


def test_motions_have_values():
    assert STAY.by.tolist() == [0, 0, 0] and ecods.Translation([1, 2, 3]).by.tolist() == [1, 2, 3]
    assert ecods.Translation(by=(1, 2, 3)) == ecods.Translation([1, 2, 3]) != STAY
    assert ecods.Straight(at(2)) == ecods.Straight(to=at(2)[:3]) != ecods.Straight(None)
    assert ecods.Straight(at(2)).to.tolist() == at(2).tolist()
    assert repr(ecods.Translation([1, 0.1, 0])) == "Translation(by=[1.0, 0.1, 0.0])"


@pytest.mark.parametrize("make, argument, part", [
    (lambda: ecods.Translation([0, math.nan, 0]), ecods.Argument.motion, "(1)"),
    (lambda: ecods.Straight(at(math.inf)), ecods.Argument.pose, "t(0)"),
    (lambda: ecods.Turn((1, 0, 0, math.inf), (0, 0, 0), (0, 0, 0)), ecods.Argument.turn, "q.z"),
])
def test_numbers_that_are_not_finite(make, argument, part):
    with pytest.raises(ecods.InvalidArgument) as caught:
        make()
    assert (caught.value.argument, caught.value.part) == (argument, part)


def test_a_body_on_a_way():
    # A whole turn in two legs: (5, 0, 0) is at (3, 4, 0) at a sixth, and at (3, -4, 0) at five sixths.
    five_sixths = (1 + 2 / 3) / 2
    nodes = [ecods.WayNode((1, 0, 0, 0)), ecods.WayNode((0, 0, 0, 1)), ecods.WayNode((-1, 0, 0, 0))]
    along = ecods.Along(nodes)
    assert along.nodes == nodes and along == ecods.Along(nodes=tuple(nodes)) != ecods.Along(nodes[:2])
    late = ecods.point_cloud([(3, -4, 0)])
    assert ecods.cast(POINT, along, TARGET, STAY).time == 1 / 6
    assert ecods.cast(late, STAY, POINT, along).time == five_sixths
    assert ecods.cast(POINT, along, late, STAY, 0.8) is None
    assert ecods.cast(POINT, ecods.Along(nodes[:2]), TARGET, HALF) is None  # nodes that are a turn
    with pytest.raises(ecods.NotSupported):
        ecods.cast(POINT, along, TARGET, HALF)
    world = ecods.World()
    body = world.create_body(late)
    assert world.cast(POINT, along).body == body and world.cast(POINT, along).contact.time == five_sixths
    own = world.create_body(POINT)
    assert [met.contact.time for met in world.meetings([own], [along])] == [five_sixths]
    with pytest.raises(ecods.InvalidArgument) as caught:
        ecods.Along([nodes[0], nodes[2]])
    assert (caught.value.argument, caught.value.part, caught.value.index) == (ecods.Argument.turn, "q", 1)


def test_two_bodies_that_turn():
    both = ecods.cast(POINT.turning(None, HALF), ecods.point_cloud([(1, 0, 0)]).turning(None, BACK))
    assert both.time == 1 / 3 and both.kind == ecods.ClosestKind.vertex_vertex
    assert ecods.cast(POINT.turning(None, HALF), POINT.turning(None, HALF), max_time=0.5).time == 0


def test_two_bodies_in_any_order():
    found = ecods.cast(POINT, HALF, TARGET, STAY)
    assert found == ecods.cast(POINT.turning(None, HALF), TARGET) and found.time == 1 / 3
    assert ecods.cast(TARGET, STAY, POINT, HALF).time == 1 / 3
    assert ecods.cast(POINT, HALF, TARGET, STAY, 0.25) is None is ecods.cast(TARGET, STAY, POINT, HALF, max_time=0.25)
    falling = ecods.Translation((0, 0, 3))
    witness = ecods.Witness()
    found = ecods.cast(POINT, HALF, TARGET.at(at(0, 0, -1)), falling, witness=witness)
    assert found.time == 1 / 3 and witness != ecods.Witness()
    assert ecods.cast(POINT, HALF, ecods.point_cloud([(1, 0, 0)]), BACK).time == 1 / 3
    # Each of two cubes 2 apart goes 2 to the other one; or one of them goes 4.
    low, high = CUBE.at(None), CUBE.at(at(3))
    right, left = ecods.Translation((2, 0, 0)), ecods.Translation((-2, 0, 0))
    assert ecods.cast(low, right, high, left).time == 0.5 == ecods.cast(high, left, low, right).time
    assert ecods.cast(low, left, high, right) is None
    moved = ecods.cast(low, ecods.Straight(at(2)), high, ecods.Straight(at(1)))
    assert moved == ecods.cast(CUBE.moving(None, at(2)), CUBE.moving(at(3), at(1))) and moved.time == 0.5
    assert ecods.cast(low, ecods.Straight(at(4)), high, STAY).time == 0.5
    wall = ecods.cast(ecods.Mesh(*box()).at(at(4, 1)), ecods.Translation((-2, 0, 0)), WALL, STAY)
    assert wall == ecods.cast(ecods.Mesh(*box()).at(at(4, 1)), (-2, 0, 0), WALL) and wall.time == 0.5


def test_a_straight_move_beside_others():
    low, high = CUBE, CUBE.at(at(3))
    left = ecods.Translation((-2, 0, 0))
    assert ecods.cast(low, ecods.Straight(at(2)), high, left).time == 0.5 == ecods.cast(high, left, low, ecods.Straight(at(2))).time
    up = (0, 0, 0.25)
    beside = ecods.cast(POINT, HALF, TARGET, ecods.Straight(at(*up)))
    assert beside == ecods.cast(POINT, HALF, TARGET, ecods.Translation(up))
    assert ecods.cast(CUBE, HALF, CUBE.at(at(9)), ecods.Straight(at(8))) is None


def test_what_is_no_motion():
    with pytest.raises(TypeError, match="^cast: argument 4 .* is a list of 3; a number or a Translation or a Straight or a Turn or an Along is expected$"):
        ecods.cast(POINT, HALF, TARGET, [1, 0, 0])


def test_a_cast_in_a_world():
    world = ecods.World()
    target, wall = world.create_body(TARGET), world.create_body(WALL, at(-9))
    met = world.cast(POINT, HALF)
    assert met.body == target and met.contact == ecods.cast(POINT, HALF, TARGET, STAY)
    assert world.cast(POINT, HALF, 0.25) is None
    own = world.create_body(POINT, groups=2)
    assert world.cast(own, HALF).body == target and world.cast(own, HALF, max_time=0.25) is None
    assert world.cast(POINT, HALF, filter=ecods.CollisionFilter(1, 2)).body == own
    assert world.cast(POINT.at(at(1)), HALF, filter=ecods.CollisionFilter(1, 2)) is None
    assert world.pose(own).tolist() == np.eye(4).tolist()  # nothing has moved
    world.destroy_body(own)
    for body, motion in ((target, (-4, 8, 0)), (wall, (-14, 0, 0))):
        met = world.cast(POINT, ecods.Translation(motion))
        assert met.body == body and met == world.cast(POINT, motion)
    assert world.cast(POINT, ecods.Straight(at(-12, 0, 0.5))).body == wall
    with pytest.raises(ecods.StaleBody):
        world.cast(99, HALF)
    world.create_body(ecods.sphere(1), at(50))
    with pytest.raises(ecods.NotSupported) as caught:
        world.cast(POINT, HALF)
    assert caught.value.question == ecods.Question.cast_any_motion
    assert world.cast(POINT, ecods.Translation((-4, 8, 0))).body == target


def test_a_cast_to_a_distance_in_a_world():
    world = ecods.World()
    wall = world.create_body(WALL)
    met = world.cast_to_distance(POINT, (-4, 0, 0), 1)
    assert met.body == wall and met.contact == ecods.cast_to_distance(POINT, (-4, 0, 0), WALL, 1)
    assert met.contact.time == 0.25 and world.cast_to_distance(POINT, (-4, 0, 0), distance=1, max_time=0.125) is None
    ball = world.create_body(ecods.sphere(0.5), at(5), groups=2)
    assert world.cast_to_distance(ball, (-4, 0, 0), 0.5).contact.time == 0.25
    assert world.cast_to_distance(POINT, (-4, 0, 0), 1, filter=ecods.CollisionFilter(1, 1)) == met
    with pytest.raises(ecods.InvalidArgument) as caught:
        world.cast_to_distance(POINT, (-4, 0, 0), -1)
    assert caught.value.argument == ecods.Argument.distance
    world.create_body(ecods.HalfSpace((0, 0, 1), -9))
    with pytest.raises(ecods.NotSupported):
        world.cast_to_distance(POINT, (-4, 0, 0), 1)


def test_meetings_in_a_world():
    world = ecods.World()
    point, target = world.create_body(POINT), world.create_body(TARGET)
    found = world.meetings([point], [HALF])
    assert len(found) == 1 and found[0].bodies == (point, target) and found[0].contact.time == 1 / 3
    assert world.meetings([point, target], [HALF, STAY]) == found == world.meetings(bodies=[target, point], motions=(STAY, HALF))
    assert world.meetings([point, point], [STAY, HALF]) == found and world.meetings([point, point], [HALF, STAY]) == []
    # A third point goes half around (6, 0, 0), and through the same place at the same time.
    other = world.create_body(ecods.point_cloud([(1, 0, 0)]))
    times = {each.bodies: each.contact.time for each in world.meetings([point, other], [HALF, BACK])}
    assert times == {(point, target): 1 / 3, (point, other): 1 / 3, (target, other): 1 / 3}
    goal = at(-2, 4)
    straight = world.meetings([point], [ecods.Straight(goal)])
    assert straight == world.meetings([point], [goal]) == world.meetings([point], [ecods.Translation((-2, 4, 0))])
    assert straight[0].contact.time == 1 and world.meetings([], []) == []
    assert world.pose(point).tolist() == np.eye(4).tolist()


def test_meetings_that_are_refused():
    world = ecods.World()
    first, second = world.create_body(POINT), world.create_body(TARGET)
    assert world.meetings([first, second], [HALF, ecods.Straight(at(1))]) == []
    along = ecods.Along([ecods.WayNode((1, 0, 0, 0)), ecods.WayNode((0, 0, 0, 1)), ecods.WayNode((-1, 0, 0, 0))])
    with pytest.raises(ecods.NotSupported):
        world.meetings([first, second], [along, ecods.Straight(at(1))])
    with pytest.raises(ecods.InvalidArgument) as caught:
        world.meetings([first, second], [HALF])
    assert caught.value.argument == ecods.Argument.list_length
    with pytest.raises(ecods.StaleBody) as stale:
        world.meetings([first, 99], [HALF, HALF])
    assert stale.value.index == 1
    for motions in ([HALF, 5], HALF, [(1, 0, 0), HALF]):
        with pytest.raises((TypeError, ValueError)):
            world.meetings([first, second], motions)


def test_points_and_normals():
    turning = POINT.turning(None, HALF)
    contact = ecods.cast(turning, WALL)
    touch = ecods.contact_point(turning, WALL, contact)
    assert contact.kind == ecods.ClosestKind.vertex_face
    assert touch.point.tolist() == [3, 4, 0] and touch.normal.tolist() == [-1, 0, 0]
    # A wall that rises has the same contact.
    rising = ecods.cast(turning, [0, 0, 3], WALL)
    assert ecods.contact_point(turning, [0, 0, 3], WALL, rising) == touch
    # The bodies in the other order: the wall comes to the point, which it sees from the other side.
    point = ecods.point_cloud([(3, 4, 0)])
    gliding = WALL.turning(at(2), ecods.Turn((1, 0, 0, 0), (0, 0, 0), (-4, 0, 0)))
    found = ecods.cast(gliding, point)
    touch = ecods.contact_point(gliding, point, found)
    assert found.time == 0.5 and touch.point.tolist() == [3, 4, 0] and touch.normal.tolist() == [-1, 0, 0]
    vertices = ecods.cast(turning, TARGET)
    touch = ecods.contact_point(turning, TARGET, vertices)
    assert touch.point.tolist() == [3, 4, 0] and touch.normal is None
    with pytest.raises(ecods.NotSupported):
        ecods.contact_point(turning, TARGET.at(at(9)), vertices)


def test_points_and_normals_of_bodies_that_go_straight():
    going, wall = POINT.moving(None, at(-4)), WALL.moving(None, None)
    contact = ecods.cast(going, wall)
    touch = ecods.contact_point(going, wall, contact)
    assert contact.time == 0.5 and touch.point.tolist() == [3, 0, 0] and touch.normal.tolist() == [-1, 0, 0]
    turned_around = ecods.contact_point(wall, going, ecods.cast(wall, going))
    assert turned_around.point.tolist() == [3, 0, 0] and turned_around.normal.tolist() == [1, 0, 0]
    with pytest.raises(ecods.NotSupported):
        ecods.contact_point(going, WALL.moving(at(1), at(1)), contact)
