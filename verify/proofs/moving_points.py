"""Projections of moving corners, src/exact/measure/contact/moving_points.hpp, and their gaps in bound_meeting.cpp.

Proved, for all vectors n, times s and r = 1 - s, errors e0 and e1 of the places at both ends and magnitudes M0 and M1
of their differences from the reference: the difference of two projections as computed, less the bound as computed, is
at most the true difference. And the part of a time interval at a chord's zero, of two gaps of different signs, is
rounded outwards."""
from rounding import *

HEADER = "src/exact/measure/contact/moving_points.hpp"
of_error = constant(HEADER, r"return ([\d.]+) \* \(error \+ two_u \* most\)")
of_most = constant(HEADER, r"most\) \+ (\d+) \* two_u \* most")
n = vector("n")
s, rest = exact("s"), Form(exact("r").terms)._rounded(exact("r").terms)
e = [exact("e0"), exact("e1")]


def corner(name):
    return [exact(f"{name}p{k}") * rest + exact(f"{name}q{k}") * s for k in range(3)]


gap = dot(n, corner("b")) - dot(n, corner("a"))
sizes, off = {}, Poly()
for k in range(3):
    for body in "ab":
        sizes |= {f"{body}p{k}": Poly.of(f"M0{k}"), f"{body}q{k}": Poly.of(f"M1{k}")}
        # The place as computed is off by the error of the place, and by the rounding of the difference.
        off = off + Poly.of(f"n{k}") * ((Poly.of("e0") + Poly.of(f"M0{k}") * (U / (1 - U))) * "r" +
                                        (Poly.of("e1") + Poly.of(f"M1{k}") * (U / (1 - U))) * "s")
factors = []
for k in range(3):
    ends = []
    for end_of in 0, 1:
        most = exact(f"M{end_of}{k}")
        ends.append((e[end_of] + most.scaled(U)) * of_error + (most * of_most).scaled(U))
    factors.append(ends[0] * rest + ends[1] * s)
bound = dot(n, factors) + 0  # the sum with `underflow`
claim(gap.error(sizes) + off + U * (gap.upper(sizes) + bound.upper({})) <= bound.lower({}), "the bound of a gap")

# at = gap_from / (gap_from - gap_to), of numbers of different signs: three roundings with the factor.
SOURCE = "src/exact/measure/contact/bound_meeting.cpp"
before, after = constant(SOURCE, r"at \* \(1 - (\d+) \* two_u\)"), constant(SOURCE, r"at \* \(1 \+ (\d+) \* two_u\)")
at = Factor() / Factor().rounded()
claim(at.high * (1 + U) * (1 - before * U) <= 1, "a zero is found too late")
claim(at.low * (1 - U) * (1 + after * U) >= 1, "a zero is found too early")

# The motion up to time s (src/query/cast/moving_pairs.cpp): its end is off by at most end_error as computed.
SOURCE = "src/query/cast/moving_pairs.cpp"
eight = constant(SOURCE, r"\(1 \+ (\d+) \* two_u\) \* off")
four = constant(SOURCE, r"off \+ (\d+) \* two_u \* \(most_at_start")
place = exact("p") * rest + exact("q") * s
sizes = {"p": Poly.of("M0"), "q": Poly.of("M1"), "r": Poly.of(1)}
off = place.error(sizes) + Poly.of("e0") + Poly.of("e1") * "s"
error = (e[0] + s * e[1]) * (1 + eight * U) + ((exact("M0") + s * exact("M1")) * four).scaled(U) + 0
claim(off <= error.lower({}), "the end of a motion up to a time")
end()
