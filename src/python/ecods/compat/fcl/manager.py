"""The broad phase: many objects, of which only pairs that may matter reach a callback."""
import heapq
import math
import sys
from typing import Any, Callable, Dict, Iterable, Iterator, List, Tuple

import numpy as np

from ... import _ecods
from ...refusals import describe, is_number
from .bodies import sides_of
from .geometry import box_of
from .transform import CollisionObject

Callback = Callable[[CollisionObject, CollisionObject, Any], Any]
Bounds = Iterator[Tuple[float, CollisionObject]]


def _box(thing: CollisionObject) -> np.ndarray:
    sides = sides_of(thing)
    return box_of(sides if len(sides) > 1 else sides[0], thing._pose)


def _answer(pair: Any) -> Tuple[bool, float]:
    """Returns the result of a callback of distance(), with FCL's greatest number replaced by infinity."""
    is_pair = isinstance(pair, tuple) and len(pair) == 2 and is_number(pair[1])
    if not is_pair or math.isnan(pair[1]):
        raise TypeError(f"DynamicAABBTreeCollisionManager.distance: the callback returned {describe(pair)}; a pair of a bool "
                        "and a distance is expected")
    return bool(pair[0]), math.inf if pair[1] >= sys.float_info.max else float(pair[1])


class DynamicAABBTreeCollisionManager:
    """Objects whose boxes are kept in a broad phase. Moves count at once, also without a call of update() or setup().

    collide() and distance() take (data, callback), for all pairs of this manager's objects; (object, data, callback), for
    the pairs with an object, other than itself; or (manager, data, callback), for the pairs with another manager's objects.
    The callback gets two objects, this manager's first, and the data. It must add and remove no objects. Its exceptions are
    passed on.
    """

    def __init__(self) -> None:
        self._objects: Dict[int, CollisionObject] = {}
        self._proxies: Dict[int, int] = {}
        self._versions: Dict[int, int] = {}
        self._free: List[int] = []
        self._boxes = np.empty((0, 2, 3))
        self._broad_phase = _ecods.BroadPhase()
        # Settings of FCL's tree, with its values. Nothing depends on them.
        self.max_tree_nonbalanced_level = 10
        self.tree_incremental_balance_pass = 10
        self.tree_topdown_balance_threshold = 2
        self.tree_topdown_level = 0
        self.tree_init_level = 0
        self.octree_as_geometry_collide = True
        self.octree_as_geometry_distance = False

    def __repr__(self) -> str:
        return f"<DynamicAABBTreeCollisionManager of {self.size()} objects>"

    def registerObjects(self, other_objs: Iterable[CollisionObject]) -> None:
        """Adds objects; an object that was added before stays. Raises TypeError, or ValueError for a model that has not
        ended; then no object is added.
        """
        objects = list(other_objs)
        for thing in objects:
            self._check_object("registerObjects", thing)
            _box(thing)
        for thing in objects:
            self._register(thing)

    def registerObject(self, obj: CollisionObject) -> None:
        """Adds an object; an object that was added before stays. Raises TypeError."""
        self._check_object("registerObject", obj)
        self._register(obj)

    def unregisterObject(self, obj: CollisionObject) -> None:
        """Removes an object, if it was added."""
        proxy = self._proxies.pop(id(obj), None)
        if proxy is None:
            return
        del self._objects[proxy], self._versions[proxy]
        self._broad_phase.remove(proxy)
        heapq.heappush(self._free, proxy)

    def setup(self) -> None:
        """Brings the boxes up to date; every question does so, too."""
        self._synchronize()

    def update(self, arg: Any = None) -> None:
        """Brings the boxes up to date; every question does so, too. Raises TypeError if arg has no objects."""
        for thing in [] if arg is None else arg if hasattr(arg, "__len__") else [arg]:
            self._check_object("update", thing)
        self._synchronize()

    def getObjects(self) -> List[CollisionObject]:
        """Returns a list of the objects, in the order in which they were added."""
        return [self._objects[proxy] for proxy in self._proxies.values()]

    def clear(self) -> None:
        """Removes all objects."""
        for thing in self.getObjects():
            self.unregisterObject(thing)

    def empty(self) -> bool:
        """Returns True if there are no objects."""
        return not self._objects

    def size(self) -> int:
        """Returns the number of objects."""
        return len(self._objects)

    def collide(self, *args: Any) -> None:
        """Calls callback(o1, o2, data) for the pairs whose boxes share a point, until it returns True. See the class."""
        other, data, callback = self._arguments("collide", args)
        for o1, o2 in self._overlapping(other):
            if callback(o1, o2, data):
                return

    def distance(self, *args: Any) -> None:
        """Calls callback(o1, o2, data), which returns a pair: True to stop, and a distance.

        Leaves out pairs whose boxes are at least this distance apart. Near boxes come first for each object. See the class.
        """
        other, data, callback = self._arguments("distance", args)
        limit = math.inf
        for o1, candidates in self._near(other):
            for lower, o2 in candidates(limit):
                if lower >= limit:
                    break
                first, second = (o1, o2) if other is None or isinstance(other, type(self)) else (o2, o1)
                is_done, limit = _answer(callback(first, second, data))
                if is_done:
                    return

    @staticmethod
    def _check_object(call: str, thing: Any) -> None:
        if not isinstance(thing, CollisionObject):
            raise TypeError(f"DynamicAABBTreeCollisionManager.{call}: {describe(thing)} is given; a CollisionObject is "
                            "expected")

    def _arguments(self, call: str, args: Tuple[Any, ...]) -> Tuple[Any, Any, Callback]:
        """Returns (other, data, callback); `other` is None for the pairs of this manager's own objects."""
        other = args[0] if len(args) == 3 else None
        is_other = isinstance(other, (CollisionObject, DynamicAABBTreeCollisionManager))
        if len(args) not in (2, 3) or len(args) == 3 and not is_other or not callable(args[-1]):
            given = ", ".join(map(describe, args)) or "nothing"
            raise ValueError(f"DynamicAABBTreeCollisionManager.{call}: {given} is given; (data, callback), (object, data, "
                             "callback) or (manager, data, callback) is expected")
        return None if other is self else other, args[-2], args[-1]

    def _register(self, thing: CollisionObject) -> None:
        if id(thing) in self._proxies:
            return
        box = _box(thing)
        proxy = self._free[0] if self._free else len(self._objects)
        if proxy == len(self._boxes):
            self._boxes = np.concatenate([self._boxes, np.empty((max(16, proxy), 2, 3))])
        self._boxes[proxy] = box
        self._broad_phase.add(proxy, box)
        if self._free:
            heapq.heappop(self._free)
        self._objects[proxy], self._proxies[id(thing)], self._versions[proxy] = thing, proxy, thing._version

    def _synchronize(self) -> None:
        """Updates the broad phase with the boxes of objects that have changed."""
        for proxy, thing in self._objects.items():
            if thing._version != self._versions[proxy]:
                self._boxes[proxy] = _box(thing)
                self._broad_phase.move(proxy, self._boxes[proxy])
                self._versions[proxy] = thing._version

    def _find(self, box: np.ndarray) -> List[int]:
        return sorted(self._broad_phase.find(box).tolist())

    def _overlapping(self, other: Any) -> List[Tuple[CollisionObject, CollisionObject]]:
        self._synchronize()
        if other is None:
            self._broad_phase.update()
            return [(self._objects[i], self._objects[j]) for i, j in self._broad_phase.pairs().tolist()]
        if isinstance(other, CollisionObject):
            return [(self._objects[i], other) for i in self._find(_box(other)) if self._objects[i] is not other]
        other._synchronize()
        return [(self._objects[i], other._objects[j]) for i in sorted(self._objects)
                for j in other._find(self._boxes[i]) if self._objects[i] is not other._objects[j]]

    def _near(self, other: Any) -> Iterator[Tuple[CollisionObject, Callable[[float], Bounds]]]:
        """Yields objects, each with a function that lists the others nearer than a limit: lower bounds, ascending."""
        self._synchronize()
        if isinstance(other, CollisionObject):
            yield other, lambda limit: self._nearer(_box(other), limit, other)
            return
        if other is not None:
            other._synchronize()
        for i, thing in sorted(self._objects.items()):
            box = self._boxes[i].copy()
            if other is None:
                yield thing, lambda limit: self._nearer(box, limit, thing, after=i)
            else:
                yield thing, lambda limit: other._nearer(box, limit, thing)

    def _nearer(self, box: np.ndarray, limit: float, thing: CollisionObject, after: int = -1) -> Bounds:
        """Returns lower bounds of distances from a box, ascending, with their objects: all that are less than the limit."""
        if limit <= 0:
            return iter(())
        # Rounding is monotonic: if a rounded distance is less than the limit, so is the real gap, and its
        # box reaches into the grown one.
        with np.errstate(over="ignore"):
            grown = np.array([box[0] - limit, box[1] + limit])
            proxies = np.array(sorted(self._objects) if math.isinf(limit) else self._find(grown), dtype=np.int64)
            proxies = proxies[proxies > after]
            gaps = np.maximum(self._boxes[proxies, 0] - box[1], box[0] - self._boxes[proxies, 1]).max(axis=1, initial=0.0)
        order = np.argsort(gaps, kind="stable")
        near = ((float(gaps[k]), self._objects[int(proxies[k])]) for k in order)
        return ((bound, found) for bound, found in near if found is not thing)
