"""Threads of Python on one world, and the lock that they share."""
import threading

import numpy as np
import pytest

import ecods
from scenes import at, box, turned


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
    world.check_invariants()
    alone = ecods.World()
    for body in bodies:
        alone.create_body(cube, world.pose(body))
    alone.update()
    assert not failures and alone.digest() == world.digest()


def test_questions_of_many_threads_are_all_traced():
    world = ecods.World(threads=2)
    cube = ecods.ConvexSolid(*box())
    world.start_trace(questions=True)
    for i in range(20):
        world.create_body(cube, at(0.9 * i))

    def ask():
        for body in world.bodies():
            world.nearest(body)
            world.cast(body, [0, 1, 0])
        world.closest_pair()
        world.depths()
        world.signed_distances(0.5)

    workers = [threading.Thread(target=ask) for _ in range(4)]
    for each in workers:
        each.start()
    for each in workers:
        each.join()
    report = world.end_trace().replay()
    assert report.difference is None and report.question_count == 4 * 43


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
