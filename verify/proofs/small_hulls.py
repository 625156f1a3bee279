"""Small hulls in doubles: src/query/convex/small_hulls.cpp.

Proved: the bounds of a distance cover all roundings, for any weights and any vector, in any rounding mode; vertices that
a margin leaves behind a feature are behind it."""
from rounding import *

HULLS = "src/query/convex/small_hulls.cpp"

# A vertex of the difference has one rounding, of at most 2 M; an edge one more, of two of these.
of_vertex = 2 * U
of_edge = 2 * of_vertex + U * (4 + 2 * of_vertex)
# Weights are at least 0. Each is at most what is left of 1, which is rounded twice: their sum exceeds 1 by this.
excess = (1 + U) ** 3 - 1
# z = p + r u + s v + t w: the edges' errors and products, by weights of at most 1 + excess in sum; three sums of at most
# the sizes of a vertex and of what was added.
of_terms = (1 + excess) * (of_edge + U * (4 + of_edge))
size = 2 + of_vertex + of_terms + 4 * excess
of_sums = ((1 + U) ** 3 - 1) * (size + 1)
# The first vertex has a weight of at least -excess; the rest of the way to a point of the simplex is as long as an edge.
of_weights = excess * 4
many = constant(HULLS, r"hulls_\[1\]\.delta\(\)\) \+ (\d+) \* two_u \* size")
claim(of_vertex + of_terms + of_sums + of_weights <= many * U * (1 - U) ** 3, "a coordinate of a point of the simplex")
of_delta = number(HULLS, r"sum, (1\.\d+) \* \(hulls_\[0\]")
claim((1 + 2 * excess) * 1 <= of_delta * (1 - U) ** 3, "what vertices are off")

# Products n.p have three roundings of each term. The vertex that is taken is less extreme by up to two more of these.
of_product = (1 + U) ** 3 - 1
of_gap = 2 * 3 * of_product + U * (2 + 2 * of_product)
claim(of_gap <= many * U * (1 - U) ** 3, "the gap along a vector")
up = number(HULLS, r"root_of_three \* error\) \* \(1 \+ (\d+) \* two_u\) < sum")
claim((1 - U) ** 6 * (1 + up * U) >= 1, "the upper bound of a distance")
down = number(HULLS, r"sum \* \(1 - (\d+) \* two_u\);")
claim((1 + U) ** 5 * (1 - down * U) <= 1, "a sum of three numbers, rounded down")
claim((1 - U) ** 7 * (1 + up * U) >= 1, "the error of a gap")
claim((1 - U) ** 3 * (1 - U) ** 4 * (1 + up * U) ** 2 >= 1, "a sum times a length, rounded up")
claim((1 + U) ** 2 * (1 - down * U) <= 1, "a gap, rounded down")
claim(number(HULLS, r"root_of_three = ([\d.]+);") ** 2 >= 3, "the root of 3")

# Heights of two vertices, and the number that they are compared with; the error of n, for a difference of 2 M on each
# of three axes.
of_two = constant(HULLS, r"of_points = (2\.\d+) \* \(hull\.delta")
rounded = constant(HULLS, r"delta\(\) \+ (\d+) \* two_u \* hull\.size")
claim(2 <= of_two * (1 - U) ** 9, "what two vertices are off")
claim(2 * of_product + U * (1 + of_product) + U <= of_two * rounded * U * (1 - U) ** 9, "heights of two vertices")
of_n = constant(HULLS, r"of_points \+ (6\.\d+) \* \(hull\.size")
claim(6 <= of_n * (1 - U) ** 5, "heights along another direction")
end()
