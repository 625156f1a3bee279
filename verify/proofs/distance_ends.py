"""The two ends of an enclosed distance, src/exact/measure/distance/enclose_distance.cpp.

Proved: lower() is at most the gap over the length of n, for any n; upper() is at least the length of the true
difference z of two points of the triangles, for any weights, which are feasible. (Weak duality makes the first a lower
bound of the distance: verify/proofs/weak_duality.py. No normal enters the upper end.)"""
from rounding import *

SOURCE = "src/exact/measure/distance/enclose_distance.cpp"
of_length = constant(SOURCE, r"std::sqrt\(dot\(n_, n_\)\) \* \(1 \+ (\d+) \* two_u\)")
of_quotient = constant(SOURCE, r"all / length \* \(1 - (\d+) \* two_u\)")
root_of_3 = constant(SOURCE, r"root_of_3 = ([\d.]+)")
of_point = constant(SOURCE, r"root_of_3 \* \(([\d.]+) \+ x_.eta\)")
of_root = constant(SOURCE, r"std::sqrt\(dot\(z, z\)\) \* \(1 \+ (\d+) \* two_u\)")
of_all = constant(SOURCE, r"\+ error\) \* \(1 \+ (\d+) \* two_u\)")
of_weight = constant(SOURCE, r"\(1 - x / f\) \* \(1 - (\d+) \* two_u\)")

square = Factor().rounded()
length = ((square + square) + square).root() * Factor(1 + of_length * U, 1 + of_length * U)
claim(length.low >= 1, "the length of n is too short")
claim((1 + U) ** 2 * (1 - of_quotient * U) <= 1, "the lower end is too great")

# z = w + c0 b0 + c1 b1 - c2 a0 - c3 a1, each coordinate at most 2^53 and off by eta.
x = [exact(f"x{i}") for i in range(5)]
c = [exact(f"c{i}") for i in range(4)]
z = (((x[0] + c[0] * x[1]) + c[1] * x[2]) - c[2] * x[3]) - c[3] * x[4]
weights = (exact("c2") + exact("c3") + 1) + (c[0] + c[1])
for eta in 1, 7:  # affine in eta
    sizes = {f"x{i}": Poly.of(2**53) for i in range(5)}
    off = z.error(sizes) + (Poly.of(1) + "c0" + "c1" + "c2" + "c3") * eta
    off = off * root_above(3)
    error = weights * (root_of_3 * (of_point + eta) * (1 - U) ** 2)
    claim(off <= error.lower({}), f"the error of z for eta = {eta}")
root = ((square + square) + square).root() * Factor(1 + of_root * U, 1 + of_root * U)
claim(root.low >= 1, "the length of z is too short")
claim((1 - U) ** 2 * (1 + of_all * U) >= 1, "the upper end is too small")
claim((1 + U) ** 2 * (1 - of_weight * U) <= 1, "weights that are not feasible")
end()
