"""Exact answers about many moving triangle meshes: which touch, how far, what is hit first, when, how deep.

Arguments and results are arrays: points (n, 3), poses (4, 4) or (3, 4), many poses (k, 4, 4), boxes (2, 3); bodies are
ints. Lengths are in the unit of the caller's coordinates. Nothing is rounded on the way to an answer, and a number in
an answer is the true number, rounded once.
"""
from . import _ecods
from ._ecods import *  # noqa: F401,F403
from ._ecods import __version__
from .collision_manager import CollisionManager, ContactData, DistanceData

__all__ = [name for name in vars(_ecods) if not name.startswith("_")]
__all__ += ["CollisionManager", "ContactData", "DistanceData", "__version__"]
