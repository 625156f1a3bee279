"""The enclosure of a hit, src/query/hit/triangle_hits.cpp: weights, the normal, and numerator and denominator.

Proved: the weights, n.d and n.p as computed are off by less than the bounds as computed, for corners that are off by
delta and a direction that is off by d_error. Numerator and denominator both have the error of the TRUE normal, so the
upper end is the true hit's. delta is at least 4 u' of each coordinate, and the longest coordinate of d at least one."""
from rounding import *

SOURCE = "src/query/hit/triangle_hits.cpp"
slack = number(SOURCE, r"slack = 1 \+ (0x1p-\d+)")
of_EE = constant(SOURCE, r"each = \((\d+) \* two_u \* EE")
of_sums = constant(SOURCE, r"EE \+ \(([\d.]+) \* delta\) \* sums\(E\)")
of_square = constant(SOURCE, r"sums\(E\)\) \+ (\d+) \* delta_square")
of_direction = constant(SOURCE, r"d_size \+ ([\d.]+) \* EE \* d_error")
of_SS = constant(SOURCE, r"B = \(([\d.]+) \* two_u \* products\(S\)")
of_S = constant(SOURCE, r"products\(S\) \+ \(([\d.]+) \* delta\) \* sums\(S\)")
of_delta = constant(SOURCE, r"sums\(S\)\) \+ ([\d.]+) \* delta_square")
of_n = constant(SOURCE, r"of_n = B \+ ([\d.]+) \* two_u \* n_size")

# Weights. ~d_k is at most f_k = u' |d_k| (1 + 2 u') + g_k, g_k <= 2^-119, as scaled_line.cpp sets d_error.
f = [Poly.of(f"d{k}") * (U * (1 - U)) + f"g{k}" for k in range(3)]
sizes = {f"{x}{k}": Poly.of(f"E{k}") for x in "pq" for k in range(3)} | {f"~d{k}": f[k] for k in range(3)}
sizes |= {f"~{x}{k}": Poly.of("c") for x in "pq" for k in range(3)}


def weight(u, of):
    return dot(cross(vector("p", u, of), vector("q", u, of)), vector("d", u, of))


off = weight(U, exact).error(sizes) + weight(0, given).error(sizes)
small = Poly({m: x for m, x in off.terms.items() if "c" in m and any(l[0] == "g" for l in m)})
off = Poly({m: x for m, x in off.terms.items() if m not in small.terms})
E = [exact(f"E{k}") for k in range(3)]
c, bound = exact("c"), None
for k in range(3):
    i, j = (k + 1) % 3, (k + 2) % 3
    EE = E[i] * E[j]
    each = ((EE * of_EE).scaled(U) + (c * of_sums) * (E[i] + E[j])) + (c * c).scaled(of_square)
    d_error = exact(f"d{k}").scaled(U) * (1 - U) + exact(f"g{k}")
    term = each * exact(f"d{k}") + (EE * of_direction) * d_error
    bound = term if bound is None else bound + term
claim(off <= (bound * (1 + slack / 2)).lower({}), "the bound of a weight")
# Terms with delta and g are less than the other half of the slack of 2 delta^2 |d|: E <= delta / (4 u'), |d| >= 1.
most = small.number(**{f"E{k}": 1 / (4 * U) for k in range(3)}, c=Q(1), **{f"g{k}": Q(1, 2**119) for k in range(3)})
claim(most <= slack / 2 * of_square * (1 - U) ** 10, "delta times the error of d")

# The normal: differences as computed are at most S, and off by u' S + 2 delta.
e = [Poly.of(f"S{k}") * (U / (1 - U)) + Poly.of("c") * 2 for k in range(3)]
sizes = {f"{x}{k}": Poly.of(f"S{k}") for x in "uv" for k in range(3)} | {f"~{x}{k}": e[k] for x in "uv" for k in range(3)}
normal = cross(vector("u"), vector("v"))[2].error(sizes) + cross(vector("u", 0, given), vector("v", 0, given))[2].error(
    sizes)
S0, S1 = exact("S0"), exact("S1")
B = ((S0 * S1 * of_SS).scaled(U) + (c * of_S) * (S0 + S1)) + (c * c) * of_delta
claim(normal <= (B * (1 + slack)).lower({}), "the bound of a normal")

# n . x, for x = d or p, off by b (d_error or delta) on each axis, n off by B.
sizes = {f"~n{k}": Poly.of(f"B{k}") for k in range(3)} | {f"~x{k}": Poly.of(f"b{k}") for k in range(3)}
product = dot(vector("n"), vector("x")).error(sizes) + dot(vector("n", 0, given), vector("x", 0, given)).error(sizes)
terms = []
for k in range(3):
    n, x, b = exact(f"n{k}"), exact(f"x{k}"), exact(f"b{k}")
    terms.append((exact(f"B{k}") + (n * of_n).scaled(U)) * (x + b) + n * b)
bound = ((terms[0] + terms[1]) + terms[2]) * (1 + slack)
claim(product <= bound.lower({}), "the bound of n.d and n.p")

# The quotient: two sums and a division, with a factor.
down, up = constant(SOURCE, r"down = 1 - (0x1p-\d+)"), constant(SOURCE, r"up = 1 \+ (0x1p-\d+)")
claim((1 + U) ** 3 / (1 - U) * (1 - down) <= 1 and (1 - U) ** 3 / (1 + U) * (1 + up) >= 1, "the quotient")
end()
