"""Signs of determinants of doubles without error: 6 u' (and 7 u', 3 u') times the products' magnitudes, as computed.

Proved for src/exact/sign/difference_signs.hpp, and for the orientation of a matrix in src/query/convex/posed_hulls.cpp:
the error of the determinant, and of a minor, is at most the bound as computed, for all magnitudes."""
from rounding import *

HEADER = "src/exact/sign/difference_signs.hpp"
three = constant(HEADER, r"determinant_error = (\d+) \* two_u")
two = constant(HEADER, r"minor_error = (\d+) \* two_u")
seven = constant("src/query/convex/posed_hulls.cpp", r"std::abs\(det\) > (\d+) \* two_u \* sum")


def minor(a, b, i, j):
    return a[i] * b[j] - a[j] * b[i]


def permanent_minor(a, b, i, j):
    return a[i] * b[j] + a[j] * b[i]


def of_three(a, b, c, two_by_two):
    return (two_by_two(a, b, 1, 2) * c[0] + two_by_two(a, b, 2, 0) * c[1]) + two_by_two(a, b, 0, 1) * c[2]


a, b, c = vector("a"), vector("b"), vector("c")
real = [vector(name, 0) for name in "abc"]
det = of_three(a, b, c, minor)
claim(det.value() == of_three(*real, minor).value(), "the determinant is the one of real numbers")
claim(len(det.value()) == 6, "it has six products")
for factor in three, seven:
    claim(det.error({}) <= (of_three(a, b, c, permanent_minor) * (factor * U)).lower({}), "the error of a determinant")
# A sign is compared with `two` times the magnitudes on the fly; the product with u' is exact.
claim(minor(a, b, 0, 1).error({}) <= (permanent_minor(a, b, 0, 1) * (two * U)).lower({}), "the error of a minor")
end()
