"""The part of the work that is this process's own, the cores that it may use, and a line of progress."""
import concurrent.futures
import os
import pathlib
import platform
import sys
import time

from .lists import Broken


def add_options(parser):
    parser.add_argument("--jobs", type=int, help="processes at a time; all cores, if not given")
    parser.add_argument("--minutes", type=float, default=float("inf"), help="begin no mutant after that")
    parser.add_argument("--shard", metavar="K/N", help="the K-th of N parts; rows go to a file of their own")


class Share:
    """Every n-th mutant, from the r-th: of rank r of n under mpirun, or of part r + 1 of n."""

    def __init__(self, rank=0, ranks=1, communicator=None, is_shard=False):
        self.rank, self.ranks, self.communicator, self.is_shard = rank, ranks, communicator, is_shard

    def of(self, items):
        return items[self.rank::self.ranks]

    def suffix(self):
        """Makes names of files that are this process's own."""
        return f"-{self.rank + 1}-of-{self.ranks}" if self.ranks > 1 else ""

    def same(self, rows):
        """The rows that any rank has, by the names of their mutants: the same on all, whose folders may be different."""
        if self.communicator is None:
            return [rows]
        return self.communicator.allgather(rows)

    def gather(self, rows):
        """All rows on the rank that writes, None on the others. A part has only its own."""
        if self.communicator is None:
            return rows
        gathered = self.communicator.gather(rows, root=0)
        return None if gathered is None else [row for part in gathered for row in part]


def is_under_mpirun():
    return any(name in os.environ for name in ("OMPI_COMM_WORLD_SIZE", "PMI_SIZE"))


def of_options(options):
    if options.shard:
        part, _, parts = options.shard.partition("/")
        if not part.isdecimal() or not parts.isdecimal() or not 1 <= int(part) <= int(parts):
            raise Broken(f"--shard {options.shard}: K/N with 1 <= K <= N is expected")
        return Share(int(part) - 1, int(parts), is_shard=True)
    if not is_under_mpirun():
        return Share()
    try:
        from mpi4py import MPI
    except ImportError as error:
        raise Broken("mpirun needs mpi4py (Debian: python3-mpi4py); --shard K/N does without") from error
    return Share(MPI.COMM_WORLD.Get_rank(), MPI.COMM_WORLD.Get_size(), MPI.COMM_WORLD)


def jobs_of(options):
    ranks_here = int(os.environ.get("OMPI_COMM_WORLD_LOCAL_SIZE", 1))
    return options.jobs or max(1, len(os.sched_getaffinity(0)) // ranks_here)


def work_folder(build, share, number):
    """A folder that no other mutant uses at the same time, on any rank or machine."""
    return pathlib.Path(build) / f"mutants/work-{platform.node()}{share.suffix()}-{number}"


def stop_at(options):
    return time.time() + 60 * options.minutes


def in_parallel(items, jobs, function, until=float("inf")):
    """Calls function(item, number) for each item, begun at the time `until` at the latest; of the numbers, below `jobs`, no two
    calls have one at the same time. The first error ends it, once the calls that run have returned."""
    free = list(range(jobs))

    def call(item):
        if time.time() > until:
            return
        number = free.pop()
        try:
            function(item, number)
        finally:
            free.append(number)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        running = [pool.submit(call, item) for item in items]
        try:
            for each in concurrent.futures.as_completed(running):
                each.result()
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


class Progress:
    """One line on a terminal that is overwritten; nothing elsewhere."""

    def __init__(self, total, stream=sys.stderr):
        self.total, self.done, self.stream = total, 0, stream

    def show(self, what):
        if self.stream.isatty():
            print(f"\r\x1b[K{self.done} of {self.total} done, now {what}", end="", file=self.stream, flush=True)

    def end(self, line):
        """One more is done: its line takes the place of the progress."""
        self.done += 1
        if self.stream.isatty():
            print("\r\x1b[K", end="", file=self.stream, flush=True)
        print(line, flush=True)


def abort(status):
    """Ends this process, and under mpirun all ranks, which would wait for its rows."""
    if is_under_mpirun() and "mpi4py" in sys.modules:
        from mpi4py import MPI
        MPI.COMM_WORLD.Abort(status)
    sys.exit(status)
