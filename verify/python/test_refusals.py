"""What is said of arguments that no signature takes: one line, with the argument, what it was, and what is accepted."""
import inspect

import numpy as np
import pytest

import ecods
from scenes import TETRAHEDRON, Trimesh, box

V, F = map(np.array, box())
MESH = ecods.Mesh(*TETRAHEDRON)
MAKE = "make an ecods.Mesh of it, ecods.Mesh(vertices, faces)"

REFUSED = [
    (lambda: ecods.distance(V, MESH),
     f"distance: argument 1 (a) is a numpy array of shape (8, 3); a Mesh or Posed or a Rounded or a HalfSpace is expected: {MAKE}, and place it with "
     ".at(pose)"),
    (lambda: ecods.distance(MESH, (V, F)),
     f"distance: argument 2 (b) is a tuple of 2; a Mesh or Posed or a Rounded or a HalfSpace is expected: {MAKE}, and place it with .at(pose)"),
    (lambda: ecods.distance(MESH, b=Trimesh(V, F)),
     "distance: argument 2 (b) is a Trimesh; a Mesh or Posed or a Rounded or a HalfSpace is expected: make one, ecods.Mesh(mesh.vertices, "
     "mesh.faces), and place it with .at(pose)"),
    (lambda: ecods.distance(MESH), "distance: argument 2 (b) is missing; the arguments are a, b, witness"),
    (lambda: ecods.distance(MESH, MESH, tolerance=1),
     "distance: there is no argument 'tolerance'; the arguments are a, b, witness"),
    (lambda: ecods.distance(MESH, MESH, None, 1), "distance: 4 arguments are given; the arguments are a, b, witness"),
    (lambda: ecods.distance(MESH, MESH, a=MESH), "distance: argument 1 (a) is given twice"),
    (lambda: ecods.within(MESH, MESH, "near"), "within: argument 3 (max_distance) is 'near'; a number is expected"),
    (lambda: ecods.check_solid(V), f"check_solid: argument 1 (mesh) is a numpy array of shape (8, 3); a Mesh is expected: {MAKE}"),
    (lambda: ecods.Mesh(V), "Mesh: argument 2 (faces) is missing; the arguments are vertices, faces"),
    (lambda: ecods.ConvexSolid.hull(V, F), "hull: 2 arguments are given; the arguments are points"),
    (lambda: ecods.World("sweep"),
     "World: argument 1 (broad_phase) is 'sweep'; one of brute_force, sweep_and_prune, kept_candidates, automatic is "
     "expected"),
    (lambda: ecods.World(threads="2"), "World: argument 2 (threads) is '2'; a whole number is expected"),
    (lambda: ecods.World(threads=-1), "World: argument 2 (threads) is -1, which is out of range"),
    (lambda: ecods.World().create_body(V, F),
     f"World.create_body: argument 1 (mesh) is a numpy array of shape (8, 3); a Mesh or a Rounded or a HalfSpace is expected: {MAKE}"),
    (lambda: ecods.World().create_body(MESH, None, 3),
     "World.create_body: 3 arguments are given; the arguments are mesh, pose, groups, mask, user_data"),
    (lambda: ecods.World().create_body(MESH, groups=-1),
     "World.create_body: argument 3 (groups) is -1, which is out of range"),
    (lambda: ecods.World().nearest("a"), "World.nearest: argument 1 (what) is 'a'; a whole number or a Mesh or Posed or a Rounded or a HalfSpace is expected"),
    (lambda: ecods.World().relation(V, 1),
     f"World.relation: argument 1 (a) is a numpy array of shape (8, 3); a whole number or a Mesh or Posed or a Rounded or a HalfSpace is expected: {MAKE}, "
     "and place it with .at(pose)"),
    (lambda: ecods.World().pose(1.0), "World.pose: argument 1 (body) is 1.0; a whole number is expected"),
    (lambda: ecods.World().pose(V),
     "World.pose: argument 1 (body) is a numpy array of shape (8, 3); a whole number is expected"),
    (lambda: ecods.World().first_hit(V), "World.first_hit: argument 1 (line) is a numpy array of shape (8, 3); a Segment or a Ray is expected"),
    (lambda: ecods.BroadPhase().add(-1, [[0] * 3] * 2), "BroadPhase.add: argument 1 (proxy) is -1, which is out of range"),
    (lambda: ecods.cast(MESH, [1, 0, 0], None), "cast: argument 3 (b) is None; a Mesh or Posed or a Rounded or a HalfSpace is expected"),
    (lambda: ecods.CollisionManager().add_object("a", "b"),
     "mesh: 'b' is no mesh; an ecods.Mesh, an object with `vertices` and `faces`, or the two in a tuple is expected"),
    (lambda: ecods.CollisionManager().add_object("a", V),
     "mesh: a numpy array of shape (8, 3) is no mesh; an ecods.Mesh, an object with `vertices` and `faces`, or the two in "
     "a tuple is expected"),
]


@pytest.mark.parametrize("call, text", REFUSED)
def test_one_line_says_what_is_wrong(call, text):
    with pytest.raises(TypeError) as caught:
        call()
    assert str(caught.value) == text


def test_long_values_are_not_written():
    for value in ("x" * 5000, [V] * 1000, {i: i for i in range(99)}, 10**5000, ecods, np.zeros((7, 7))):
        with pytest.raises(TypeError) as caught:
            ecods.distance(value, MESH)
        assert len(str(caught.value)) < 250 and "\n" not in str(caught.value), str(caught.value)


def test_what_is_taken_is_named():
    ground = ecods.HalfSpace([0, 0, 1], 0)
    for call, text in ((lambda: ecods.rounded(5, 1), "a Mesh or a Rounded or a HalfSpace is expected"),
                       (lambda: ecods.relation(ground, MESH), "a HalfSpace is expected: of two bodies, the half space comes second"),
                       (lambda: ecods.distance(ground, ecods.sphere(1)), "the half space comes second")):
        with pytest.raises(TypeError, match=text):
            call()


class Strange:
    """Of which nothing is taken."""


def calls():
    """Every function, method and constructor of the module, with the object that it is called on."""
    for name in ecods.__all__:
        thing = getattr(ecods, name)
        has_signature = not inspect.isclass(thing) or (thing.__init__.__doc__ or "").startswith("__init__(")
        if callable(thing) and has_signature:
            yield name, thing
    for kind, made in ((ecods.World, ecods.World()), (ecods.Mesh, MESH), (ecods.BroadPhase, ecods.BroadPhase())):
        for name in vars(kind):
            if not name.startswith("_") and callable(getattr(made, name)):
                yield name, getattr(made, name)


@pytest.mark.parametrize("name, call", list(calls()))
def test_every_call_refuses_strange_arguments_in_one_line(name, call):
    for count in (1, 2, 9):
        with pytest.raises((TypeError, ValueError)) as caught:
            call(*[Strange()] * count)
        assert "\n" not in str(caught.value) and "Invoked with" not in str(caught.value)
        assert "_ecods" not in str(caught.value) and " at 0x" not in str(caught.value)
