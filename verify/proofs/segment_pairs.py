"""Closest points of segments: src/exact/measure/distance/closest_on_segments.cpp and exact/point/segment_ends.cpp.

Proved: the errors of residuals and of parameters cover what ends and vectors are off, and all roundings, in any rounding
mode."""
from rounding import *

OUT, ENDS = "src/exact/measure/distance/closest_on_segments.cpp", "src/exact/point/segment_ends.hpp"
E = number(ENDS, r"error_units = (\d+);")

# Points of a segment are averages of ends, cut twice; z is a difference of two, u of two ends.
of_u = constant(OUT, r"off = \((\d+) \* side->sum")
of_z = constant(OUT, r"\? 0 : (\d+) \* sum_of_magnitudes")
of_both = constant(OUT, r"sum_of_magnitudes\(to_doubles\(z_\)\) \+ (\d+);")
claim(E + 2 <= of_u and E <= of_z and 3 * (E + 2) * E <= of_both, "z.u")
# A parameter that is off by less than 1 adds this to a coordinate, of u off by E; and so does a conversion that is cut.
claim((E + 2) + E + 1 <= constant(OUT, r"error = (\d+) \+ static_cast"), "a coordinate")

# The segment of a point and a triangle: the sum of three ends, and E units, are off by 3 E before digits are dropped.
dropped = number("src/exact/point/segment_ends.cpp", r"dropped = (\d+);")
claim(Q(3 * E) / 2**int(dropped) + 1 <= E, "an end that is made of three points")

# Doubles read from integers, products, and vectors that are off.
kept = number(OUT, r"bit_width\(size\) - (\d+), 0\);")
read = (1 + U) * (1 + Q(2) ** -int(kept - 1)) - 1
claim(read <= 2 * U, "a double read from an integer")
k = (1 + 2 * U) ** 2 * (1 + U) ** 3 - 1
claim(k <= Q(71, 10) * U, "a product of two vectors")
least = number(OUT, r"least_square = (0x1p\d+);")
r = root_above(3) * E / root_above(least) * (1 + 8 * U)  # of a length
squares = (1 + k) ** 2 * (1 + U) - 1
product = k * (2 + k) + U * (1 + k) ** 2
off = squares + product + U * (1 + squares + product)
moved = 2 * ((1 + r) ** 4 - 1)
of_det = constant(OUT, r"of_determinant = (\d+) \* two_u")
claim(off + moved <= of_det * U * (1 - k) ** 2 * (1 - U) ** 3, "the determinant")

above = 1 + constant(OUT, r"above = 1 \+ (\d+) \* two_u") * U
vector_read, square = 1 - 2 * U, (1 - 2 * U) ** 2 * (1 - U) ** 3
root = square**2 * (1 - U) ** 2  # the root of a product is no further off than the product, and rounded
claim(vector_read * (1 - U) ** 6 * above >= 1, "the error of a residual")
residual = vector_read * (1 - U)
claim(residual * min(square, root) * (1 - U) ** 5 * above >= (1 + r) ** 4, "the error of two parameters")
claim(residual / (1 + k) * (1 - U) ** 3 * above >= 1 / (1 - r) ** 2, "the error of one parameter")
claim(root * (1 - U) ** 4 * above >= (1 + 2 * U) * (1 + r) ** 2, "a slope at an end")
claim((1 - U) ** 3 * above >= 1 + 2 * U, "a parameter inside")
claim(vector_read * (1 - U) ** 3 * above >= 1, "how far a point is moved")
end()
