"""What the module adds to the library: arrays, lifetimes, worlds, pairs, traces."""
import gc
import hashlib
import pickle
import re

import numpy as np
import pytest

import ecods
from scenes import TETRAHEDRON, at, box, mesh, turned


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
    assert world.closest_pair(groups_a=1, groups_b=2) is None
    assert len(world.closest_pairs(np.inf)) == 3 and world.closest_pairs(0.5) == [world.closest_pair()]
    assert world.closest_pair().points.distance == world.closest_pair().distance
    assert world.nearest(c, max_distance=1.0) is None
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


LIMITED = {"within", "close_features"}
PAIR_QUESTIONS = ["intersects", "relation", "intersecting_triangles", "intersections", "distance", "within", "closest",
                  "close_features", "depth", "depth_bounds", "signed_distance"]


@pytest.mark.parametrize("question", PAIR_QUESTIONS)
def test_a_world_is_asked_about_ids_and_posed_meshes(question):
    limits = [0.5] if question in LIMITED else []
    world = ecods.World()
    cube = ecods.ConvexSolid(*box())
    ask = getattr(world, question)
    for x in (0.75, 1.0, 1.25):
        a, b = world.create_body(cube), world.create_body(cube, at(x))
        expected = getattr(ecods, question)(cube, cube.at(at(x)), *limits)
        for pair in ((a, b), (a, world.posed(b)), (cube, b), (cube.at(np.eye(4)), cube.at(at(x)))):
            assert np.array_equal(ask(*pair, *limits), expected)
        with pytest.raises(ecods.SameBody):
            ask(a, a, *limits)
        ask(a, world.posed(a), *limits)
        with pytest.raises(ecods.StaleBody):
            ask(cube, a + 1000, *limits)


def test_a_world_is_asked_about_everything_with_a_filter():
    world = ecods.World()
    a, b, c = (world.create_body(mesh(), at(x), groups=groups) for x, groups in ((0, 1), (1, 2), (1.5, 4)))
    for subject in (a, world.posed(a), mesh()):
        of_c = ecods.CollisionFilter(1, 4)
        others = [body for body in (a, b) if body is not subject]
        assert world.intersecting_bodies(subject).tolist() == others
        assert world.nearest(subject, filter=of_c) == world.nearest(subject, 9.0, of_c)
        assert world.nearest(subject, filter=of_c).body == c
        assert world.nearest(subject, 0.25, of_c) is None
        assert world.cast(subject, [1, 0, 0], filter=of_c).contact.time == 0.5
        assert world.cast(subject, [1, 0, 0], 0.25, of_c) is None
        assert world.intersecting_bodies(subject, filter=of_c).tolist() == []


def test_a_posed_mesh_keeps_its_mesh():
    posed, moving = mesh().at(at(1)), ecods.Moving(mesh(), at(1), at(2))
    gc.collect()
    assert posed.mesh.digest == moving.mesh.digest == mesh().digest
    assert posed.mesh is posed.mesh and type(ecods.ConvexSolid(*box()).at(at(1)).mesh) is ecods.ConvexSolid
    assert ecods.distance(posed, mesh()) == 0 and ecods.cast(moving, moving).time == 0


def test_relations_are_one_enum():
    names = ["apart", "touching", "crossing", "overlapping", "inside", "contains", "equal"]
    assert [each.name for each in ecods.Relation] == names
    gone = ("SolidRelation", "SurfaceRelation", "SolidPair", "solid_relation", "surface_relation", "solid_distance",
            "solid_closest")
    assert not any(hasattr(ecods, name) for name in gone)
    room = ecods.Solid(*box())
    for x, relation in ((3, "apart"), (0.75, "crossing"), (0.25, "inside")):
        inner = ecods.Mesh(*box(0.5, 0.5, 0.5)).at(at(x, 0.25, 0.25))
        assert ecods.relation(inner, room) == ecods.Relation[relation]
        assert ecods.intersects(inner, room) == (relation != "apart")
    assert ecods.relation(room, inner) == ecods.Relation.contains


def test_a_solid_is_all_of_its_points():
    room = ecods.Solid(*box(4, 4, 4))
    inner = ecods.Mesh(*box()).at(at(1, 1, 1))
    assert ecods.intersects(inner, room) and ecods.distance(inner, room) == 0 and ecods.within(inner, room, 0)
    assert ecods.intersecting_triangles(inner, room).shape == (0, 2)
    closest = ecods.closest(inner, room)
    assert closest.kind == ecods.ClosestKind.contained and closest.point_a.tolist() == closest.point_b.tolist()
    assert closest.a.kind == ecods.FeatureKind.vertex and closest.b.kind == ecods.FeatureKind.none
    first = ecods.cast(inner, [9, 0, 0], room)
    assert (first.time, first.kind) == (0, ecods.ClosestKind.contained)
    ray = ecods.Ray([1, 2, 3], [1, 0, 0])
    hits = ecods.all_hits(ray, room)
    assert [hit.kind for hit in hits[:1]] == [ecods.HitKind.inside] and hits[0] == ecods.first_hit(ray, room)
    assert hits[0].parameter == 0 and hits[0].feature.kind == ecods.FeatureKind.none and hits[1].parameter == 3
    parameters, triangles = ecods.first_hits([[1, 2, 3], [-1, 2, 3]], [[1, 0, 0]] * 2, room)
    assert parameters.tolist() == [0, 1] and triangles[0] == -1 and triangles[1] >= 0
    world = ecods.World()
    a, b = world.create_body(room), world.create_body(inner.mesh, inner.pose)
    world.set_relations(True)
    world.update()
    assert world.colliding_pairs().tolist() == [[a, b]] and world.nearest(b).distance == 0
    assert [(each.bodies, each.relation) for each in world.relations()] == [((a, b), ecods.Relation.contains)]


def test_a_surface_is_asked_for():
    room = ecods.ConvexSolid(*box(4, 4, 4))
    surface = ecods.surface_of(room)
    inner = ecods.Mesh(*box()).at(at(1, 1, 1))
    assert surface is ecods.surface_of(room) and type(surface) is ecods.Mesh and surface.digest == room.digest
    forms = [kind(*box()).form for kind in (ecods.Mesh, ecods.Solid, ecods.ConvexSolid)]
    assert forms == [ecods.MeshForm.surface, ecods.MeshForm.solid, ecods.MeshForm.convex]
    assert surface.form == ecods.MeshForm.surface
    assert ecods.relation(inner, surface) == ecods.Relation.apart and ecods.distance(inner, surface) == 1
    assert ecods.first_hit(ecods.Ray([1, 2, 3], [1, 0, 0]), surface).parameter == 3
    del room
    gc.collect()
    assert ecods.distance(inner, surface) == 1


def test_solids_and_convex_solids():
    cube = ecods.ConvexSolid(*box())
    inner = ecods.Solid(*box(0.5, 0.5, 0.5)).at(at(0.25, 0.25, 0.25))
    assert ecods.relation(inner, cube) == ecods.Relation.inside
    assert ecods.relation(inner.mesh, cube) == ecods.Relation.inside
    assert ecods.locate([1, 1, 0.5], cube).feature.kind == ecods.FeatureKind.edge
    assert ecods.locate_many([[0.5, 0.5, 0.5], [1, 1, 1], [2, 0, 0]], cube).tolist() == [2, 1, 0]
    asked = [[0.5, 0.5, 0.25], [1, 1, 1], [2, 0.5, 0.5], [4, 5, 0.5]]
    assert ecods.signed_distance_many(asked, cube, threads=2).tolist() == [-0.25, 0, 1, 5]
    assert [ecods.signed_distance(p, cube) for p in asked] == [-0.25, 0, 1, 5]
    nearest, distances, triangles = ecods.closest_many(asked, cube)
    assert nearest.tolist() == [[0.5, 0.5, 0.25], [1, 1, 1], [1, 0.5, 0.5], [1, 1, 0.5]]
    assert distances.tolist() == [0, 0, 1, 5] and triangles[0] == -1
    for i, p in enumerate(asked):
        one = ecods.closest_point(p, cube)
        assert one.distance == distances[i] and one.point.tolist() == nearest[i].tolist()
        assert one.feature.kind == ecods.FeatureKind.none or one.feature.triangle == triangles[i]
    assert ecods.signed_distance([0.5, 0.5, 0.25], ecods.surface_of(cube)) == 0.25
    with pytest.raises(ecods.InvalidArgument) as refused:
        ecods.closest_many(asked + [[0, np.nan, 0]], cube, threads=2)
    assert refused.value.index == 4
    deep = ecods.depth(cube, cube.at(at(0.75)))
    assert deep.depth == 0.25 and deep.direction.tolist() == [1, 0, 0]
    assert ecods.depth_bounds(cube, cube.at(at(0.75))).lower <= 0.25
    assert ecods.distance(cube, cube.at(at(3))) == 2
    for x in (0.75, 1, 3):
        found = ecods.signed_distance(cube, cube.at(at(x)), ecods.Witness())
        assert found.distance == x - 1 and found.direction.tolist() == [1, 0, 0]
        assert (found.point_b - found.point_a).tolist() == [x - 1, 0, 0]
        for other in (cube, ecods.Solid(*box())):
            interval = ecods.signed_distance_bounds(cube, other.at(at(x)))
            assert interval.lower <= x - 1 <= interval.upper
        assert (interval := ecods.signed_distance_bounds(cube, cube.at(at(x)))).lower == interval.upper == x - 1
    assert ecods.closest(cube, cube).kind == ecods.ClosestKind.intersecting
    assert ecods.depth(cube, cube.at(at(3))) is None and ecods.depth_bounds(cube, cube.at(at(3))) is None
    assert len(ecods.ConvexSolid.hull(np.array(box()[0] + [[0.5, 0.5, 0.5]])).vertices) == 8
    world = ecods.World()
    bodies = [world.create_body(cube), world.create_body(cube, at(0.75)), world.create_body(mesh(), at(9))]
    assert world.are_relations_listed() is False
    world.set_relations(True)
    world.update()
    assert [p.relation for p in world.relations()] == [ecods.Relation.overlapping]
    assert world.depths()[0].depth.depth == 0.25 and world.depth(bodies[0], bodies[1]).depth == 0.25
    assert world.signed_distances(1.0)[0].distance == -0.25
    containing = world.bodies_containing([0.9, 0.5, 0.5])
    assert [each.side for each in containing.bodies] == [ecods.Side.inside] * 2 and containing.skipped_count == 1
    with pytest.raises(ecods.NotSupported):
        world.depth(bodies[0], bodies[2])
    assert isinstance(world.mesh(bodies[0]), ecods.ConvexSolid)


def test_flat_convex_solids():
    """A polygon, a segment and a point: the same questions as of other convex solids."""
    plate = ecods.ConvexSolid.hull([[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0], [0, 0, 0]])
    rod, dot = ecods.ConvexSolid.hull([[0, 0, -1], [0, 0, 1]]), ecods.ConvexSolid.hull([[0, 0, 0]])
    cube = ecods.ConvexSolid(np.array(box(6, 6, 6)[0]) - 3.0, box()[1])
    assert [solid.dimension for solid in (cube, plate, rod, dot)] == [3, 2, 1, 0]
    assert ecods.ConvexSolid(plate.vertices, plate.faces).dimension == 2
    assert ecods.relation(rod, plate) == ecods.Relation.crossing
    assert ecods.relation(plate, cube) == ecods.Relation.inside
    assert ecods.distance(plate.at(at(0, 0, 5)), cube) == 2
    found = ecods.signed_distance(plate, rod.at(at(0.5, 0, 0.25)))
    assert found.distance == -0.75 and found.direction.tolist() == [0, 0, 1]
    assert ecods.depth(dot, dot).depth == 0 and ecods.depth(dot, plate.at(at(0, 0, 1))) is None
    assert ecods.locate([0, 0, 0], rod).side == ecods.Side.on
    with pytest.raises(ecods.NotSolid):
        ecods.Solid(plate.vertices, plate.faces)
    world = ecods.World()
    first, second = world.create_body(plate), world.create_body(rod)
    world.update()
    assert world.colliding_pairs().tolist() == [[first, second]]


def test_turns():
    point, target = (ecods.point_cloud([at]) for at in ((5, 0, 0), (3, 4, 0)))
    half = ecods.Turn((0, 0, 0, 1), (0, 0, 0), (0, 0, 0))
    contact = ecods.cast(point.turning(None, half), target)
    assert contact.time == 1 / 3 and contact.kind == ecods.ClosestKind.vertex_vertex
    assert ecods.cast(ecods.Turning(point, None, half), target, max_time=0.25) is None
    assert ecods.cast(point.turning(None, half), [0, 0, 3], target.at(ecods.pose(t=(0, 0, -1)))).time == 1 / 3
    assert ecods.angle_at(half, 0.5) == np.pi / 2 and ecods.time_at(half, np.pi / 2) == 0.5
    quarter = ecods.about([0, 0, 2], np.pi / 2, [1, 0, 0])
    end = ecods.pose_at(None, quarter, 1)
    assert np.allclose(end, [[0, -1, 0, 1], [1, 0, 0, -1], [0, 0, 1, 0], [0, 0, 0, 1]])
    back = ecods.between(None, end, [1, 0, 0])
    assert np.allclose(back.q, quarter.q) and ecods.end_gap(point, None, back, end) < 1e-14
    with pytest.raises(ecods.InvalidArgument, match="a whole turn has no axis; turn twice"):
        ecods.Turn((-1, 0, 0, 0), (0, 0, 0), (0, 0, 0))


def test_pairs_without_a_world():
    a, b = mesh(), mesh().at(at(1))
    assert [len(x.corners) for x in ecods.intersections(a, b)] and ecods.self_intersections(a).shape == (0, 2)
    assert ecods.close_triangles(a, b, 0.1) and ecods.close_features(a, b, 0.1)
    assert ecods.cast(a, [0.5, 0, 0], mesh().at(at(1.25))).time == 0.5
    assert ecods.cast(mesh().moving(None, at(2)), mesh().moving(at(3), at(3))).time == 1.0
    assert ecods.cast(a, [0.5, 0, 0], mesh().at(at(1.25)), max_time=0.25) is None
    assert ecods.cast(mesh().moving(None, at(2)), mesh().moving(at(3), at(3)), 0.5) is None
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
    with pytest.raises(ecods.InvalidArgument):
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
    report = trace.replay(broad_phase="brute_force", threads=2, checks_invariants=True)
    assert report.difference is None and report.update_count == 1 and report.question_count == 1
    changed = ecods.Trace(re.sub(r"^(update \w+) 1", r"\1 2", trace.text, flags=re.M))
    assert "2" in changed.replay().difference.what
    world.start_trace(str(tmp_path / "trace"))
    world.set_pose(bodies[0], at(9))
    assert world.end_trace() is None and "set_pose" in (tmp_path / "trace").read_text()
