"""How work is divided."""
import argparse
import contextlib
import io
import os
import threading
import time
import unittest
from unittest import mock

from mutation import share
from mutation.lists import Broken


class Communicator:
    """A rank among ranks that have these rows, as mpi4py's."""

    def __init__(self, rank, parts):
        self.rank, self.parts = rank, parts

    def gather(self, _, root):
        return self.parts if self.rank == root else None

    def allgather(self, _):
        return self.parts


def options(**values):
    return argparse.Namespace(**{"shard": None, "jobs": None} | values)


class Shares(unittest.TestCase):
    def test_parts_have_every_mutant_once(self):
        items = list(range(10))
        parts = [share.of_options(options(shard=f"{k}/3")).of(items) for k in (1, 2, 3)]
        self.assertEqual(sorted(sum(parts, [])), items)
        self.assertEqual(parts[1], [1, 4, 7])
        self.assertEqual(share.of_options(options()).of(items), items)
        self.assertEqual(share.of_options(options(shard="2/3")).suffix(), "-2-of-3")

    def test_parts_that_are_none_are_refused(self):
        for wrong in ("0/3", "4/3", "1", "a/b", "1/"):
            with self.assertRaises(Broken):
                share.of_options(options(shard=wrong))

    def test_rank_0_has_the_rows_of_all(self):
        ranks = [share.Share(rank, 2, Communicator(rank, [["a"], ["b", "c"]])) for rank in (0, 1)]
        self.assertEqual(ranks[0].gather(["a"]), ["a", "b", "c"])
        self.assertIsNone(ranks[1].gather(["b", "c"]))
        self.assertEqual(share.Share().gather(["a"]), ["a"])
        self.assertEqual(ranks[1].same({}), ranks[0].same({}))

    def test_mpirun_without_mpi4py_is_refused(self):
        with mock.patch.dict(os.environ, OMPI_COMM_WORLD_SIZE="2"), mock.patch.dict("sys.modules", {"mpi4py": None}):
            with self.assertRaisesRegex(Broken, "python3-mpi4py"):
                share.of_options(options())
            self.assertEqual(share.of_options(options(shard="1/2")).ranks, 2)

    def test_ranks_of_one_machine_share_its_cores(self):
        cores = len(os.sched_getaffinity(0))
        self.assertEqual(share.jobs_of(options()), cores)
        self.assertEqual(share.jobs_of(options(jobs=3)), 3)
        with mock.patch.dict(os.environ, OMPI_COMM_WORLD_LOCAL_SIZE=str(2 * cores)):
            self.assertEqual(share.jobs_of(options()), 1)


class Parallel(unittest.TestCase):
    def test_no_two_calls_have_one_number(self):
        busy, done, lock = set(), [], threading.Lock()

        def call(item, number):
            with lock:
                self.assertNotIn(number, busy)
                busy.add(number)
            time.sleep(0.001)
            with lock:
                busy.remove(number)
                done.append(item)

        share.in_parallel(range(40), 4, call)
        self.assertEqual(sorted(done), list(range(40)))

    def test_an_error_ends_it(self):
        done = []

        def call(item, _):
            if item == 3:
                raise Broken("three")
            done.append(item)

        with self.assertRaisesRegex(Broken, "three"):
            share.in_parallel(range(1000), 1, call)
        self.assertLess(len(done), 1000)

    def test_nothing_begins_after_the_end(self):
        done = []
        share.in_parallel(range(3), 1, lambda item, _: done.append(item), time.time() - 1)
        self.assertEqual(done, [])
        share.in_parallel(range(3), 1, lambda item, _: done.append(item), share.stop_at(options(minutes=1)))
        self.assertEqual(done, [0, 1, 2])

    def test_progress_is_shown_on_a_terminal_alone(self):
        for is_terminal in (False, True):
            stream, out = io.StringIO(), io.StringIO()
            stream.isatty = lambda: is_terminal
            progress = share.Progress(2, stream)
            with contextlib.redirect_stdout(out):
                progress.show("some_mutant")
                progress.end("some_mutant: caught")
            self.assertEqual("0 of 2 done, now some_mutant" in stream.getvalue(), is_terminal)
            self.assertEqual(out.getvalue(), "some_mutant: caught\n")
