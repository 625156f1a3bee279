"""Bounds of signs of polynomials in vectors, src/exact/measure/distance/triangle_vectors.hpp, as computed.

Proved for vectors whose coordinates are at most X, as computed, and off by C u' X, C = eta / 2, 1 <= eta <= 6: x.y,
(x x y).z, (x x y).(z x v) and ((y.y) x - (x.y) y).z as computed differ from the true ones by at most the bounds as
computed. Errors are convex in eta and bounds affine, so both ends suffice. (The Gappa claims enclosure_signs and
enclosure_signs_exact show it monomial by monomial.)"""
from rounding import *

HEADER = "src/exact/measure/distance/triangle_vectors.hpp"
slack = number(HEADER, r"second_order = 1 \+ (0x1p-\d+)")
two = [constant(HEADER, r"(\d+) \* \(eta \+ 3\) \* two_u"), 1, constant(HEADER, r"3 \* \(eta \+ (\d+)\) \* two_u")]
three = [constant(HEADER, r"(\d+) \* \(1.5 \* eta"), Q(3, 2), constant(HEADER, r"6 \* \(1.5 \* eta \+ (\d+)\)")]
four = [constant(HEADER, r"(\d+) \* \(2 \* eta \+ 7\)"), 2, constant(HEADER, r"12 \* \(2 \* eta \+ (\d+)\)")]
across = [constant(HEADER, r"(\d+) \* \(2 \* eta \+ 8\)"), 2, constant(HEADER, r"18 \* \(2 \* eta \+ (\d+)\)")]


def across_of(y, x, z):
    yy, xy = dot(y, y), dot(x, y)
    return dot([x[k] * yy - y[k] * xy for k in range(3)], z)


formulas = {
    "x.y": (two, "xy", lambda x, y: dot(x, y)),
    "(x x y).z": (three, "xyz", lambda x, y, z: dot(cross(x, y), z)),
    "(x x y).(z x v)": (four, "xyzv", lambda x, y, z, v: dot(cross(x, y), cross(z, v))),
    "across": (across, "yxz", across_of),
}
for eta in 1, 6:
    for name, ((m, of_eta, r), names, formula) in formulas.items():
        sizes = {f"{x}{k}": Poly.of(1) for x in names for k in range(3)}
        sizes |= {f"~{x}{k}": Poly.of(Q(eta, 2) * U) for x in names for k in range(3)}
        off = formula(*[vector(x) for x in names]).error(sizes) + formula(
            *[vector(x, 0, given) for x in names]).error(sizes)
        # Three roundings at most: of the sum with eta, and of products that are no powers of two.
        bound = m * (of_eta * eta + r) * U * (1 + slack) * (1 - U) ** 6
        claim(off.number() <= bound, f"{name} for eta = {eta}")
end()
