"""The two ends of an enclosed time of contact, src/exact/measure/contact/enclose_contact.cpp.

Proved: the lower end is at most G / n.m for any n, with G and n.m bounded as in verify/proofs/weak_duality.py (m is off
by one unit, and eta is at least one). The upper end is that of the TRUE normal, not of the rounded one: both its
determinants have the bound of signs, bound_of_three() of verify/proofs/certain_signs.py, and the upper end is at least
(det(u, v, w) + bound) / (det(u, v, m) - bound) of the numbers as computed, where the divisor is positive."""
from rounding import *

SOURCE = "src/exact/measure/contact/enclose_contact.cpp"
of_lower = constant(SOURCE, r"\(speed \+ error\) \* \(1 - (\d+) \* two_u\)")
of_upper = constant(SOURCE, r"\(speed - bound_\) \* \(1 \+ (\d+) \* two_u\)")
text = (ROOT / SOURCE).read_text()
claim("(dot(n_, x_.w.x) + bound_) / (speed - bound_)" in text, "both determinants have the bound of signs")
claim("speed > bound_" in text, "the divisor is positive")
# The rounding of speed + error is in E. The quotient and the product are rounded.
claim((1 + U) ** 2 * (1 - of_lower * U) <= 1, "the lower end is too great")
claim((1 - U) ** 3 / (1 + U) * (1 + of_upper * U) >= 1, "the upper end is too small")
end()
