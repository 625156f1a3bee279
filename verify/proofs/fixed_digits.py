"""Digits of lengths, distances of planes and crossings: src/exact/measure/round/fixed_digits.cpp, fixed_length.cpp,
fixed_plane.cpp, fixed_vector.cpp and src/exact/measure/line/round_crossing.cpp, in any rounding mode.

Proved: the inverse root is off by less than 2^-97 (2^-94 is promised); the errors of digits count all that is off,
terms of second order included; a crossing's quotient q is between q - 3 and q + 2 of its units."""
from rounding import *

R3 = root_above(3)
LENGTH, PLANE = "src/exact/measure/round/fixed_length.cpp", "src/exact/measure/round/fixed_plane.cpp"
CROSSING = "src/exact/measure/line/round_crossing.cpp"

# inverse_root. x has 124 to 128 digits; its upper 64 are converted (u'), cut (2^-60), the root halves both and rounds,
# so does the quotient, and the product of 2^84 is cut to an integer above 2^52.
first = ((1 + U) ** 3 / (1 - Q(1, 2**60)) ** 1) / (1 - Q(1, 2**52)) - 1
claim(first < Q(1, 2**49), "the first guess")
# g = y (1 + e): g (1 + (1 - x g^2) / 2) = y (1 - 3/2 e^2 - 1/2 e^3).
step = Q(3, 2) * first**2 + Q(1, 2) * first**3
for e in (first, -first):  # the identity itself, for numbers
    claim((1 + e) * (1 + (1 - (1 + e) ** 2) / 2) == 1 - Q(3, 2) * e**2 - Q(1, 2) * e**3, "Newton's step")
cut = Q(1, 2**108) + Q(1, 2**123) + Q(1, 2**125)  # of rest, of s beyond x, of the last shift
of_root = step + cut
claim(of_root < Q(1, 2**97), "the inverse root")

# A length: digits below 2^128; |x|, at least 2^125, is off by sqrt(3) error.
digits = Q(2**128)
powers = re.search(r"error = \(Uint128\{1\} << (\d+)\) \+ \(Uint128\{1\} << (\d+)\) \+ \(of->error << (\d+)\) \+ (\d+)",
                   re.sub(r"\s+", " ", (ROOT / LENGTH).read_text())).groups()
root_bits, cut_bits, error_bits, last = (int(x) for x in powers)
counted = Q(2**root_bits) + 2**cut_bits + last
off = digits * ((1 + Q(1, 2**94)) * (1 + Q(1, 2**123)) - 1) + 1
claim(off <= counted, "a length of exact points")
for error in (Q(1), Q(2**58)):
    off = digits * ((1 + Q(1, 2**94)) * (1 + Q(1, 2**123)) * (1 + R3 * error / 2**125) - 1) + 1
    claim(off <= counted + error * 2**error_bits, f"a length off by {error}")

# A distance from a line: two roots, two cuts, and both errors.
powers = re.search(r"off = \(Uint128\{1\} << (\d+)\) \+ \(Uint128\{1\} << (\d+)\) \+ "
                   r"\(\(product->error \+ line->error\) << (\d+)\) \+ (\d+)",
                   re.sub(r"\s+", " ", (ROOT / LENGTH).read_text())).groups()
root_bits, cut_bits, error_bits, last = (int(x) for x in powers)
for x, y in ((0, 0), (1, 0), (0, 1), (2**58, 2**57), (1, 2**57), (2**58, 1), (0, 2**57), (2**58, 0)):
    all_of = (1 + Q(1, 2**94)) ** 2 * (1 + Q(1, 2**123)) * (1 + Q(1, 2**126)) * (1 + R3 * x / 2**125) / (
        1 - R3 * y / 2**125)
    claim(digits * (all_of - 1) + 1 <= Q(2**root_bits) + 2**cut_bits + (x + y) * 2**error_bits + last,
          f"a distance from a line, off by {x} and {y}")

# quotient() of a plane: an error in size counts 2^127 of the product, where the inverse root is at most 2^127 times
# 1 + 2^-97: what that adds, and the product of both errors, is below 2^8 of the result, as size's error is below 2^100
# there. The inverse root counts 2^34 and is off by 2^31.
promised = constant(PLANE, r"total = of_size \+ \(Uint128\{1\} << (\d+)\)")
for error in (0, 1, 2**64):
    off = digits * ((1 + of_root) / (1 - R3 * error / 2**125) - 1) + 2**100 * 4 * (of_root + R3 * error / 2**125) + 1
    claim(off <= 2 ** int(promised) + error * 16 + 2, f"a quotient by a normal that is off by {error}")

# FixedVector. A length has the inverse root and the dropped digits of a square, a cut, and a shift that cuts its error; a
# direction 2 sqrt(3) e / |x| in units of 2^-126, the inverse root, and a cut.
VECTOR = "src/exact/measure/round/fixed_vector.cpp"
of_root_and_cut = (1 + Q(1, 2**94)) * (1 + Q(1, 2**123)) - 1
shift = number(VECTOR, r"static_cast<Uint128>\(value\) >> (\d+)\)")
claim(of_root_and_cut / (1 - of_root_and_cut) <= Q(1, 2 ** int(shift)), "the length of a vector")
claim(R3 <= constant(VECTOR, r"doubled = (\d+) \* largest_error"), "the length of a vector that is off")
claim(2 <= constant(VECTOR, r"\+ of_errors \+ (\d+)\};"), "the cuts of a length")
claim(2 * R3 / 2**125 * 2**126 <= constant(VECTOR, r"(\d+) \* error_ \+"), "a direction that is off")
claim(2**126 * Q(1, 2**94) <= 2 ** number(VECTOR, r"error_ \+ \(Uint128\{1\} << (\d+)\)"), "a direction")

# round_crossing: 127 digits a by 64 digits b, cut, each sum off by 2^-(digits_min - 1).
digits_min = constant(CROSSING, r"digits_min = (\d+)")
too_large = constant(CROSSING, r"too_large = (\d+)")
width = constant(CROSSING, r"width = (\d+); const")
e = Q(1, 2 ** int(digits_min - 1))
# a / b < 2^64 and a / b^2 < 2, so with q <= a / b < q + 1:
above = 1 + 2**64 * ((1 + e) / (1 - e) - 1) + (1 + e) / (1 - e) / 2**63
below = 2 + 2**64 * (1 - (1 - e) / (1 + e))
claim(below <= too_large, "a crossing below")
claim(above <= width - too_large, "a crossing above")
end()
