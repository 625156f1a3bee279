"""Bounds of a few operations each: distances of boxes, balls, segments, times and squares on axes, local frames, the
support table, and the place of a point outside a body's reach.

Proved: the factor or margin of each covers its roundings; constants are read from the sources that are named."""
from rounding import *

R3 = root_above(3)

# src/geometry/box_distance.hpp: a factor less than one times the root of three squares of differences.
less = constant("src/geometry/box_distance.hpp", r"factor = 1 - (0x1p-\d+)")
gap = Factor().rounded()
square = gap * gap
claim((((square + square) + square).root() * Factor(1 - less, 1 - less)).high <= 1, "distance_below")

# src/bounds/ball_bounds.cpp: boxes by margins, and squares that are compared.
BALL = "src/bounds/ball_bounds.cpp"
four = constant(BALL, r"margin = (\d+) \* two_u")
end_of = exact("c") - exact("r")
margin = ((exact("c") + exact("r")) * four).scaled(U) + 0
off = end_of.error({}) + (end_of.upper({}) + margin.upper({})) * U
claim(off <= margin.lower({}), "the box of a ball")
sixteen = constant(BALL, r"bound = (\d+) \* two_u \* larger")
# sum > fl(square + bound): sum has five roundings, square one, bound one and the sum of both one.
claim((1 + U) ** 5 * (1 - sixteen * U * (1 - U) ** 2) <= (1 - U) ** 2, "a ball apart from a box")
claim((1 + U) * (1 - sixteen * U * (1 - U) ** 2) <= (1 - U) ** 6, "a ball that meets a box")

# src/bounds/segment_bounds.cpp: s = d_y (z - a_z) - d_z (y - a_y), with all differences at most those of the ends.
SEGMENT = "src/bounds/segment_bounds.cpp"
of_side = constant(SEGMENT, r"\? (\d+) \* two_u \* size_y \* size_z")


def rounded(name):
    return Form(exact(name).terms)._rounded(exact(name).terms)


side = rounded("dy") * rounded("z") - rounded("dz") * rounded("y")
bound = (rounded("dy") * of_side).scaled(U) * rounded("dz") + 0
claim(side.error({"z": Poly.of("dz"), "y": Poly.of("dy")}) <= bound.lower({}), "the side of a segment")

# src/bounds/local_frame.hpp: inverse (v - center), |v - center| <= 1.01 sqrt(3) scale, and F^T in place of F^-1.
FRAME = "src/bounds/local_frame.hpp"
tau = number(FRAME, r"frame_tau_max = (0x1p-\d+)")
coordinate_error = constant(FRAME, r"coordinate_error = (0x1p-\d+)")
far = Q(101, 100) * R3
claim((3 * 2 * tau + far * 0) < Q(1, 50), "|F^-1| is below 1.01 entry by entry sums")
rounding = ((1 + U) ** 4 - 1) * far * (1 + 3 * tau)
claim(rounding + 3 * Q(31, 10) * tau * far <= coordinate_error, "the error of coordinates")

# src/bounds/local_frame.cpp: the product of the axes is computed with three roundings, of terms whose sum is near one.
half = constant("src/bounds/local_frame.cpp", r"tau <= ([\d.]+) \* frame_tau_max")
claim(((1 + U) ** 3 - 1) * (1 + Q(1, 2**20)) + half * tau <= tau, "the axes of a frame")
claim(half >= Q(1, 2), "half of tau is what is tested")

# src/bounds/support_lanes_text.hpp: places on the grid and shares, h(d) at most 3 m in units, and |y| <= sqrt(3).
table_error = constant("src/bounds/support_lanes.hpp", r"table_error = (\d+) \* double_u") * U
place = 4 * ((1 + U) ** 2 - 1) + 8 * U * (1 + 4 * U)  # of 8 cells: a product of at most 4, and a sum of at most 8
claim(place <= 17 * U, "a place in the grid")
off_axis = (place / 4 + 2 * U * (1 + U)) * (1 + U)
value = off_axis * 3 * R3 + 3 * ((1 + U) ** 4 - 1) + 4 * 3 * U
claim(value <= table_error * (1 - U) ** 2 * Q(1, 2), "values of the table")
claim(off_axis <= 8 * U, "the direction of a share")
oriented = constant("src/bounds/support_lanes_text.hpp", r"(\d+) \* double_u \* \(\(size\[row\]\[0\]")
claim(((1 + U) ** 6 - 1) * R3 * (1 + Q(1, 2**40)) <= oriented * U * (1 - U) ** 3, "the oriented box")
reach = constant("src/bounds/support_lanes_text.hpp", r"\+ delta\) \* \(1 \+ (\d+) \* double_u\)")
claim((1 - U) ** 3 * (1 + reach * U) >= 1, "the reach of a box is rounded down")

# src/query/solid/locate.cpp: the difference and the sum of three products, each with a factor.
LOCATE = "src/query/solid/locate.cpp"
less, more = number(LOCATE, r"offset \* \(1 - (0x1p-\d+)\)"), constant(LOCATE, r"reach \* \(1 \+ (0x1p-\d+)\)")
claim((1 + U) ** 2 * (1 - less) <= (1 - U) ** 5 * (1 + more), "a point that is far from a body")

# src/query/body/outside_ball.cpp: gaps that cover a difference's rounding, three squares, their sum, root and a factor.
AROUND = "src/query/body/outside_ball.cpp"
of_gap = constant(AROUND, r"\(1 \+ (\d+) \* two_u\) \+ vertex.error")
of_root = constant(AROUND, r"\(1 \+ (\d+) \* two_u\) \+ 0x1p-509")
claim((1 - U) * (1 + of_gap * U) >= 1, "a difference of a vertex and a center")
claim((1 - U) ** 7 * ((1 - U) ** 2 * (1 + of_root * U)) ** 2 >= 1, "a vertex in a ball")

# src/bvh/axes/distance_axes*.hpp and .cpp: squares in floats, slabs' normals up to 1 + 2^-21, and limits in doubles.
TEXT, AXES = "src/bvh/axes/distance_axes_text.hpp", "src/bvh/axes/distance_axes.cpp"
less = constant(TEXT, r"round_down\(\(1 - even.tau\) / even.factor \* \(1 - (0x1p-\d+)\)")
more = constant(TEXT, r"even.factor \* \(1 \+ (0x1p-\d+)\)")
gap = Factor(unit=V).rounded()
square = gap * gap
squares = ((square + square) + square).rounded()
claim(squares.high * (1 + Q(1, 2**21)) * (1 + U) ** 4 * (1 - less) <= 1, "a square that is too large")
tau_max = number(TEXT, r"tau_max = (0x1p-\d+)")
for tau in 0, tau_max:  # concave in tau
    claim((1 - U) ** 5 * (1 + more) * (1 + 2 * tau) * (1 - tau) >= 1, "square_up: 1 + 2 tau is above 1 / (1 - tau)")
more = constant(AXES, r"x \* x \* \(1 \+ (0x1p-\d+)\)")
claim((1 - U) ** 5 * (1 + more) >= 1, "square_above")
less = constant(AXES, r"std::sqrt\(certain\) \* \(1 - (0x1p-\d+)\)")
claim((Factor().rounded().root()).high * (1 + U) ** 3 * (1 - less) <= 1, "distance_below of a square")

# src/bvh/axes/swept_axes_text.hpp: the window, of three roundings in doubles.
WINDOW = "src/bvh/axes/swept_axes_text.hpp"
less = constant(WINDOW, r"\(from - reach\[k\]\) / v \* \(1 - (0x1p-\d+)\)")
more = constant(WINDOW, r"\(from \+ reach\[k\]\) / v \* \(1 \+ (0x1p-\d+)\)")
claim((1 + U) ** 4 * (1 - less) <= 1 and (1 - U) ** 4 * (1 + more) >= 1, "the window of a sweep")

# src/bvh/masks/triangle_bounds_text.hpp: points of edges and faces in floats, with E >= 8 v Z and coordinates up to Z.
nine = constant(AXES, r"error = (\d+) \* static_cast<double>")
E = 8 * V
z = [exact(f"z{k}", V) for k in range(3)]
unit = {f"z{k}": Poly.of(1) for k in range(3)} | {"t": Poly.of(1)}
edge = z[0] + exact("t", V) * (z[1] - z[0])
claim(edge.error(unit).number() <= E, "a point of an edge")
face = z[0] + (exact("t", V) * (z[1] - z[0]) - exact("s", V) * (z[2] - z[0]))
worst = max(face.error(unit | {"t": Poly.of(t), "s": Poly.of(s)}).number() for t, s in ((1 + V, 0), (0, 1 + V)))
claim(worst + 2 * V <= Q(24, 10) * E, "a point of a face")
claim(R3 * max(2 * (E + E), Q(24, 10) * E + E + E) <= (nine - 1) * E, "the difference of two points")

# src/query/distance/distance_bounds.cpp: a width that is certainly within the tolerance.
more = constant("src/query/distance/distance_bounds.cpp", r"lower\) \* \(1 \+ (\d+) \* 0x1p-52\)") * U
claim((1 - U) ** 2 * (1 + more) >= 1 + U, "a width that is too large")

# src/bvh/tree/slabs.cpp: products of a normal of length 1 + v at most with corners that are off by corner_error.
two = constant("src/bvh/tree/slabs.cpp", r"round_down\(low - (\d+) \* corner_error\)")
corner_error = number("src/bvh/tree/mesh_bvh.hpp", r"corner_error = (0x1[.0-9a-fp]*-\d+)")
of_normal = R3 * (1 + 2 * V)
claim(of_normal * (corner_error + ((1 + U) ** 3 - 1) * (1 + Q(1, 2**22))) <= two * corner_error * (1 - U) ** 2 - 4 * U,
      "the ends of a slab")
end()
