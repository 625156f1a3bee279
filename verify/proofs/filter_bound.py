"""The bounds of the floating-point filter, src/exact/sign/filter_bound.hpp, as computed from extent and delta.

Proved: the determinant of three rounded differences of points, each off by delta, differs from the one of the true
points by at most orient3d_bound() as computed, and a minor by at most orient2d_bound(): for all extents and deltas, and
with what underflow loses within the guard E < 2^200, B > 2^-780."""
from rounding import *

HEADER = "src/exact/sign/filter_bound.hpp"
thirty = constant(HEADER, r"\((\d+) \* two_u \* \(E\[0\] \* yz\)")
six = constant(HEADER, r"\+ (\d+) \* \(e\[0\] \* yz")
quarter = constant(HEADER, r"bound = \(([\d.]+) \* two_u \* \(E\[i\]")
two = constant(HEADER, r"\+ (\d+) \* \(e\[i\] \* E\[j\]")
slack = constant(HEADER, r"evaluation_slack = 1 \+ (0x1p-\d+)")
guard = constant(HEADER, r"bound > (0x1p-\d+)")


def minor(a, b, i, j):
    return a[i] * b[j] - a[j] * b[i]


def determinant(a, b, c):
    return (minor(a, b, 1, 2) * c[0] + minor(a, b, 2, 0) * c[1]) + minor(a, b, 0, 1) * c[2]


# Let x be the real difference of two rounded points, at most ext. As computed it has one rounding; the true one is
# x + ~x, with ~x at most 2 delta. The error is that of rounding plus that of the true determinant from the one of x.
def computed(name):
    return Form(exact(name).terms)._rounded(exact(name).terms)


def true(name):
    return given(name, 0)


ext = [Poly.of(f"X{k}") for k in range(3)]
delta = Poly.of("d")
sizes = {f"{r}{k}": ext[k] for r in "abc" for k in range(3)} | {f"~{r}{k}": 2 * delta for r in "abc" for k in range(3)}


def error_of(formula):
    rows, real = [[[of(r + str(k)) for k in range(3)] for r in "abc"] for of in (computed, true)]
    return formula(*rows).error(sizes) + formula(*real).error(sizes)


d = exact("d")
# `extent` as computed is at least (1 - u') of the real one: one more rounding.
x = [Form(exact(f"X{k}").terms)._rounded(exact(f"X{k}").terms) for k in range(3)]
e = [x[k].scaled(U) + d.scaled(2) for k in range(3)]
E = [x[k] + e[k] for k in range(3)]
yz, xz, xy = E[1] * E[2], E[0] * E[2], E[0] * E[1]
# A half of the slack is for rounding; the other one is for underflow.
bound3 = ((E[0] * yz) * (thirty * U) + ((e[0] * yz + e[1] * xz) + e[2] * xy) * six) * (1 + slack / 2)
claim(error_of(determinant) <= bound3.lower({}), "orient3d_bound is too small")
bound2 = ((E[0] * E[1]) * (quarter * U) + (e[0] * E[1] + E[0] * e[1]) * two) * (1 + slack / 2)
claim(error_of(lambda a, b, c: minor(a, b, 0, 1)) <= bound2.lower({}), "orient2d_bound is too small")

# Underflow: the same determinant, each operation off by eta = 2^-1022 more, with differences below 2^200.
lossy = [[exact(r + str(k), U, True) for k in range(3)] for r in "abc"]
det = determinant(*lossy)
lost = {m: c for m, c in det.terms.items() if "~eta" in m[0]}
most = Form(lost).upper({x: Poly.of(Q(2**200)) for x in sizes} | {"~eta": Poly.of(Q(1, 2**1022))}).number()
claim(most < guard * slack / 2 / 2, "underflow within the guard")
end()
