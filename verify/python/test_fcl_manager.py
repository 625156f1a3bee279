"""The manager of ecods.compat.fcl: pairs that reach callbacks, in all forms of its calls."""
import itertools
import math

import numpy as np
import pytest

import ecods.compat.fcl as fcl
from fcl_shapes import GEOMETRIES, GROUNDS, cube_mesh, thing


def managed(*objects):
    made = fcl.DynamicAABBTreeCollisionManager()
    made.registerObjects(objects)
    made.setup()
    return made


def seen(manager, *other):
    """Returns the pairs that reach a callback of collide()."""
    pairs = []
    manager.collide(*other, "data", lambda a, b, data: pairs.append((a, b)) and data != "data")
    return pairs


def least(manager, *other):
    """Returns the least distance, and the number of pairs that were measured."""
    data, count = fcl.DistanceData(fcl.DistanceRequest(True, True)), itertools.count()

    def callback(a, b, given):
        next(count)
        return fcl.defaultDistanceCallback(a, b, given)

    manager.distance(*other, data, callback)
    return data.result.min_distance, next(count)


def row(count, x=0.0):
    return [thing(GEOMETRIES["box"], x=x + 3 * i) for i in range(count)]


def test_forms_of_collide():
    a, b, c = thing(GEOMETRIES["box"]), thing(GEOMETRIES["sphere"], x=0.75), thing(GEOMETRIES["mesh"], x=9)
    manager, other = managed(a, b, c), managed(d := thing(GEOMETRIES["box"], x=9.5), e := thing(GEOMETRIES["cone"], x=-0.75))
    assert seen(manager) == [(a, b)] == seen(manager, manager)
    assert seen(manager, d) == [(c, d)] and seen(manager, a) == [(b, a)] and seen(other, a) == [(e, a)]
    assert seen(manager, other) == [(a, e), (c, d)] and seen(other, manager) == [(d, c), (e, a)]
    ground = thing(GROUNDS["half space"], z=-5)
    assert seen(managed(ground, a, c)) == []
    floor = thing(GROUNDS["plane"])
    assert seen(managed(a, c), floor) == [(a, floor), (c, floor)] and seen(managed(a, c), thing(GROUNDS["plane"], z=1)) == []
    ground.setQuatRotation([1, 1, 0, 0])
    assert (ground, a) in seen(managed(ground, a, c))


def test_a_true_callback_ends_the_search():
    manager, calls = managed(*(thing(GEOMETRIES["box"], x=0.5 * i) for i in range(5))), []
    manager.collide(calls, lambda a, b, data: data.append(a) or len(data) == 2)
    assert len(calls) == 2
    manager.distance(calls, lambda a, b, data: (data.append(a) is None and len(data) == 5, math.inf))
    assert len(calls) == 5


def test_default_callbacks():
    manager = managed(*(thing(GEOMETRIES["box"], x=0.5 * i) for i in range(5)))
    data = fcl.CollisionData()
    manager.collide(data, fcl.defaultCollisionCallback)
    assert data.result.is_collision and data.done and len(data.result.contacts) == 2
    everything = fcl.CollisionData(fcl.CollisionRequest(num_max_contacts=100))
    manager.collide(everything, fcl.defaultCollisionCallback)
    assert not everything.done and len(everything.result.contacts) == 4 + 3
    names = {id(each._geometry): i for i, each in enumerate(manager.getObjects())}
    assert all(id(each.o1) in names and id(each.o2) in names for each in everything.result.contacts)
    done = fcl.DistanceData()
    done.done = True
    manager.distance(done, fcl.defaultDistanceCallback)
    assert done.result.min_distance > 1e308
    assert fcl.defaultDistanceCallback(*manager.getObjects()[:2], fcl.DistanceData()) == (True, -1)
    assert fcl.defaultDistanceCallback(*manager.getObjects()[::4], fcl.DistanceData()) == (False, 1)


def test_changes_count_at_once():
    geometry = fcl.Box(1, 1, 1)
    a, b = thing(geometry), thing(GEOMETRIES["box"], x=5)
    manager = managed(a, b)
    assert seen(manager) == [] and least(manager)[0] == 4
    b.setTranslation([0.75, 0, 0])
    assert seen(manager) == [(a, b)] and least(manager)[0] == -0.25
    b.setTranslation([5, 0, 0])
    manager.update(b)
    assert seen(manager, thing(GEOMETRIES["box"], x=0.75)) and seen(manager) == []
    geometry.side = (9, 1, 1)
    assert seen(manager) == [(a, b)]
    manager.update([a, b])
    manager.update()
    model = cube_mesh()
    c = thing(model, x=20)
    manager.registerObject(c)
    assert least(manager, thing(GEOMETRIES["box"], x=22))[0] == 1
    model.beginModel()
    model.addTriangle([1, 0, 0], [1, 1, 0], [1, 0, 1])
    with pytest.raises(ValueError, match="endModel"):
        seen(manager)
    model.endModel()
    assert least(manager, thing(GEOMETRIES["box"], x=22))[0] == 0.5


def test_registering():
    a, b, c = row(3)
    manager = managed(a, b, a)
    assert manager.getObjects() == [a, b] and manager.size() == 2 and not manager.empty()
    manager.registerObject(c)
    manager.unregisterObject(a)
    manager.unregisterObject(a)
    assert manager.getObjects() == [b, c] and "of 2 objects" in repr(manager)
    manager.registerObject(a)
    assert manager.getObjects() == [b, c, a]
    manager.registerObjects(row(40, x=20))
    assert manager.size() == 43 and least(manager, thing(GEOMETRIES["box"], x=-5))[0] == 4
    manager.clear()
    assert manager.empty() and manager.getObjects() == [] and seen(manager) == [] == seen(manager, a)
    assert least(manager) == (fcl.DistanceResult().min_distance, 0)
    manager.max_tree_nonbalanced_level = 5
    with pytest.raises(TypeError, match="is given; a CollisionObject is expected"):
        manager.registerObjects([a, GEOMETRIES["box"]])
    assert manager.empty()
    for call in (lambda: manager.registerObject(None), lambda: manager.update(5)):
        with pytest.raises(TypeError):
            call()


def test_distances_of_many():
    random = np.random.default_rng(5)
    objects = [thing(GEOMETRIES[kind], *random.uniform(-30, 30, 3)) for kind in ("box", "sphere", "mesh", "cone") * 10]
    brute = min(fcl.distance(a, b, fcl.DistanceRequest(False, True)) for a, b in itertools.combinations(objects, 2))
    distance, count = least(managed(*objects))
    assert distance == brute and count < 200
    first, second = objects[:20], objects[20:]
    brute = min(fcl.distance(a, b, fcl.DistanceRequest(False, True)) for a in first for b in second)
    one, other = managed(*first), managed(*second)
    assert least(one, other)[0] == least(other, one)[0] == brute
    query = thing(GEOMETRIES["capsule"], *random.uniform(-30, 30, 3))
    distance, count = least(one, query)
    assert distance == min(fcl.distance(a, query, fcl.DistanceRequest(False, True)) for a in first) and count < 10
    ground = thing(GROUNDS["half space"], z=-40)
    assert least(managed(ground, *first))[0] <= least(managed(*first))[0]
    assert least(managed(*first), ground)[0] == min(fcl.distance(each, ground) for each in first)
    assert least(managed(query), query)[1] == 0
    calls = []
    one.distance(calls, lambda a, b, data: (data.append(a), (False, -1.0))[1])
    assert len(calls) == 1
    one.distance(calls, lambda a, b, data: (data.append(a), (False, math.inf))[1])
    assert len(calls) == 1 + 190


def test_order_of_objects_in_callbacks_of_distance():
    a, b = thing(GEOMETRIES["box"]), thing(GEOMETRIES["box"], x=3)
    pairs = []

    def callback(first, second, data):
        pairs.append((first, second))
        return False, math.inf

    manager = managed(a)
    manager.distance(b, None, callback)
    manager.distance(managed(b), None, callback)
    managed(b, a).distance(None, callback)
    assert pairs == [(a, b), (a, b), (b, a)]


def test_bad_calls():
    manager, cube = managed(*row(2)), thing(GEOMETRIES["box"])
    for args in ((), (fcl.CollisionData(),), (cube, fcl.CollisionData()), (cube, None, None), (5, None, print),
                 (cube, cube, None, print)):
        for call in (manager.collide, manager.distance):
            with pytest.raises(ValueError, match=r"\(object, data, callback\) or \(manager, data, callback\)"):
                call(*args)

    def broken(a, b, data):
        raise KeyError("mine")

    for call in (manager.collide, manager.distance):
        with pytest.raises(KeyError, match="mine"):
            call(cube, None, broken)
    for answer in (None, 5, (False, None), (False, math.nan)):
        with pytest.raises((TypeError, ValueError), match="callback returned .*; a pair"):
            manager.distance(None, lambda a, b, data: answer)
