"""point_error_bound(), src/exact/point/point.hpp, as computed, with underflow; in bounds of boxes, too.

Proved: fl(R v + d), d = fl(t - t0), is within error_of_sum times the computed sum S of the real R v + t - t0, on each
axis, and what underflow loses, of eight operations and of four subnormal inputs, is below underflow_of_points for
factors below small_factor, and below underflow_of_points times the factor beyond it. (verify/proofs/posed_point.g is
the first part by Gappa.)"""
from rounding import *

HEADER = "src/exact/point/point.hpp"
of_sum = constant(HEADER, r"error_of_sum = ([\d.]+) \* two_u")
absolute = constant(HEADER, r"underflow_of_points = (0x1p-\d+)")
small = number(HEADER, r"small_factor = (0x1p\d+)")
R, v = vector("R"), vector("v")
d = Form(exact("d").terms)._rounded(exact("d").terms)
place = dot(R, v) + d
S = (dot(R, v) + d) * (of_sum * U)
claim(place.error({}) <= S.lower({}), "the error of a posed point")

# Each operation loses eta; each input that is taken for zero changes by eta.
R, v = vector("R", U, lambda n, u: given(n, u, True)), vector("v", U, lambda n, u: given(n, u, True))
place = dot(R, v) + given("d", U, True)
place = place + 0  # fl(t - t0)
eta = Q(1, 2**1022)
for factor, limit in (small, absolute), (Q(2**1000), absolute * 2**1000):
    sizes = {x + str(k): Poly.of(factor) for x in "Rv" for k in range(3)}
    sizes |= {"~" + x + str(k): Poly.of(eta) for x in "Rv" for k in range(3)} | {"~eta": Poly.of(eta)}
    sizes |= {"~d": Poly.of(eta)}
    lost = Form({m: c for m, c in place.terms.items() if any(x.startswith("~") for x in m[0])}).upper(sizes).number()
    claim(lost < limit, f"underflow for factors up to {float(factor)}")
end()
