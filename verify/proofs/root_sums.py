"""Sums of a rational number and a root, distances of segments, and places of moving bodies:
src/exact/measure/round/round_root_sum.cpp, src/query/body/segment_filter.cpp, near_pairs.cpp and rounded_hit.cpp.

Proved: the digits of a sum are off by less than 2^35 of their units; the bounds of a segments' distance, and of places
and their distances, cover all roundings, in any rounding mode."""
from rounding import *

SUM, FILTER = "src/exact/measure/round/round_root_sum.cpp", "src/query/body/segment_filter.cpp"

# Digits. A quotient of 127 digits, cut; of long integers, the four leading limbs have at least 193 digits.
kept = constant(SUM, r"most = (\d+);")
cut = Q(2) ** -int(64 * kept - 64)
claim(cut < Q(1, 2**126), "the leading limbs of a quotient")
quotient = (1 + Q(1, 2**126)) / (1 - cut) - 1
# A root: half the error of its square, the inverse root, 127 of at least 251 digits cut off, and a cut to 128 digits.
root = (1 + quotient) * (1 + Q(1, 2**94)) * (1 + Q(1, 2**123)) * (1 + Q(1, 2**127)) - 1
total = max(root, quotient) + 2 * Q(1, 2**124)  # of a sum; both numbers are shifted, the sum has at least 125 digits
of_result = (1 + quotient) / (1 - total) * (1 + Q(1, 2**126)) - 1
promised = constant(SUM, r"error_of_digits = Uint128\{1\} << (\d+)")
claim(2**128 * max(total, of_result) + 1 <= 2 ** int(promised), "the digits of a sum")

# A point of a segment: x0 has one rounding, s x1 and s x0 have three; the difference of two points has one more.
many = constant(FILTER, r"2 \* std::max\(p\.delta, q\.delta\) \+ (\d+) \* two_u \* size")
of_point = U + 2 * ((1 + U) ** 3 - 1)
of_between = 2 * of_point + U * (2 + 2 * of_point)
claim(of_between <= many * U * (1 - U) ** 3, "a coordinate between two points")
# n.q for |q| <= M has three roundings of each term, and so has n.p; then their difference.
of_gap = 2 * ((1 + U) ** 3 - 1) + 2 * U * (1 + U) ** 3
claim(of_gap <= many * U * (1 - U) ** 3, "the gap along a vector")
up = number(FILTER, r"root_of_3 \* error\) \* \(1 \+ (\d+) \* two_u\) < sum")
claim((1 - U) ** 6 * (1 + up * U) >= 1, "the upper bound of a distance")
down = number(FILTER, r"sum \* \(1 - (\d+) \* two_u\)\) return -1")
claim((1 + U) ** 5 * (1 - down * U) <= 1, "a sum of three numbers, rounded down")
claim((1 - U) ** 7 * (1 + up * U) >= 1, "the error of a gap")
claim((1 - U) ** 3 * (1 - U) ** 4 * (1 + up * U) ** 2 >= 1, "a sum times a length, rounded up")
claim((1 + U) ** 2 * (1 - down * U) <= 1, "a gap, rounded down")
claim(number(FILTER, r"root_of_3 = ([\d.]+),") ** 2 >= 3, "the root of 3")

# Places of moving bodies: terms go through three roundings, times are off by 4 u', the sum of magnitudes by seven.
NEAR, HIT = "src/query/body/near_pairs.cpp", "src/query/body/rounded_hit.cpp"
of_place = (1 + U) ** 3 * (1 + 4 * U) - 1
claim(of_place <= number(NEAR, r"step, (\d+) \* two_u \* size") * U * (1 - U) ** 7, "a place on a line")
of_way = (1 + U) ** 4 * (1 + 4 * U) - 1  # the motion has one rounding more
claim(of_way <= number(NEAR, r"\{pose\.t, (\d+) \* two_u") * U * (1 - U) ** 7, "a place on a way")
claim((1 - U) ** 3 * (1 + number(NEAR, r"d \* \(1 \+ (\d+) \* two_u\)") * U) >= 1, "a sum of three numbers, rounded up")
claim((1 - U) ** 6 * (1 + number(NEAR, r"half \* \(1 \+ (\d+) \* two_u\)") * U) >= 1, "a reach, rounded up")
claim((1 - U) ** 5 * (1 + number(HIT, r"speed \* \(1 \+ (\d+) \* two_u\)") * U) >= 1, "the end of a line in a box")
end()
