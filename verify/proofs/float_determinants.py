"""Determinants and edges of triangles in floats: src/bvh/masks/triangle_lanes_text.hpp and flat_lanes_text.hpp.

Let E be the extents of both triangles, as computed, and d the error of a corner. The extents are NOT enlarged by the
error: spans of the first tree have no margin. So the filter's telescoped bound, for enlarged extents, does not apply,
and terms with d^2 E must be bounded otherwise. With columns scaled by E, entries are at most one, and errors at most
t_k = 2 d_k / E_k. A determinant of three columns with entries up to x, y, z is at most 4 x y z, as all 512 sign patterns
show. Hence
    |det(A + T) - det(A)| <= 4 ((t0 + t1 + t2) + (t0 t1 + t0 t2 + t1 t2) + t0 t1 t2),
and a sign is taken for certain only if the computed one, at most 4, exceeds the bound."""
import itertools

from rounding import *

LANES = "src/bvh/masks/triangle_lanes_text.hpp"
of_v = constant(LANES, r"\((\d+) \* 0x1p-23f \* ez")
of_d = constant(LANES, r"ez \+ ([\d.]+)f \* delta\[2\]")


def det3(m):
    return (m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] *
            (m[3] * m[7] - m[4] * m[6]))


most = max(det3(m) for m in itertools.product((-1, 1), repeat=9))
claim(most == 4, "a determinant is affine in each entry, so its extreme is at signs")


def rounded(name):
    return Form(exact(name, V).terms, V)._rounded(exact(name, V).terms)


# Rounding: differences and the determinant, for corners as computed; E as computed has one rounding.
rows = [[rounded(f"{r}{k}") for k in range(3)] for r in "abc"]
det = dot(cross(rows[0], rows[1]), rows[2])
E = [rounded(f"E{k}") for k in range(3)]
sizes = {f"{r}{k}": Poly.of(f"E{k}") for r in "abc" for k in range(3)}
bound = (E[0] * E[1] * (E[2] * of_v)).scaled(V)
# A seventh of 49 v is left for the roundings of the bound and for the true extents, which are within 2 v.
claim(det.error(sizes) <= bound.lower({}), "rounding of a determinant")

# Input errors. The bound is of_d / 2 (t0 + t1 + t2), and computed signs count only if it is below 4 (1 + 2^-10):
# with t the sum, pairs have at most t^2 / 3, and the product at most t^3 / 27. 1 + 2^-18 covers evaluation.
t = 4 * (1 + Q(1, 2**10)) / (of_d / 2)
claim(4 * (1 + t / 3 + t**2 / 27) * (1 + Q(1, 2**18)) <= of_d / 2, "input errors of a determinant")

# Edges in a plane, src/bvh/masks/flat_lanes_text.hpp: n . (z - p) for any n and p as computed, at z and at the ends.
FLAT = "src/bvh/masks/flat_lanes_text.hpp"
of_d = constant(FLAT, r"([\d.]+)f \* set.point_error\[k\]")
of_v = constant(FLAT, r"([\d.]+)f \* 0x1p-23f \* ex")
side = exact("nx", V) * rounded("y") - exact("ny", V) * rounded("x")
sizes = {"y": Poly.of("Ey"), "x": Poly.of("Ex")}
d = Poly.of("nx") * "dy" + Poly.of("ny") * "dx"
bound = exact("nx", V) * (exact("dy", V) * of_d + (exact("Ey", V) * of_v).scaled(V)) + exact("ny", V) * (
    exact("dx", V) * of_d + (exact("Ex", V) * of_v).scaled(V))
# Twice: at a corner, and at the ends of the edge; and the rounding of the sum on the right, of a value and the bound.
off = side.error(sizes) * 2 + d * 2 + (side.upper(sizes) + bound.upper({})) * V
claim(off <= bound.lower({}), "a line parallel to an edge")

# Chords, src/bvh/masks/meeting_text.hpp.
MEETING = "src/bvh/masks/meeting_text.hpp"
less = constant(MEETING, r"at \* \(1 - (\d+) \* 0x1p-23f\)") * V
more = constant(MEETING, r"at \* \(1 \+ (\d+) \* 0x1p-23f\)") * V
gap = Factor(unit=V).rounded()
at = gap / (gap + gap)
claim(at.high * (1 + V) * (1 - less) <= 1 and at.low * (1 - V) * (1 + more) >= 1, "a chord's zero")

# The support table's values, src/bounds/support_table.cpp: |direction_k| <= 1 and |y_k| <= 1 with |y| <= sqrt(3): all
# sums of magnitudes are at most 3. The point has a difference and a quotient in doubles, and is converted.
table = constant("src/bounds/support_table.cpp", r"static_cast<double>\(h\) \+ (\d+) \* float_u")
y = [exact(f"y{k}", V)._rounded(exact(f"y{k}", V).terms) for k in range(3)]
value = dot([exact(f"x{k}", V) for k in range(3)], y)
one = {f"{x}{k}": Poly.of(1) for x in "xy" for k in range(3)}
claim(value.error(one).number() + 3 * (2 * U + U**2) * 2 <= table * V * (1 - U), "values of the table")
end()
