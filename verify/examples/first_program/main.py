"""A block above, on and in a slab: each question about two bodies once."""
import itertools

import ecods


def number(x):
    return repr(x + 0.0).removesuffix(".0")


def text(v):
    return "(" + ", ".join(number(x) for x in v) + ")"


# A solid is the shape of a closed mesh; a convex one is the hull of points, here of the corners of a box.
def box(least, greatest):
    return ecods.ConvexSolid.hull(list(itertools.product(*zip(least, greatest))))


block = box((0, 0, 0), (1, 1, 1))
slab = box((-2, -2, -1), (3, 3, 0))
for height in (0.1, 0, -0.3):
    # A body is a shape at a pose: the real points R v + t.
    a, b = block.at(ecods.pose(t=(0, 0, height))), slab
    print(f"The block is at {number(height)}.")
    print(f"  {ecods.relation(a, b)}, distance {number(ecods.distance(a, b))}")
    points = ecods.closest(a, b)
    kind = str(points.kind).replace("_", " and ")
    print(f"  closest: {kind}, {text(points.point_a)} and {text(points.point_b)}")
    if out := ecods.depth(a, b):
        print(f"  depth {number(out.depth)}: the slab would move out along {text(out.direction)}")
    print(f"  pairs of triangles that share a point: {len(ecods.intersections(a, b))}")
    if contact := ecods.cast(a, (0, 0, -1), b):
        print(f"  falling, it meets the slab at time {number(contact.time)}")
    if hit := ecods.first_hit(ecods.Ray((0.25, 0.5, 2), (0, 0, -1)), a):
        print(f"  a ray from above hits triangle {hit.triangle} at {text(hit.point)}")

# What is wrong is said by a typed error, and changes nothing.
try:
    box((0, 0, 0), (1, 1, float("inf")))
except ecods.InvalidMesh as error:
    print(f"A box without end: {error}")
