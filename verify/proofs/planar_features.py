"""Bounds of polygons: src/query/convex/planar_features.cpp.

Proved: a coordinate of a moved point is off by less than eta, given that delta is at least 4.25 u' of the coordinate and
that w is the product of a length and a direction that are off by 2^-51 and 2^-53 of themselves; coordinates that are
equal differ by less than the gap; (b - a) x (c - a) is off by less than the error, roundings of the bounds included."""
from rounding import *

OUT = "src/query/convex/planar_features.cpp"
of_delta = constant(OUT, r"eta_\((\d+) \* hulls.delta\(\)")
of_w = constant(OUT, r"delta\(\) \+ (0x1p-\d+) \* std::abs\(along\)")
# Subtracting w from a point rounds by u' of both.
claim((1 + Q(100, 425)) * (1 + U) ** 2 <= of_delta * (1 - U) ** 2, "eta, of delta")
product = (1 + Q(1, 2**51)) * (1 + Q(1, 2**53)) * (1 + U) - 1
claim(product + U * (1 + product) <= of_w * (1 - U) ** 2, "eta, of w")

gap = constant(OUT, r"gap = (\d+) \* eta_")
claim(2 * (1 + U) <= gap * (1 - U), "coordinates that are equal")

# A true difference is at most 1 / (1 - u') times the one that is computed, and 2 eta.
sizes = {}
for x, size in (("x", "B"), ("y", "C")):
    for k in range(3):
        sizes |= {f"{x}{k}": Poly.of(size), f"~{x}{k}": Poly.of("h") * 2 + Poly.of(size) * (U / (1 - U))}


def turn(u, of):
    x, y = vector("x", u, of), vector("y", u, of)
    return (x[0] * y[1] - x[1] * y[0]).error(sizes)


of_eta = constant(OUT, r"error = (\d+) \* eta_ \* \(B \+ C\)")
of_square = constant(OUT, r"(\d+) \* \(eta_ \* eta_\)")
of_roundings = constant(OUT, r"(0x1p-\d+) \* \(B \* C\)")
B, C, h = exact("B"), exact("C"), exact("h")
bound = h * of_eta * (B + C) + h * h * of_square + B * C * of_roundings
claim(turn(U, exact) + turn(0, given) <= bound.lower({}), "the side of an edge")
end()
