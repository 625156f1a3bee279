"""Each class of the package: how its objects are written, copied and pickled."""
import copy
import enum
import inspect
import pickle

import numpy as np
import pytest

import ecods
from scenes import TETRAHEDRON, box, turned

MESH = ecods.Mesh(*TETRAHEDRON)
CUBE = ecods.ConvexSolid(*box())
SURFACE = ecods.surface_of(CUBE)
NEAR = CUBE.at(ecods.pose(t=(0.75, 0, 0)))
FAR = ecods.pose(t=(3, 0, 0))

WAY = ecods.Way(CUBE, FAR, [ecods.WayNode((1, 0, 0, 0)), ecods.WayNode((0, 0, 0.1, 1), (1, 2, 3)), ecods.WayNode((-1, 0, 0, 0))])


def world(shape=CUBE):
    made = ecods.World("sweep_and_prune", threads=2)
    made.create_body(shape)
    made.create_body(shape, NEAR.pose)
    made.set_relations(True)
    made.update()
    return made


def broad_phase():
    made = ecods.BroadPhase("brute_force")
    made.add(3, [[0, 0, 0], [1, 1, 1]])
    made.add(1, [[0, 0, 0], [np.inf, 1, 1]])
    return made


def trace():
    made = ecods.World()
    made.start_trace()
    made.create_body(MESH)
    made.update()
    return made.end_trace()


def manager():
    made = ecods.CollisionManager()
    for name, x in (("a", 0), ("b", 0.5), (3, 9)):
        made.add_object(name, CUBE, ecods.pose(t=(x, 0, 0)))
    return made


def moving_world():
    made = world()
    return made.meetings(made.bodies()[1:], [FAR])


RAY = ecods.Ray([-1, 0.25, 0.25], [1, 0, 0])
# An object of each class; a class that is missing here fails below.
MAKERS = {
    "Mesh": lambda: MESH,
    "Solid": lambda: ecods.Solid(*box()),
    "ConvexSolid": lambda: CUBE,
    "Circumscribed": lambda: ecods.cylinder(0.1, 1, 3),
    "Posed": lambda: NEAR,
    "Moving": lambda: CUBE.moving(None, turned(1, (1, 2, 3))),
    "Deforming": lambda: ecods.Deforming(MESH, MESH.vertices + 1),
    "Turn": lambda: ecods.about([0, 0, 1], 0.1, [1, 2, 3]),
    "Turning": lambda: CUBE.turning(FAR, ecods.Turn([1, 0, 0, 0.5], [0, 0, 0], [0, 0, 1])),
    "Translation": lambda: ecods.Translation([0.1, 0, -2]),
    "Straight": lambda: ecods.Straight(FAR),
    "WayNode": lambda: WAY.nodes[1],
    "Along": lambda: ecods.Along(WAY.nodes),
    "Way": lambda: WAY,
    "WayContact": lambda: ecods.cast(WAY, NEAR.mesh.at(FAR)),
    "Rounded": lambda: ecods.rounded(CUBE, 0.5),
    "HalfSpace": lambda: ecods.HalfSpace([1, 2, 3], -0.5),
    "PosedHalfSpace": lambda: ecods.HalfSpace([0, 0, 1], 2).at(FAR),
    "PosedRounded": lambda: ecods.sphere(0.1).at(FAR),
    "Segment": lambda: ecods.Segment([0, 0.1, -0.0], [1e300, 5e-324, 1 / 3]),
    "Ray": lambda: RAY,
    "Ball": lambda: ecods.Ball([1, 2, 3], 0.1),
    "Feature": lambda: ecods.closest(CUBE, CUBE.at(FAR)).a,
    "ClosestPoints": lambda: ecods.closest(CUBE, CUBE.at(FAR)),
    "ClosestPoint": lambda: ecods.closest_point([4, 0.5, 0.25], CUBE),
    "CloseFeatures": lambda: ecods.close_features(CUBE, CUBE.at(FAR), 2.0)[0],
    "DistanceBounds": lambda: ecods.distance_bounds(CUBE, CUBE.at(FAR), relative=0.5),
    "TriangleIntersection": lambda: ecods.intersections(CUBE, NEAR)[0],
    "Hit": lambda: ecods.first_hit(RAY, CUBE),
    "SidedHit": lambda: ecods.sided_hits(RAY, CUBE)[0],
    "InsidePart": lambda: ecods.inside_parts(ecods.Ray([-1, 0.25, 0.5], [1, 0, 0]), CUBE)[0],
    "BodySidedHit": lambda: world().sided_hits(RAY)[0],
    "BodyInsidePart": lambda: world().inside_parts(ecods.Ray([-1, 0.25, 0.5], [1, 0, 0]))[0],
    "FirstEntry": lambda: ecods.entering(CUBE, [3, 0, 0], CUBE.at(FAR)) or ecods.FirstEntry,
    "BodyEntry": lambda: world().entering(CUBE.at(FAR), [-9, 0, 0]),
    "ContactPoint": lambda: ecods.contact_point(CUBE, [3, 0, 0], CUBE.at(FAR), ecods.cast(CUBE, [3, 0, 0], CUBE.at(FAR))),
    "FirstContact": lambda: ecods.cast(CUBE, [3, 0, 0], CUBE.at(FAR)),
    "Location": lambda: ecods.locate([1, 1, 0.5], CUBE),
    "Depth": lambda: ecods.depth(CUBE, NEAR),
    "SignedDistance": lambda: ecods.signed_distance(CUBE, NEAR),
    "DepthPoints": lambda: ecods.depth_points(CUBE, NEAR),
    "DepthAlong": lambda: ecods.depth_along(CUBE, NEAR, [1, 2, 3]),
    "ContactPatch": lambda: ecods.contact_patch(CUBE, NEAR),
    "PatchCorner": lambda: ecods.contact_patch(CUBE, NEAR).corners[0],
    "DepthBounds": lambda: ecods.depth_bounds(CUBE, NEAR),
    "NearestBody": lambda: world().nearest(MESH.at(FAR)),
    "ClosestPair": lambda: world().closest_pair(),
    "BodyHit": lambda: world().first_hit(RAY),
    "BodyContact": lambda: world().cast(MESH.at(FAR), [-3, 0, 0]),
    "Meeting": lambda: moving_world()[0],
    "PairRelation": lambda: world().relations()[0],
    "BodyDepth": lambda: world().depths()[0],
    "BodyPatch": lambda: world().contact_patches(max_corners=2)[0],
    "PairDistance": lambda: world().signed_distances(1.0)[0],
    "BodyAt": lambda: world().bodies_containing([0.9, 0.5, 0.5]).bodies[0],
    "BodiesContaining": lambda: world().bodies_containing([0.9, 0.5, 0.5]),
    "Witness": lambda: ecods.Witness(),
    "Certificate": lambda: ecods.certify_distance(SURFACE, SURFACE.at(FAR)),
    "WorldCertificate": lambda: world(SURFACE).certify(),
    "BroadPhase": broad_phase,
    "ReplayDifference": lambda: ecods.Trace(trace().text.replace(" 0\n", " 7\n")).replay().difference,
    "ReplayReport": lambda: trace().replay(),
    "Trace": trace,
    "CollisionFilter": lambda: ecods.CollisionFilter(5, 6),
    "World": world,
    "CollisionManager": manager,
    "ContactData": lambda: manager().in_collision_internal(return_data=True)[1][0],
    "DistanceData": lambda: manager().min_distance_internal(3, return_data=True)[1],
}
PROVEN = {"Certificate", "WorldCertificate"}
CLASSES = {name: kind for name, kind in ((name, getattr(ecods, name)) for name in ecods.__all__)
           if inspect.isclass(kind)}
PLAIN = sorted(name for name, kind in CLASSES.items() if not issubclass(kind, (BaseException, enum.Enum)))


def facts(made):
    """What is compared of an object and its copy."""
    if isinstance(made, ecods.World):
        return [repr(made), *(f(body) for body in made.bodies() for f in (made.user_data, made.filter)), made.bodies().tolist()]
    if isinstance(made, ecods.CollisionManager):
        return [repr(made), made._bodies, made.in_collision_internal(True), made.min_distance_internal(3)]
    if isinstance(made, ecods.BroadPhase):
        made.update()
        return [repr(made), made.pairs().tolist(), made.box(1).tolist()]
    if isinstance(made, ecods.Mesh):
        return [type(made), made.digest]
    return [type(made), repr(made)]


def copies(made):
    return copy.copy(made), copy.deepcopy(made), *(pickle.loads(pickle.dumps(made, n)) for n in range(2, 6))


def test_every_class_has_an_object_here():
    assert PLAIN == sorted(MAKERS)


@pytest.mark.parametrize("name", PLAIN)
def test_text(name):
    made = MAKERS[name]()
    text = repr(made)
    assert type(made) is CLASSES[name]
    assert text.startswith((f"{name}(", f"<ecods.{name} ")) and " at 0x" not in text and len(text) < 1000, text
    assert CLASSES[name].__doc__


@pytest.mark.parametrize("name", sorted(set(PLAIN) - PROVEN))
def test_copies_and_pickles(name):
    made = MAKERS[name]()
    for again in copies(made):
        assert facts(again) == facts(made)
        if "__eq__" in vars(type(made)):
            assert again == made


@pytest.mark.parametrize("name", sorted(PROVEN))
def test_certificates_are_kept_as_text(name):
    made = MAKERS[name]()
    assert copy.copy(made) is made and copy.deepcopy([made])[0] is made
    with pytest.raises(TypeError, match=f"^{name} is not pickled: keep its text"):
        pickle.dumps(made)


@pytest.mark.parametrize("name", sorted(set(CLASSES) - set(PLAIN)))
def test_enums_and_errors(name):
    kind = CLASSES[name]
    assert kind.__doc__ and kind.__doc__ != enum.IntEnum.__doc__
    if issubclass(kind, enum.Enum):
        assert all(again is each for each in kind for again in copies(each))
        assert all(repr(each) == f"<{name}.{each.name}: {each.value}>" for each in kind)
    else:
        made = kind("some text")
        made.member = 5
        assert all((str(again), again.member, type(again)) == ("some text", 5, kind) for again in copies(made))


def test_reprs_say_what_there_is():
    expected = {
        "Posed": "Posed(<ecods.ConvexSolid of 8 vertices, 12 triangles>, "
                 "pose=[[1.0, 0.0, 0.0, 0.75], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]])",
        "Segment": "Segment(a=[0.0, 0.1, -0.0], b=[1e+300, 5e-324, 0.3333333333333333])",
        "Ray": "Ray(origin=[-1.0, 0.25, 0.25], direction=[1.0, 0.0, 0.0], max_parameter=inf)",
        "World": "<ecods.World of 2 bodies, sweep_and_prune, 2 threads>",
        "BroadPhase": "<ecods.BroadPhase of 2 boxes, brute_force>",
        "Trace": "<ecods.Trace of 13 lines>",
        "CollisionManager": "<ecods.CollisionManager of 3 meshes: 'a', 'b', 3>",
        "DistanceData": "DistanceData(",
    }
    for name, text in expected.items():
        assert repr(MAKERS[name]()).startswith(text), name
    assert "distance, value 2.0, " in repr(MAKERS["Certificate"]())
    assert "1 colliding, 0 close, 0 apart pairs" in repr(MAKERS["WorldCertificate"]())
    assert repr(ecods.World()) == "<ecods.World of 0 bodies, automatic, 1 thread>"


def test_copies_share_meshes():
    assert copy.copy(CUBE) is CUBE and copy.deepcopy(CUBE) is CUBE
    assert copy.deepcopy(NEAR).mesh is CUBE and copy.deepcopy([CUBE.moving(None, FAR)])[0].mesh is CUBE
    first = world()
    body, other = first.bodies()
    assert copy.deepcopy(first).mesh(body) is CUBE
    again = pickle.loads(pickle.dumps(first))
    assert again.mesh(body) is again.mesh(other) and type(again.mesh(body)) is ecods.ConvexSolid
    pair = pickle.loads(pickle.dumps((NEAR, CUBE)))
    assert pair[0].mesh is pair[1]


def test_a_copied_world_has_the_same_ids():
    first = ecods.World()
    bodies = [first.create_body(CUBE, ecods.pose(t=(0.75 * i, 0, 0)), groups=3, mask=5 + i, user_data=2**64 - 1 - i)
              for i in range(6)]
    for body in (bodies[4], bodies[1]):
        first.destroy_body(body)
    last = first.create_body(MESH, FAR)  # where bodies[1] was
    first.set_pair_enabled(bodies[3], bodies[2], False)
    first.set_clearance(0.25)
    first.set_relations(True)
    first.update()
    first.set_pose(bodies[0], FAR)
    for second in copies(first):
        assert second.bodies().tolist() == first.bodies().tolist()
        for body in first.bodies():
            assert np.array_equal(second.pose(body), first.pose(body)) and second.filter(body) == first.filter(body)
            assert second.user_data(body) == first.user_data(body) and second.mesh(body).digest == first.mesh(body).digest
        assert not second.is_pair_enabled(bodies[2], bodies[3]) and second.is_pair_enabled(bodies[0], bodies[2])
        assert second.clearance() == 0.25 and second.are_relations_listed()
        # The copy is as before its first update.
        assert len(second.colliding_pairs()) == 0
        second.update()
        second.check_invariants()
        third = copy.copy(first)
        third.update()
        assert second.began().tolist() == second.colliding_pairs().tolist() == third.colliding_pairs().tolist()
        assert second.digest() == third.digest()
        # Stale ids are stale, new ones are those that the first world gives; and what one does the other does not.
        for stale in (bodies[1], bodies[4]):
            with pytest.raises(ecods.StaleBody):
                second.pose(stale)
        new = [second.create_body(CUBE), second.create_body(CUBE)]
        assert second.is_alive(last) and not set(new) & set(bodies) and len(first) == 5
        assert new == [third.create_body(CUBE), third.create_body(CUBE)]
    assert not first.is_alive(new[0])


def test_a_world_is_copied_while_a_trace_goes_on():
    first = ecods.World()
    first.start_trace()
    body = first.create_body(CUBE)
    second = copy.deepcopy(first)
    assert second.end_trace() is None and second.is_alive(body)
    second.start_trace()
    second.update()
    first.update()
    assert first.end_trace().replay().difference is None and second.end_trace().replay().difference is None


@pytest.mark.parametrize("change", [lambda s: s[:-1], lambda s: (99, *s[1:]), lambda s: (*s[:6], s[6] + 9, *s[7:]),
                                    lambda s: (*s[:9], s[9][:1], *s[10:])])
def test_a_state_of_another_version_is_refused(change):
    made = ecods.World.__new__(ecods.World)
    with pytest.raises(ValueError, match="^World: the state of another version of ecods$"):
        made.__setstate__(change(world().__getstate__()))
