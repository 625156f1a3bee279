"""Calls that are refused: the type of the error, what it says, its members, and that nothing has changed."""
import pickle

import numpy as np
import pytest

import ecods
from scenes import at, box, mesh

Mesh, Solid, Bad = ecods.InvalidMeshReason, ecods.NotSolidReason, ecods.Argument
ERRORS = [
    (lambda: ecods.Mesh([[0, 0, np.nan]], [[0, 0, 0]]), ecods.InvalidMesh,
     "vertex 0, axis 2: coordinate is nan, not finite", {"reason": Mesh.vertex, "vertex": 0, "axis": 2}),
    (lambda: ecods.Mesh([[0, 0, 0]], [[0, 0, 7]]), ecods.InvalidMesh, None,
     {"reason": Mesh.index, "triangle": 0, "corner": 2, "index": 7}),
    (lambda: ecods.Mesh([[0, 0, 0]], [[0, 0, -1]]), ecods.InvalidMesh,
     "triangle 0, corner 2: vertex index -1 is out of range; there are 1 vertices", {"index": -1}),
    (lambda: ecods.Mesh([[0, 0, 0]], np.array([[0, -2**31, 0]], np.int32)), ecods.InvalidMesh, "index -2147483648 is",
     {"reason": Mesh.index, "index": -2**31, "corner": 1, "vertex_count": 1}),
    (lambda: ecods.Mesh([[0, 0, 0]], np.array([[0, 2**64 - 1, 0]], np.uint64)), ecods.InvalidMesh,
     "index 18446744073709551615 is", {"index": 2**64 - 1}),
    (lambda: ecods.Mesh([[0, 0, 0]], [[0, 0, 2**40]]), ecods.InvalidMesh, "index 1099511627776 is", {"index": 2**40}),
    (lambda: ecods.Mesh([[0, 0, 0]], []), ecods.InvalidMesh, None, {"reason": Mesh.empty}),
    (lambda: mesh().at(np.full((4, 4), np.inf)), ecods.InvalidArgument, "pose entry R(0, 0) is inf, not finite",
     {"argument": Bad.pose, "part": "R(0, 0)", "value": np.inf, "index": None}),
    (lambda: mesh().at(np.ones((4, 4))), ecods.InvalidArgument, "(3, 0) is 1, where the last row of a matrix is 0 0 0 1",
     {"argument": Bad.pose, "part": "(3, 0)"}),
    (lambda: ecods.collide_many(mesh(), [np.eye(4), np.full((4, 4), np.nan)], mesh()), ecods.InvalidArgument,
     "entry 1: pose entry R(0, 0) is nan", {"argument": Bad.pose, "index": 1}),
    (lambda: ecods.within(mesh(), mesh(), -1), ecods.InvalidArgument, None, {"argument": Bad.distance, "value": -1}),
    (lambda: ecods.Segment([0, 0, 0], [0, 0, np.inf]), ecods.InvalidArgument, None,
     {"argument": Bad.segment, "part": "b(2)"}),
    (lambda: ecods.Ray([0, 0, 0], [0, 0, 0]), ecods.InvalidArgument, None, {"argument": Bad.ray, "part": "direction"}),
    (lambda: ecods.Ball([0, 0, 0], -1), ecods.InvalidArgument, None, {"argument": Bad.ball, "part": "radius"}),
    (lambda: ecods.BroadPhase().add(0, [[0, 1, 0], [0, 0, 0]]), ecods.InvalidArgument, "[1, 0] on axis 1",
     {"argument": Bad.box, "part": "min(1)", "value": 1}),
    (lambda: ecods.orient3d([0, 0, 0], [0, np.nan, 0], [0, 0, 0], [0, 0, 0]), ecods.InvalidArgument,
     "point, axis 1: coordinate is nan, not finite", {"argument": Bad.point, "part": "(1)"}),
    (lambda: ecods.locate([0, np.nan, 0], ecods.Solid(*box())), ecods.InvalidArgument,
     "point, axis 1: coordinate is nan, not finite", {"argument": Bad.point, "part": "(1)"}),
    (lambda: ecods.Solid([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), ecods.NotSolid, None,
     {"reason": Solid.open_edge, "triangle": 0}),
    (lambda: ecods.World().update() or ecods.World().pose(5), ecods.StaleBody, None, {}),
    (lambda: ecods.World().set_pose(99, None), ecods.StaleBody, "id 99 names no body of this world", {"body": 99}),
    (lambda: ecods.World().pose(-5), ecods.StaleBody, "id -5 names no body of this world", {"body": -5, "index": None}),
    (lambda: ecods.World().nearest(2**70), ecods.StaleBody, f"id {2**70} names", {"body": 2**70}),
    (lambda: ecods.World().set_poses([1, -1], [np.eye(4)] * 2), ecods.StaleBody, "entry 1: id -1 names no body",
     {"body": -1, "index": 1}),
    (lambda: ecods.World().set_poses([7], [np.eye(4)]), ecods.StaleBody, "entry 0: id 7 names no body", {"index": 0}),
    (lambda: ecods.World().pose(3 << 32), ecods.StaleBody, f"body 3.0 is not alive in this world (id {3 << 32})",
     {"body": 3 << 32}),
    (lambda: ecods.Posed(None), ecods.InvalidArgument, "mesh is null", {"argument": Bad.null, "part": "mesh"}),
    (lambda: ecods.Moving(None, None, None), ecods.InvalidArgument, "mesh is null", {"argument": Bad.null, "part": "mesh"}),
    (lambda: ecods.Trace("nonsense").replay(), ecods.InvalidTrace, None, {"line": 1}),
    (lambda: ecods.ConvexSolid.hull(np.zeros((0, 3))), ecods.NotSolid, "there are no points",
     {"reason": Solid.no_interior, "point_count": 0}),
    (lambda: ecods.prism([[0, 0], [1, 1], [2, 2]], 1), ecods.NotSolid, None,
     {"reason": Solid.no_interior, "point_count": 6}),
    (lambda: ecods.cylinder(-1, 2, 8), ecods.InvalidArgument, "radius is -1, not finite and positive",
     {"argument": Bad.size, "part": "radius", "value": -1}),
    (lambda: ecods.cone(1, 2, 2), ecods.InvalidArgument, "sides is 2, not from 3 to 16384",
     {"argument": Bad.count, "part": "sides"}),
    (lambda: ecods.prism([[0, 0], [4, 0], [4, 4], [2, 3], [0, 4]], 1), ecods.InvalidArgument, "not convex",
     {"argument": Bad.polygon, "index": 3}),
    (lambda: ecods.height_field(np.zeros((2, 2)), [1, 1], 0), ecods.InvalidArgument, "base is 0",
     {"argument": Bad.size, "part": "base", "index": 0}),
]


@pytest.mark.parametrize("call, kind, text, members", ERRORS)
def test_errors_are_typed(call, kind, text, members):
    with pytest.raises(kind) as caught:
        call()
    error = caught.value
    assert isinstance(error, ecods.Error) and type(error) is kind and str(error)
    if text:
        assert text in str(error)
    for name, value in members.items():
        assert getattr(error, name) == value
    assert str(pickle.loads(pickle.dumps(error))) == str(error)


@pytest.mark.parametrize("call, kind", [
    (lambda: ecods.Mesh([["a"]], [[0, 0, 0]]), TypeError),
    (lambda: ecods.Mesh([[1j, 0, 0]], [[0, 0, 0]]), TypeError),
    (lambda: ecods.Mesh([[0, 0, 2**60 + 1]], [[0, 0, 0]]), ValueError),
    (lambda: ecods.Mesh(np.zeros((3, 3), np.longdouble), [[0, 0, 0]]), TypeError),
    (lambda: ecods.Mesh([[0, 0, 0]], [[0.5, 0, 0]]), TypeError),
    (lambda: ecods.Mesh([[0, 0]], [[0, 0, 0]]), ValueError),
    (lambda: mesh().at(np.eye(3)), ValueError),
    (lambda: ecods.World(threads=0), ValueError),
    (lambda: ecods.World("fastest"), TypeError),
    (lambda: ecods.locate([0, 0, 0], mesh()), TypeError),
    (lambda: ecods.World().set_poses([1.5], [np.eye(4)]), TypeError),
    (lambda: ecods.collide_many(mesh(), np.zeros((2, 4, 4)) + np.eye(4), mesh(), np.zeros((3, 4, 4)) + np.eye(4)),
     ValueError),
    (lambda: ecods.World().start_trace("/nowhere/at/all"), OSError),
])
def test_what_is_no_such_argument(call, kind):
    with pytest.raises(kind):
        call()


def test_a_refused_call_changes_nothing():
    world = ecods.World()
    body = world.create_body(mesh())
    with pytest.raises(ecods.InvalidArgument) as caught:
        world.set_poses([body, body], [at(1), np.full((4, 4), np.nan)])
    assert caught.value.index == 1 and caught.value.body == body and caught.value.argument == Bad.pose
    assert str(caught.value) == "entry 1: body 1.0: pose entry R(0, 0) is nan, not finite"
    assert np.array_equal(world.pose(body), np.eye(4))
    with pytest.raises(ecods.InvalidArgument) as caught:
        world.meetings([body], [np.full((4, 4), np.inf)])
    assert caught.value.index == 0 and caught.value.body == body
    with pytest.raises(ecods.InvalidArgument) as caught:
        world.set_poses([body], [at(1), np.full((4, 4), np.nan)])
    assert caught.value.index == 1 and caught.value.body == 0  # there is none
    with pytest.raises(ecods.InvalidArgument) as caught:
        world.set_poses([body, body], [at(1)])
    assert caught.value.argument == Bad.list_length and caught.value.value == 1
