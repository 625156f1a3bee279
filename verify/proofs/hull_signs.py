"""Bounds for convex solids: src/query/convex/prove_closest.cpp, posed_hulls.cpp and src/query/depth/rounded_bounds.hpp.

Proved for vectors of sizes A, B (the largest coordinate as computed) that are off by a <= A / 16 and b <= B / 16, the
roundings of the bounds included: dot, cross, across and the difference of two numbers. Heights along a GIVEN n are off
by less than half the margin. In depths, an upper end along n is that of the given n; distances of planes, in
of_height(), have the error of the true normal, e_n."""
from rounding import *

PROVE = "src/query/convex/prove_closest.cpp"
of_dot = constant(PROVE, r"([\d.]+) \* products \+ 13 \* two_u")
roundings_of_dot = constant(PROVE, r"3.1 \* products \+ (\d+) \* two_u")
of_cross = constant(PROVE, r"([\d.]+) \* \(a.size \* b.error")
roundings_of_cross = constant(PROVE, r"b.size \* a.error\) \+ (\d+) \* two_u")
of_across = constant(PROVE, r"(\d+) \* products \+ 44 \* two_u")
roundings_of_across = constant(PROVE, r"7 \* products \+ (\d+) \* two_u")

# The error of a difference, 2 delta + u' size, is itself rounded: a true one is at most 1 + 4 u' times it.
own = 1 + 4 * U
names = {"x": ("A", "a"), "y": ("B", "b")}
sizes = {}
for x, (size, error) in names.items():
    for k in range(3):
        sizes |= {f"{x}{k}": Poly.of(size), f"~{x}{k}": Poly.of(error) * own}


def off(formula):
    result = [Poly(), Poly()]
    computed, real = (formula(vector("x", u, of), vector("y", u, of)) for u, of in ((U, exact), (0, given)))
    return computed.error(sizes) + real.error(sizes)


def one_error(poly):
    """An upper bound in which each monomial has one error at most: others are a sixteenth of their size."""
    size_of = {"a": "A", "b": "B"}
    result = Poly()
    for m, c in poly.terms.items():
        errors = [x for x in m if x in size_of]
        if not errors:
            result = result + Poly({m: c})
        for kept in errors:  # as many equal shares
            rest = [size_of[x] for x in m if x in size_of]
            rest.remove(size_of[kept])
            key = tuple(sorted([x for x in m if x not in size_of] + rest + [kept]))
            result = result + Poly({key: c / len(errors) / 16 ** (len(errors) - 1)})
    return result


A, B, a, b = (exact(x) for x in "ABab")
bound = (A * b + (B + b) * a) * of_dot + (A * B * roundings_of_dot).scaled(U)
claim(off(dot) <= bound.lower({}), "dot")
bound = (A * b + B * a) * of_cross + (A * B * roundings_of_cross).scaled(U)
claim(one_error(off(lambda x, y: cross(x, y)[0])) <= bound.lower({}), "cross")


def across(w, u):
    uu, wu = dot(u, u), dot(w, u)
    return w[0] * uu - u[0] * wu


bound = ((B * A).scaled(2) * b + (B * B) * a) * of_across + ((B * B * A) * roundings_of_across).scaled(U)
claim(one_error(off(across)) <= bound.lower({}), "across")
# A difference x of two numbers rounds by u' x / (1 - u'), of which u' x (1 - u') counts; errors are at least 4 u' x.
four = constant(PROVE, r"\(a.error \+ b.error\) \* \(1 \+ (\d+) \* two_u\)")
claim(roundings_of_dot / 3 >= 4, "errors are at least 4 u' of their numbers")
claim(4 * U * ((1 + four * U) * (1 - U) ** 3 - 1) >= U / (1 - U) - U * (1 - U), "a difference of two numbers")

# posed_hulls.cpp: heights of two points, in the mesh's coordinates; delta is at least 4.25 u' of the sum as computed.
HULLS = "src/query/convex/posed_hulls.cpp"
of_height = constant(HULLS, r"margin = ([\d.]+) \* \(error \* body.size")
of_delta = constant(HULLS, r"delta_, ([\d.]+) \* two_u \* sum_max")
R = [vector(f"r{i}") for i in range(3)]
n, p = vector("n"), vector("p")
height = dot([dot([R[i][k] for i in range(3)], n) for k in range(3)], p)
S = [dot(R[i], p) for i in range(3)]
D = [(S[i] * of_delta).scaled(U) + 0 for i in range(3)]
least = sum((n[i] * D[i] for i in range(1, 3)), n[0] * D[0]) * of_height
twice = 2 * height.error({}) + U * height.upper({}) + U * least.upper({})
claim(twice <= least.lower({}), "heights of vertices")
claim(of_height * (1 - U) ** 4 >= 3, "the error of n times a size")

# rounded_bounds.hpp
DEPTH = "src/query/depth/rounded_bounds.hpp"
slack = number(DEPTH, r"slack = 1 \+ (0x1p-\d+)")
of_delta = constant(DEPTH, r"e_x\(slack \* \((\d+) \* delta")
of_E = constant(DEPTH, r"delta \+ (\d+) \* two_u \* E\)\)")
of_product = constant(DEPTH, r"slack \* \(([\d.]+) \* two_u \* \(X \* Y\)")
of_errors = constant(DEPTH, r"\(X \* Y\) \+ (\d+) \* e_x")
of_n = constant(DEPTH, r"slack \* \((\d+) \* e_n \* E")
of_m = constant(DEPTH, r"n_sum \* \((\d+) \* delta")
of_rounding = constant(DEPTH, r"delta \+ ([\d.]+) \* two_u \* E\)")


def rounded(name):
    return Form(exact(name).terms)._rounded(exact(name).terms)


edge = rounded("E") - rounded("E")
e_x = (exact("d") * of_delta + (exact("E") * of_E).scaled(U)) * (1 + slack)
claim(edge.error({}) + Poly.of("d") * 4 <= e_x.lower({}), "e_x")
sizes = {f"{x}{k}": Poly.of(x.upper()) for x in "xy" for k in range(3)}
sizes |= {f"~{x}{k}": Poly.of("e") for x in "xy" for k in range(3)}
normal = cross(vector("x"), vector("y"))[0].error(sizes) + cross(vector("x", 0, given), vector("y", 0, given))[0].error(
    sizes)
X, Y, e = exact("X"), exact("Y"), exact("e")
bound = (((X * Y) * of_product).scaled(U) + (e * of_errors) * ((X + Y) + e)) * (1 + slack)
claim(normal <= bound.lower({}), "of_normal")
m = [rounded(f"m{k}") for k in range(3)]
sizes = {f"m{k}": Poly.of("E") for k in range(3)}
height = dot(vector("n"), m).error(sizes) + Poly.of("en") * "E" * 3 + (Poly.of("n0") + "n1" + "n2") * "d" * 2
n_sum = (exact("n0") + exact("n1")) + exact("n2")
bound = ((exact("en") * of_n) * exact("E") + n_sum * (exact("d") * of_m + (exact("E") * of_rounding).scaled(U))) * (
    1 + slack)
claim(height <= bound.lower({}), "of_height")
# of_reach, in units of delta |n|: the highest vertex 3, its point 1, the product 3.1 / 4.25; both solids; and the sum.
of_reach = constant(DEPTH, r"return (\d+) \* delta \* n_sum")
claim(2 * (3 + 1 + Q(31, 10) / Q(425, 100)) + 1 <= of_reach * (1 - U) ** 4, "of_reach")
end()
