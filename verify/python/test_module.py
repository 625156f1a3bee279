"""What the module adds to the library: arrays, lifetimes, errors, threads, pickles, stubs."""
import ast
import gc
import hashlib
import inspect
import pathlib
import pickle
import re
import threading

import numpy as np
import pytest

import ecods
from scenes import TETRAHEDRON, box, turned


def mesh():
    return ecods.Mesh(*TETRAHEDRON)


def at(x, y=0.0, z=0.0):
    return ecods.pose(t=(x, y, z))


@pytest.mark.parametrize("dtype", [np.float64, np.float32, np.int8, np.int64, np.uint16])
@pytest.mark.parametrize("indices", [np.int32, np.int64, np.uint32, np.uint64, np.uint8])
def test_meshes_take_arrays_of_any_numbers(dtype, indices):
    vertices, faces = TETRAHEDRON
    made = ecods.Mesh(np.array(vertices, dtype)[::1], np.asfortranarray(np.array(faces, indices)))
    assert made.digest == mesh().digest


def test_meshes_show_their_own_memory():
    made = mesh()
    vertices = made.vertices
    address = vertices.ctypes.data
    assert made.vertices.ctypes.data == address
    del made
    gc.collect()
    assert vertices.tolist() == TETRAHEDRON[0]
    with pytest.raises(ValueError):
        vertices[0, 0] = 1


ERRORS = [
    (lambda: ecods.Mesh([[0, 0, np.nan]], [[0, 0, 0]]), ecods.InvalidVertex,
     "vertex 0, axis 2: coordinate is nan, not finite", {"vertex": 0, "axis": 2}),
    (lambda: ecods.Mesh([[0, 0, 0]], [[0, 0, 7]]), ecods.InvalidIndex, None, {"triangle": 0, "corner": 2, "value": 7}),
    (lambda: ecods.Mesh([[0, 0, 0]], [[0, 0, -1]]), ecods.InvalidIndex,
     "triangle 0, corner 2: vertex index -1 is out of range; there are 1 vertices", {"value": -1}),
    (lambda: ecods.Mesh([[0, 0, 0]], np.array([[0, -2**31, 0]], np.int32)), ecods.InvalidIndex, "index -2147483648 is",
     {"value": -2**31, "corner": 1, "vertex_count": 1}),
    (lambda: ecods.Mesh([[0, 0, 0]], np.array([[0, 2**64 - 1, 0]], np.uint64)), ecods.InvalidIndex,
     "index 18446744073709551615 is", {"value": 2**64 - 1}),
    (lambda: ecods.Mesh([[0, 0, 0]], [[0, 0, 2**40]]), ecods.InvalidIndex, "index 1099511627776 is", {"value": 2**40}),
    (lambda: ecods.Mesh([[0, 0, 0]], []), ecods.EmptyMesh, None, {}),
    (lambda: mesh().at(np.full((4, 4), np.inf)), ecods.InvalidPose, "pose entry R(0, 0) is inf, not finite",
     {"row": 0, "column": 0, "index": None}),
    (lambda: mesh().at(np.ones((4, 4))), ecods.InvalidPose, None, {"row": 3, "column": 0}),
    (lambda: ecods.collide_many(mesh(), [np.eye(4), np.full((4, 4), np.nan)], mesh()), ecods.InvalidPose, None,
     {"index": 1}),
    (lambda: ecods.within(mesh(), mesh(), -1), ecods.InvalidDistance, None, {"value": -1}),
    (lambda: ecods.Segment([0, 0, 0], [0, 0, np.inf]), ecods.InvalidSegment, None, {"end": 1, "axis": 2}),
    (lambda: ecods.Ray([0, 0, 0], [0, 0, 0]), ecods.InvalidRay, None, {}),
    (lambda: ecods.Ball([0, 0, 0], -1), ecods.InvalidBall, None, {"axis": 3}),
    (lambda: ecods.orient3d([0, 0, 0], [0, np.nan, 0], [0, 0, 0], [0, 0, 0]), ecods.InvalidPoint, None, {"axis": 1}),
    (lambda: ecods.Solid([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), ecods.NotClosed, None, {"triangle": 0}),
    (lambda: ecods.World().update() or ecods.World().pose(5), ecods.StaleBody, None, {}),
    (lambda: ecods.World().set_pose(99, None), ecods.StaleBody, "id 99 names no body of this world", {"body": 99}),
    (lambda: ecods.World().pose(-5), ecods.StaleBody, "id -5 names no body of this world", {"body": -5, "index": None}),
    (lambda: ecods.World().nearest(2**70), ecods.StaleBody, f"id {2**70} names", {"body": 2**70}),
    (lambda: ecods.World().set_poses([1, -1], [np.eye(4)] * 2), ecods.StaleBody, "entry 1: id -1 names no body",
     {"body": -1, "index": 1}),
    (lambda: ecods.World().set_poses([7], [np.eye(4)]), ecods.StaleBody, "entry 0: id 7 names no body", {"index": 0}),
    (lambda: ecods.World().pose(3 << 32), ecods.StaleBody, f"body 3.0 is not alive in this world (id {3 << 32})",
     {"body": 3 << 32}),
    (lambda: ecods.Posed(None), ecods.NullArgument, None, {}),
    (lambda: ecods.Moving(None, None, None), ecods.NullArgument, None, {}),
    (lambda: ecods.Trace("nonsense").replay(), ecods.InvalidTrace, None, {"line": 1}),
    (lambda: ecods.ConvexSolid.hull(np.zeros((5, 3))), ecods.NoInterior, None, {"point_count": 5}),
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
    with pytest.raises(ecods.InvalidPose) as caught:
        world.set_poses([body, body], [at(1), np.full((4, 4), np.nan)])
    assert caught.value.index == 1 and caught.value.body == body
    assert np.array_equal(world.pose(body), np.eye(4))
    with pytest.raises(ecods.InvalidPose) as caught:
        world.meetings([body], [np.full((4, 4), np.inf)])
    assert caught.value.index == 0 and caught.value.body == body
    with pytest.raises(ecods.InvalidPose) as caught:
        world.set_poses([body], [at(1), np.full((4, 4), np.nan)])
    assert caught.value.index == 1 and caught.value.body == 0  # there is none
    with pytest.raises(ecods.LengthMismatch):
        world.set_poses([body, body], [at(1)])


def test_world_events_and_bodies():
    world = ecods.World(ecods.BroadPhaseKind.sweep_and_prune)
    a = world.create_body(mesh())
    b = world.create_body(mesh(), at(5), user_data=7)
    world.update()
    assert world.colliding_pairs().shape == (0, 2) and len(world) == 2
    world.set_pose(b, at(1))
    world.update()
    assert world.began().tolist() == [[a, b]] == world.colliding_pairs().tolist()
    assert world.colliding_pairs().dtype == np.uint64
    assert world.relation(*world.began()[0]) == ecods.Relation.touching
    world.destroy_body(b)
    world.update()
    assert world.ended().tolist() == [[a, b]] and not world.is_alive(b)
    assert ecods.body_name(a) == "1.0" and world.mesh(a).digest == mesh().digest
    assert world.statistics()["updates"] == 3


def test_ids_of_other_worlds_are_refused():
    one, other = ecods.World(), ecods.World()
    body = one.create_body(mesh())
    other.create_body(mesh())
    with pytest.raises(ecods.StaleBody):
        other.pose(body)


def test_filters_clearance_nearest_and_hits():
    world = ecods.World()
    a, b, c = (world.create_body(mesh(), at(x)) for x in (0, 1.5, 9))
    world.set_clearance(0.5)
    world.update()
    assert world.close_pairs().tolist() == [[a, b]] and world.close_began().tolist() == [[a, b]]
    assert world.nearest(a).body == b and world.nearest(a).distance == 0.5
    assert world.nearest(mesh().at(at(8)), filter=ecods.CollisionFilter(1, 0)) is None
    assert world.closest_pair().bodies == (a, b)
    assert world.nearest(c, limit=1.0) is None
    hit = world.first_hit(ecods.Ray([-1, 0.25, 0.25], [1, 0, 0]))
    assert hit.body == a and hit.hit.parameter == 1 and hit.hit.kind == ecods.HitKind.front or hit.hit.kind
    assert len(world.all_hits(ecods.Segment([-1, 0.25, 0.25], [20, 0.25, 0.25]))) == 6
    contact = world.cast(a, [1, 0, 0])
    assert contact.body == b and contact.contact.time == 0.5
    assert world.cast(mesh().at(at(-2)), [1, 0, 0], filter=ecods.CollisionFilter()).contact.time == 1.0
    meetings = world.meetings([c], [at(1.5)])
    assert meetings[0].bodies == (b, c)
    assert world.intersecting_bodies(mesh().at(at(1))).tolist() == [a, b]
    assert world.overlapping_bodies([[8.5, 0, 0], [10, 1, 1]]).tolist() == [c]
    world.set_pair_enabled(a, b, False)
    world.set_filter(c, 2, 4)
    assert world.filter(c) == ecods.CollisionFilter(2, 4)
    world.update()
    assert world.close_ended().tolist() == [[a, b]]
    assert str(world.certify()) and world.certify().apart_count >= 0


def test_solids_and_convex_solids():
    cube = ecods.ConvexSolid(*box())
    inner = ecods.Solid(*box(0.5, 0.5, 0.5)).at(at(0.25, 0.25, 0.25))
    assert ecods.solid_relation(inner, cube) == ecods.SolidRelation.inside
    assert ecods.surface_relation(inner.mesh, cube) == ecods.SurfaceRelation.inside
    assert ecods.locate([1, 1, 0.5], cube).feature.kind == ecods.FeatureKind.edge
    assert ecods.locate_many([[0.5, 0.5, 0.5], [1, 1, 1], [2, 0, 0]], cube).tolist() == [2, 1, 0]
    deep = ecods.depth(cube, cube.at(at(0.75)))
    assert deep.depth == 0.25 and deep.direction.tolist() == [1, 0, 0]
    assert ecods.depth_bounds(cube, cube.at(at(0.75))).lower <= 0.25
    assert ecods.solid_distance(cube, cube.at(at(3))) == 2
    assert ecods.solid_closest(cube, cube) is None
    with pytest.raises(ecods.SolidsApart):
        ecods.depth(cube, cube.at(at(3)))
    assert len(ecods.ConvexSolid.hull(np.array(box()[0] + [[0.5, 0.5, 0.5]])).vertices) == 8
    world = ecods.World()
    bodies = [world.create_body(cube), world.create_body(cube, at(0.75)), world.create_body(mesh(), at(9))]
    world.set_solids(True)
    world.update()
    assert [p.relation for p in world.solid_pairs()] == [ecods.SolidRelation.overlapping]
    assert world.depths()[0].depth.depth == 0.25 and world.depth(bodies[0], bodies[1]).depth == 0.25
    assert world.solid_distances(1.0)[0].distance == 0
    containing = world.bodies_containing([0.9, 0.5, 0.5])
    assert [each.side for each in containing.bodies] == [ecods.Side.inside] * 2 and containing.skipped_count == 1
    with pytest.raises(ecods.NotSupported):
        world.solid_relation(bodies[0], bodies[2])
    assert isinstance(world.mesh(bodies[0]), ecods.ConvexSolid)


def test_pairs_without_a_world():
    a, b = mesh(), mesh().at(at(1))
    assert [len(x.corners) for x in ecods.intersections(a, b)] and ecods.self_intersections(a).shape == (0, 2)
    assert ecods.close_triangles(a, b, 0.1) and ecods.close_features(a, b, 0.1)
    assert ecods.cast(a, [0.5, 0, 0], mesh().at(at(1.25))).time == 0.5
    assert ecods.cast(mesh().moving(None, at(2)), mesh().moving(at(3), at(3))).time == 1.0
    assert ecods.orient2d([0, 0], [1, 0], [[0, 1], [0, -1]]).tolist() == [1, -1]
    assert ecods.orient2d_along([0, 0, 0], [1, 0, 0], [0, 1, 0], 2) == ecods.Sign.positive
    for certificate in (ecods.certify(a, b), ecods.certify_distance(a, b), ecods.certify_within(a, b, 1.0)):
        assert ecods.certified_mesh_digest(a) in str(certificate)
    assert ecods.certified_mesh_digest(a) == hashlib.sha256(ecods.certified_mesh(a).encode()).hexdigest()
    assert ecods.certify_hit(ecods.Segment([-1, 0.1, 0.1], [1, 0.1, 0.1]), a).claim == ecods.Claim.hit
    low, high = ecods.box_of(b)
    assert (low <= [1, 0, 0]).all() and (high >= [2, 1, 1]).all() and (high - low < 1.001).all()
    parameters, triangles = ecods.first_hits([[-1, 0.25, 0.25], [-1, 5, 5]], [[1, 0, 0]] * 2, a)
    assert parameters[0] == 1 and np.isnan(parameters[1]) and triangles[1] == -1
    boxes = ecods.BroadPhase("brute_force")
    for i in range(3):
        boxes.add(i, [[i, 0, 0], [i + 1, 1, 1]])
    boxes.update()
    assert boxes.pairs().tolist() == [[0, 1], [1, 2]] == boxes.began().tolist()
    assert boxes.find(ecods.Ball([0, 0, 0], 0.5)).tolist() == [0]


@pytest.mark.parametrize("threads", [1, 3])
def test_many_poses_are_the_poses_one_by_one(threads):
    cube = ecods.Mesh(*box())
    poses = np.array([turned(0.1 * i, (0.07 * i, 0.5, 0.25)) for i in range(60)])
    pairs = [(cube.at(pose), cube) for pose in poses]
    assert ecods.collide_many(cube, poses, cube, threads=threads).tolist() == [ecods.intersects(*p) for p in pairs]
    assert ecods.distance_many(cube, poses, cube, threads=threads).tolist() == [ecods.distance(*p) for p in pairs]
    assert ecods.relation_many(cube, poses, cube, threads=threads).tolist() == [ecods.relation(*p) for p in pairs]
    assert ecods.within_many(cube, poses, cube, None, 0.5).tolist() == [ecods.within(*p, 0.5) for p in pairs]
    assert ecods.collide_many(cube, poses[:, :3], cube, poses).all()


@pytest.mark.parametrize("kind", [ecods.Mesh, ecods.Solid, ecods.ConvexSolid])
def test_posed_is_at(kind):
    made = kind(*box())
    for posed in (ecods.Posed(made, at(2)), ecods.Posed(mesh=made, pose=at(2)[:3]), made.at(at(2)), made.at(pose=at(2))):
        assert posed.mesh is made and np.array_equal(posed.pose, at(2)) and ecods.distance(posed, made) == 1
    assert repr(ecods.Moving(made, None, end=at(2))) == repr(made.moving(None, at(2)))
    assert np.array_equal(ecods.Posed(made).pose, np.eye(4)) and ecods.intersects(ecods.Posed(made), made)
    with pytest.raises(ecods.InvalidPose):
        ecods.Posed(made, np.full((4, 4), np.nan))


def test_ids_that_are_none_are_not_alive():
    world = ecods.World()
    body = world.create_body(mesh())
    assert world.is_alive(body) and not any(world.is_alive(each) for each in (0, 99, -1, 2**64, body + (1 << 16)))


def test_traces(tmp_path):
    world = ecods.World()
    world.start_trace(questions=True)
    bodies = [world.create_body(mesh(), at(x)) for x in (0, 1)]
    world.update()
    world.closest_pair()
    trace = pickle.loads(pickle.dumps(world.end_trace()))
    report = trace.replay(broad_phase="brute_force", threads=2, validates=True)
    assert report.difference is None and report.update_count == 1 and report.question_count == 1
    changed = ecods.Trace(re.sub(r"^(update \w+) 1", r"\1 2", trace.text, flags=re.M))
    assert "2" in changed.replay().difference.what
    world.start_trace(str(tmp_path / "trace"))
    world.set_pose(bodies[0], at(9))
    assert world.end_trace() is None and "set_pose" in (tmp_path / "trace").read_text()


@pytest.mark.parametrize("threads", [1, 2])
def test_threads_of_python_may_share_a_world(threads):
    world = ecods.World(threads=threads)
    cube = ecods.Mesh(*box())
    bodies = [world.create_body(cube, at(0.9 * i)) for i in range(40)]
    failures = []

    def move(seed):
        try:
            for step in range(30):
                world.set_poses(bodies[seed::4], [at(0.9 * i + 0.001 * step) for i in range(seed, 40, 4)])
                world.update()
                world.closest_pair()
                world.distance(bodies[seed], bodies[39 - seed])
        except Exception as error:  # noqa: BLE001
            failures.append(error)

    workers = [threading.Thread(target=move, args=(seed,)) for seed in range(4)]
    for each in workers:
        each.start()
    for each in workers:
        each.join()
    world.update()
    world.validate()
    alone = ecods.World()
    for body in bodies:
        alone.create_body(cube, world.pose(body))
    alone.update()
    assert not failures and alone.digest() == world.digest()


def test_the_lock_is_released():
    cube = ecods.Mesh(*box())
    poses = np.array([turned(0.001 * i, (0.4, 0.5, 0.25)) for i in range(20000)])
    count, stop = [0], threading.Event()

    def tick():
        while not stop.is_set():
            count[0] += 1
            stop.wait(0.0005)

    ticker = threading.Thread(target=tick)
    ticker.start()
    before = count[0]
    ecods.distance_many(cube, poses, cube)
    after = count[0]
    stop.set()
    ticker.join()
    assert after > before


def test_stubs_name_what_there_is():
    tree = ast.parse(pathlib.Path(ecods.__file__).with_name("__init__.pyi").read_text())
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    imported = {alias.name for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names}
    assert {name for name in ecods.__all__ if name != "__version__"} <= set(classes) | functions | imported
    for name, node in classes.items():
        kind = getattr(ecods, name)
        stubbed = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
        if not issubclass(kind, (Exception, int)):
            assert {member for member in vars(kind) if not member.startswith("_")} <= stubbed, name
    text = ast.unparse(classes["World"])
    assert "def set_pose(self, body: int, pose: ArrayLike) -> None" in text
    assert "def relation(self, a: int, b: int) -> Relation" in text


def test_stubs_of_the_inner_module_name_all_that_it_has():
    tree = ast.parse(pathlib.Path(ecods.__file__).with_name("_ecods.pyi").read_text())
    named = {alias.asname for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names}
    assert named == {name for name in vars(ecods._ecods) if not name.startswith("_")} | {"__version__"}


def test_everything_is_documented():
    for name in ecods.__all__:
        thing = getattr(ecods, name)
        assert name == "__version__" or inspect.getdoc(thing), name
    for member, call in vars(ecods.World).items():
        if not member.startswith("_"):
            assert len(call.__doc__.splitlines()) > 1, member
