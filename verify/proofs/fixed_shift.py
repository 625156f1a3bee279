"""Vectors between parallel features, and crossings of edges, in fixed precision: src/exact/measure/round/fixed_shift.cpp
and fixed_crossing.cpp, in any rounding mode.

Proved: the error of a product counts what both factors are off, and all cuts; the error of a normal counts what its
edges are off; the digits of a quotient, from two divisions of doubles, are off by less than 2^7 units, and the error of
a parameter and of a point counts what its factors are off."""
from rounding import *

SHIFT, CROSSING = "src/exact/measure/round/fixed_shift.cpp", "src/exact/measure/round/fixed_crossing.cpp"
unit = 2 ** int(number("src/exact/measure/round/fixed_vector.hpp", r"unit_digits = (\d+);"))

# times(): |n| <= unit + a for a direction off by a, and x off by b. A number shifted to the right loses less than one.
again = constant(SHIFT, r"x\.error \+ (\d+) \* \(x\.error >> 62\)")
units = constant(SHIFT, r"\+ of_n \+ (\d+)\};")
low = 2 ** int(number(SHIFT, r"size_of\(x\.value\) >> (\d+)\)"))
high = 2 ** int(number(SHIFT, r"n\.error\)\) >> (\d+);"))
a_most = 2 ** int(number(SHIFT, r"direction_\[k\]\.error >> (\d+) == 0"))
claim(low * high == unit, "the unit of a product")
for a in (Q(1), Q(a_most)):
    for b in (Q(0), Q(1), Q(2**62), Q(2**92)):
        for x in (Q(0), Q(2**62 - 1), Q(2**125)):
            off = ((unit + 2 * a) * (x + b) - (unit + a) * x) / unit + 1
            counted = b + again * (b / 2**62 - (1 if b % 2**62 else 0))
            counted += max((x / low - 1) * a / high - 1, 0) + units
            claim(off <= counted, f"a product of a direction off by {a} and {x} off by {b}")

# normal_of(): a difference of two products of coordinates below U and V, each off by e.
twice = constant(SHIFT, r"static_cast<Int128>\((\d+) \* error\)")
cuts = constant(SHIFT, r"shifted\(sum, shift\)\) \+ (\d+);")
for e in (Q(1), Q(2**20)):
    for u, v in ((Q(1), Q(1)), (Q(2**122), Q(1)), (Q(2**122), Q(2**122))):
        claim(2 * ((u + e) * (v + e) - u * v) <= twice * e * (u + v + e), "a coordinate of a normal")
claim(1 + 1 <= cuts, "the cuts of a normal")

# find_crossing(): d x v and u x v, each scaled so that the divisor has 126 digits, and their quotient.
digits = number("src/exact/measure/round/fixed_crossing.hpp", r"digits = (\d+);")
of_factor = constant(CROSSING, r"shifted\(error, shift\)\) \+ (\d+)\};")
claim(2 <= of_factor, "the cuts of a factor")
divisor = Q(2) ** int(number(CROSSING, r"divisor_digits = (\d+),") - 1)
of_divisor = Q(2) ** int(number(CROSSING, r"bit_width\(error\) - shift > (\d+)\)") + 1)
drop = number(CROSSING, r">> \((\d+) - FixedParameter::digits\)")
for n, m in ((of_divisor, of_divisor), (Q(1), of_divisor), (of_divisor, Q(1)), (Q(1), Q(1))):
    off = (n + (1 + Q(1, 2**40)) * m) / (divisor - m)
    claim(off * 2 ** int(digits) <= (n + m) / 2 ** int(drop - digits), "a quotient of numbers that are off")

# divide(): the upper digits of both numbers are converted (exactly or by u'), divided and multiplied by a power of two.
coarse = number(CROSSING, r"coarse_digits = (\d+),")
cut = Q(2**64) / divisor
first = (1 + U) ** 3 / ((1 - U) * (1 - cut)) - 1 + cut + Q(1, 2 ** int(coarse))
claim(first <= Q(1, 2**49), "the first digits")
rest_drop = number(CROSSING, r"shifted\(rest, (\d+)\)")
claim(first * 2 * divisor * 2 ** int(coarse) < Q(2) ** int(rest_drop + 63), "the digits of the rest fit")
power = number(CROSSING, r"upper / divisor \* (0x1p\d+)")
claim(Q(2) ** int(rest_drop) / 2**64 * 2 ** int(digits - coarse) == power, "the unit of the last digits")
relative = (1 + U) ** 3 / ((1 - U) * (1 - cut)) - 1
last = first * 2 ** int(digits) * relative + Q(2) ** int(rest_drop - coarse) / divisor * 2 ** int(digits) * (1 + relative) + 1
claim(last <= 2 ** int(number(CROSSING, r"\+ \(1 << (\d+)\);")), "the last digits")

# FixedParameter::times(): u off by e times a parameter of at most 1, off by p units.
of_u = constant(CROSSING, r"of_parameter \+ (\d+) \* of_u")
of_cuts = constant(CROSSING, r"\* of_u \+ (\d+)\};")
claim((1 + Q(2**62, 2**105)) <= of_u and 2 <= of_cuts, "a point at a parameter")
end()
