"""Times of moving boxes, pieces of lines on an axis, directions of lines, features in short times and solids beyond a
limit: src/bounds/moving_box.*, src/query/certificate/line_proof.cpp, src/geometry/scaled_line.cpp,
src/exact/measure/contact/possible_features.* and src/query/convex/solid_pair.cpp."""
from rounding import *

# moving_box.cpp: (difference - gap_min) * (factor (1 / speed)): a difference, gap_min, the inverse, the factor, the
# product. gap_min itself covers what is subnormal.
MOVING = "src/bounds/moving_box.cpp"
less, more = constant(MOVING, r"less = 1 - (0x1p-\d+)"), constant(MOVING, r"more = 1 \+ (0x1p-\d+)")
claim((1 + U) ** 5 * (1 - less) <= 1 and (1 - U) ** 5 * (1 + more) >= 1, "times of a moving box")

# line_proof.cpp: the end is from + parameter (to - from), of rounded ends (one difference each) and a rounded parameter.
LINE = "src/query/certificate/line_proof.cpp"
of_size = constant(LINE, r"axis.a.error \+ (\d+) \* two_u \* size")


def rounded(name):
    return Form(exact(name).terms)._rounded(exact(name).terms)


n = vector("n")
a, b = dot(n, [rounded(f"a{k}") for k in range(3)]), dot(n, [rounded(f"b{k}") for k in range(3)])
for end_of in (a + rounded("s") * (b - a), a):
    size = sum((n[k] * (exact(f"a{k}") + exact(f"b{k}")) for k in range(1, 3)), n[0] * (exact("a0") + exact("b0")))
    margin = (size * of_size).scaled(U)
    off = end_of.error({"s": Poly.of(1)}) + (end_of.upper({"s": Poly.of(1)}) + margin.upper({})) * U
    claim(off <= margin.lower({}), "the end of a piece of a line")

# scaled_line.cpp: a direction's error is u' of it and what underflow loses before it is scaled by at most 2^900.
SCALED = "src/geometry/scaled_line.cpp"
of_underflow = constant(SCALED, r"std::abs\(d\[k\]\)\) \+ (0x1p-\d+)")
# |real - d| <= u' |d| / (1 - u'): u'^2 |d|, with |d| < 2, is beyond u' |d|, and below 2^-102.
claim(Q(1, 2**1020) * 2**900 <= of_underflow / 2, "underflow of a direction")

# possible_features.cpp: the gap's bound (moving_points.py) with 2.25 length way more, n any vector.
POSSIBLE = "src/exact/measure/contact/possible_features.cpp"
of_way = constant(POSSIBLE, r"\+ ([\d.]+) \* length \* way\[k\]")
# In half the length each corner moves by less than length / 2 times its way, of two corners: once the length. The true
# way is that of rounded places, 1 + 2 u' times it, and their errors, which count 2.25 times in place of 2 already.
claim(1 <= of_way * (1 - U) ** 6, "the way of two corners in half the time each")

# solid_pair.cpp: the vertex found is 3 D |n|_1 below the highest one, and its point off by D |n|_1, of both solids; the
# product with the difference of the points has 5 u' of its terms' magnitudes as computed.
PAIR = "src/query/convex/solid_pair.cpp"
of_terms = constant(PAIR, r"dot\(n, gap\) - (\d+) \* two_u \* magnitudes")
of_delta = constant(PAIR, r"magnitudes\) - (\d+) \* hulls.delta\(\)")
of_root = constant(PAIR, r"std::sqrt\(dot\(n, n\)\) \* \(1 \+ (\d+) \* two_u\)")
along = dot(n, [rounded(f"g{k}") for k in range(3)])
S, D = dot(n, vector("g")), exact("D")
terms = (S * of_terms).scaled(U)
deltas = (D * of_delta) * ((n[0] + n[1]) + n[2])
ones = Poly.of("n0") + "n1" + "n2"
# The vertex found: heights are off by 1.5 D |n|_1 (hull_signs.py).
off = along.error({}) + ones * "D" * (2 * (3 + 1)) + (along.upper({}) + terms.upper({})) * U + (
    along.upper({}) + terms.upper({}) + deltas.upper({})) * U
claim(off <= terms.lower({}) * (1 - U) + deltas.lower({}), "the gap of two solids")
square = Factor().rounded()
length = ((square + square) + square).root() * Factor(1 + of_root * U, 1 + of_root * U)
claim(length.low * (1 - U) >= 1, "the length of n")
end()
