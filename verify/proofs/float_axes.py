"""Margins of posed boxes, corners, slabs and ranks on axes, in floats: src/bvh/axes/posed_axes_text.hpp (set_floats),
src/bvh/masks/projected_lanes_text.hpp (SlabAxis), src/bvh/axes/far_gap.cpp and src/query/certificate/pair_axis.cpp.

Proved for any P, q and slab normal, with the sums s and w as numbers: rounding in floats, the error of the numbers
themselves, of leaves' corners, and the rounding of the margins stay within the margins."""
from rounding import *

AXES = "src/bvh/axes/posed_axes_text.hpp"
of_box = constant(AXES, r"to_floats\(\((\d+) \* in_float \+ in_double \+ 2 \* exact.e\)")
of_point = constant(AXES, r"to_floats\(\((\d+) \* in_float \+ in_double \+ exact.e\)")
of_w = constant(AXES, r"in_double = (\d+) \* two_u \* exact.w")
of_slab = constant("src/bvh/masks/projected_lanes_text.hpp", r"margin = (\d+) \* \(\(std::abs\(n\[0\]\)")
of_rank = constant("src/bvh/axes/far_gap.cpp", r"row.margin \+ (\d+) \* float_u \* row.sum")
corner_error = number("src/bvh/tree/mesh_bvh.hpp", r"corner_error = (0x1[.0-9a-fp]*-\d+)")
y_max = 1 + Q(1, 2**22)
claim(corner_error <= V * Q(101, 100), "corners are off by 1.01 v")


def tree(name):
    """P of one row, converted: off by 6.1 u' w, as numbers of doubles, all of it on one coordinate."""
    P = [given(f"{name}P{k}").to_float() for k in range(3)]
    sizes = {f"~{name}P0": Poly.of(f"w{name}") * (Q(61, 10) * U), f"~{name}P1": Poly(), f"~{name}P2": Poly()}
    for k in range(3):
        sizes |= {f"{name}y{k}": Poly.of(y_max), f"{name}h{k}": Poly.of(y_max), f"~{name}y{k}": Poly.of(corner_error)}
    return P, vector(name + "y", V), vector(name + "h", V), vector(name + "y", V, given), sizes


(a, ya, ha, ca, sizes), (b, yb, hb, cb, more) = tree("a"), tree("b")
sizes |= more | {"~q": Poly.of("wd") * (Q(82, 10) * U)}
q = given("q").to_float()
s = sum((Poly.of(f"{t}P{k}") for t in "ab" for k in range(3)), Poly.of("q"))
w = Poly.of("wa") + "wb" + "wd"
# The margins as numbers: s and w as computed have at most ten roundings, and 1 + 2^-22 covers the conversion.
in_float, in_double = V * (1 - U) ** 20, of_w * U * (1 - U) ** 20
margin = s * (of_box * in_float) + w * in_double
point_error = s * (of_point * in_float) + w * in_double

# The lower end of b ...
low_b = (dot(b, yb) + q) - dot(b, hb)
high_a = dot(a, ya) + dot(a, ha)
# ... less the upper end of a, with the margin added to the reach of b: two roundings of it.
off = low_b.error(sizes) + high_a.error(sizes) + margin * (2 * V + V * V)
claim(off <= margin * (1 + Q(1, 2**22)), "the margin of boxes")
corner = dot(b, cb) + q
claim(corner.error(sizes) <= point_error, "the error of a corner")

# A slab n of the other tree: |n| times the errors of the rows, for boxes of the tree b; the slab's own ends are at most
# sum |n_k|, which s has from the tree whose P is the identity.
n = vector("n", V)
P = [[given(f"P{k}{j}").to_float() for j in range(3)] for k in range(3)]
q = [given(f"q{k}").to_float() for k in range(3)]
m = [dot(n, [P[k][j] for k in range(3)]) for j in range(3)]
slab_sizes = {x: s for x, s in sizes.items() if x.lstrip("~")[0] == "b"}
for k in range(3):
    slab_sizes |= {f"~P{k}0": Poly.of(f"w{k}") * (Q(61, 10) * U), f"~P{k}1": Poly(), f"~P{k}2": Poly(),
                   f"~q{k}": Poly.of(f"w{k}") * (Q(82, 10) * U)}
ends = (dot(m, yb) - dot(m, hb), dot(m, vector("by", V, given)))
all_of = [sum((Poly.of(f"P{k}{j}") for j in range(3)), Poly.of(f"q{k}")) + 1 for k in range(3)]
slab_margin = sum((Poly.of(f"n{k}") * (all_of[k] * (8 * in_float) + Poly.of(f"w{k}") * in_double)
                   for k in range(3)), Poly()) * (of_slab * (1 - V) ** 5)
of_ends = sum((Poly.of(f"n{k}") for k in range(3)), Poly())
q_along = dot(n, q)
for part in ends:
    off = part.error(slab_sizes) + q_along.error(slab_sizes) + (q_along.upper(slab_sizes) + of_ends + slab_margin) * (
        2 * V + V * V)
    claim(off <= slab_margin, "the margin of a slab")

# Ranks: reach + (m_b . y_b - m_a . y_a), of numbers that are at most 3 S.
both = sum((Poly.of(f"{t}P{k}") for t in "ab" for k in range(3)), Poly())
zero = {x: (s if not x.startswith("~") else Poly.of(corner_error) if "y" in x else Poly()) for x, s in sizes.items()}
S = exact("S").to_float()
for low, high in ((dot(b, yb) - dot(b, hb), dot(a, ya) + dot(a, ha)), (dot(b, cb), dot(a, ca))):
    rank = S + (low - high)
    off = rank.error(zero).at(S=both)
    claim(off <= both * (of_rank * V * (1 - U) ** 8), "the margin of a rank")

# The axis of a certificate: parts in floats, with 16 v of the sum of all magnitudes and `need`.
of_pair = constant("src/query/certificate/pair_axis.cpp", r"corner_reach\) \+ (\d+) \* v \* sum")
for low, high in ((dot(b, yb) - dot(b, hb), dot(a, ya) + dot(a, ha)), (dot(b, yb), dot(a, ya))):
    # q - margin is added to the lower end: it is rounded outwards, and the sum once.
    off = (low + exact("q", V)).error({x: (s if not x.startswith("~") else Poly()) for x, s in sizes.items()})
    off = off + high.error({x: (s if not x.startswith("~") else Poly()) for x, s in sizes.items()})
    need = (both + "q" + "need") * (of_pair * V * (1 - U) ** 20)
    claim(off + (Poly.of("need") + need) * V <= need, "the margin of a certificate's axis")
end()
