"""Areas of triangles of a patch's corners, and squares of distances, in doubles: src/query/patch/reduce.cpp.

Proved: differences of rounded points are off by less than e; areas, sums of them, and squares across the normal by less
than the code counts, in any rounding mode. All in units of W e, with u' W at most 3/4 e, where W is an upper bound of
differences, true and computed."""
from rounding import *

OUT = "src/query/patch/reduce.cpp"
X = Q(1)
D = 2 * X
of_e = constant(OUT, r"\? (\d+) \* two_u \* most")
claim(2 * U * X + U * D <= of_e * U * X, "a difference of two points")
W = D + 2 * (4 * U * X)
claim(W <= 3 * X, "the size of a difference")
share = Q(3, 4)  # of e, at least u' W
claim(U * 3 * X <= share * 4 * U * X, "the roundings of a difference")

# A product of three factors: two are off by e, one by u'; five roundings.
roundings = ((1 + U) ** 5 * (1 + U) - 1) / U
area = 6 * (2 * (1 + U) + share * (roundings + 1))
of_area = constant(OUT, r"terms \* \((\d+) \+ \d+ \* terms\)")
of_sums = constant(OUT, r"terms \* \(\d+ \+ (\d+) \* terms\)")
two = constant(OUT, r"of_sums_ = (\d+) \* terms")
for terms in range(1, 70):
    one_sum = terms * area + terms * (6 * terms) * share * (1 + U) ** terms
    claim(2 * one_sum * (1 + 8 * U) <= two * terms * (of_area + of_sums * terms) * (1 + U), f"two sums of {terms} areas")
# For more terms, the square decides.
claim(6 * share * (1 + Q(1, 10)) <= of_sums, "sums of many areas")

# The cross product of the normal and a difference, its square, and the sum of three of these.
side = 2 * (1 + share * (1 + ((1 + U) ** 2 - 1) / U)) + 2 * share * U
square = side * (4 + 8 * U) + 4 * share * (1 + U) ** 2
all_three = 3 * square + 2 * share * 12 * (1 + U) ** 4
claim(2 * all_three * (1 + 4 * U) <= constant(OUT, r"factor = (\d+);"), "two squares across the normal")
end()
