"""E and the gap along a vector, src/exact/measure/distance/triangle_vectors.hpp: for any n, of doubles as they are.

Proved, in units where coordinates are at most X = 2^53 and off by at most eta, for 1 <= eta <= 7: product_error() as
computed, subtracted from (or added to) a product n.x as computed, leaves a lower (or upper) bound of n times the true
vector, the rounding of that sum included; and gap(), if positive, is a lower bound of the sum of such bounds."""
from rounding import *

HEADER = "src/exact/measure/distance/triangle_vectors.hpp"
constant_part = constant(HEADER, r"return \(([\d.]+) \+ eta\) \* sum_of_magnitudes")
of_sums = constant(HEADER, r"- high\) - (\d+) \* two_u \* first")

n, x = vector("n"), vector("x")
product = dot(n, x)
for eta in 1, 7:  # errors and E are affine in eta
    sizes = {f"x{k}": Poly.of(2**53) for k in range(3)} | {f"~x{k}": Poly.of(eta) for k in range(3)}
    off = product.error(sizes)
    for k in range(3):
        off = off + Poly.of(f"n{k}") * eta
    factor = Form({((), 0, 0): (constant_part + eta, constant_part + eta)})
    E = ((n[0] + n[1]) + n[2]) * factor._rounded(factor.terms)
    claim(off + U * (product.upper(sizes) + E.upper({})) <= E.lower({}), f"E for eta = {eta}")

# r1 >= r2 >= r3 > 0: two sums round by at most U r1 each, the last difference by at most U r3.
claim(2 * U + U <= of_sums * U, "the roundings of the sums")
end()
