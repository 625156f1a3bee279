"""Margins of posed boxes on axes, in doubles: src/bvh/axes/posed_axes_text.hpp (separating_axes.hpp has the derivation)
and src/query/certificate/body_axis.hpp, for any vector n, pose and frame; and of rays, src/bvh/masks/ray_mask.cpp.

Proved, with the sums of magnitudes as computed: the projection of a box differs from the true one by less than the
margin; also along products of edges, where n' is a vector in the coordinates of the axes; also if P is taken for the
identity."""
from rounding import *

AXES, BODY = "src/bvh/axes/posed_axes_text.hpp", "src/query/certificate/body_axis.cpp"
of_axes = constant(AXES, r"margin = \((\d+) \* two_u \* \(s \+ w\)")
of_e = constant(AXES, r"two_u \* \(s \+ w\) \+ (\d+) \* e\)")
of_body = constant(BODY, r"axis.error = (\d+) \* two_u \* w")
of_ray = constant("src/bvh/masks/ray_mask.cpp", r"margin = (\d+) \* two_u \* sum \+ 2 \* error")
y_max = 1 + Q(1, 2**22)
n = vector("n")


class Tree:
    """A tree's map, its origin and the sums of their magnitudes, by rows of the world."""

    def __init__(self, body):
        R = [vector(f"{body}R{i}") for i in range(3)]
        map_ = [vector(f"{body}m{j}") for j in range(3)]
        center = vector(f"{body}c")
        self.edges = [[dot(R[i], [map_[j][k] for j in range(3)]) for k in range(3)] for i in range(3)]
        self.origin = [dot(R[i], center) for i in range(3)]
        self.size = [dot(R[i], [(map_[j][0] + map_[j][1]) + map_[j][2] for j in range(3)]) for i in range(3)]
        self.origin_size = self.origin
        self.P = [dot([self.edges[i][k] for i in range(3)], n) for k in range(3)]
        self.center, self.half = vector(f"{body}y"), vector(f"{body}h")
        self.middle, self.reach = dot(self.P, self.center), dot(self.P, self.half)


a, b = Tree("a"), Tree("b")
sizes = {f"{t}{x}{k}": Poly.of(y_max) for t in "ab" for x in "yh" for k in range(3)}
d = [Form(exact(f"d{i}").terms)._rounded(exact(f"d{i}").terms) for i in range(3)]

# Two trees on an axis: |middle_a - middle_b - q| > reach_a + reach_b + margin.
q = dot(n, [(b.origin[i] - a.origin[i]) + d[i] for i in range(3)])
distance, reach = (a.middle - b.middle) - q, a.reach + b.reach
world = [((a.size[i] + b.size[i]) + (a.origin_size[i] + b.origin_size[i])) + d[i] for i in range(3)]
margin = (dot(n, world) * of_axes).scaled(U)
off = distance.error(sizes) + reach.error(sizes) + reach.upper(sizes) * U
claim(off <= margin.lower({}) * ((1 - U) ** 3), "the margin of a row, which s makes larger still")
# P taken for the identity: e is at most 2^-40, and |P| at least 1 - 2^-40, so w > 1/2. e as computed has four roundings.
spare = of_axes * U * Q(1, 2) - 24 * U * Q(1, 2)
claim(2 * y_max * Q(1, 2**40) / (1 - U) ** 4 <= of_e * Q(1, 2**40) * (1 - U) + spare, "P taken for the identity")

# Products of edges: n' in the coordinates of the axes, row k of P off by 6.1 u' w_k, and q by 8.2 u' w_k.
rows = [[given(f"{t}P{k}{j}") for j in range(3)] for t in "ab" for k in range(3)]
e = vector("e")
columns = [[dot(e, [rows[3 * t + k][j] for k in range(3)]) for j in range(3)] for t in (0, 1)]
y = [vector("ay"), vector("by")]
h = [vector("ah"), vector("bh")]
q = dot(e, vector("q", U, given))
distance = (dot(columns[0], y[0]) - dot(columns[1], y[1])) - q
reach = dot(columns[0], h[0]) + dot(columns[1], h[1])
edge_sizes = dict(sizes)
for k in range(3):
    edge_sizes |= {f"~{t}P{k}{j}": Poly.of(f"w{t}{k}") * (Q(61, 10) * U if j == 0 else 0) for t in "ab" for j in range(3)}
    edge_sizes |= {f"~q{k}": Poly.of(f"wd{k}") * (Q(82, 10) * U)}
s_and_w = [(((rows[k][0] + rows[k][1]) + rows[k][2]) + ((rows[3 + k][0] + rows[3 + k][1]) + rows[3 + k][2])) +
           exact(f"q{k}") for k in range(3)]
s_and_w = [Form({m: c for m, c in x.terms.items() if not any(l.startswith("~") for l in m[0])}) for x in s_and_w]
margin = (dot(e, [s_and_w[k] + ((exact(f"wa{k}") + exact(f"wb{k}")) + exact(f"wd{k}")) for k in range(3)]) *
          of_axes).scaled(U)
off = distance.error(edge_sizes) + reach.error(edge_sizes) + reach.upper(edge_sizes) * U
claim(off <= margin.lower({}) * (1 - U) ** 12, "the margin of a product of edges")

# One body: p . y + q with q = n . (R center + d).
origin = [a.origin[i] + d[i] for i in range(3)]
part = (a.middle + dot(n, origin)) + a.reach
w = dot(n, a.size) + dot(n, origin)
claim(part.error(sizes) <= (w * of_body).scaled(U).lower({}), "the error of a body's axis")

# Rays: rows g . y + shift, with the ray's beginning d off by u' of itself and by `error` more.
part = (dot(n, origin) + a.middle) + a.reach
sum_ = dot(n, origin) + ((dot(n, [a.edges[i][0] for i in range(3)]) + dot(n, [a.edges[i][1] for i in range(3)])) +
                         dot(n, [a.edges[i][2] for i in range(3)]))
exact_row = dot(n, origin).error(sizes) + sum((a.P[k].error(sizes) * (2 * y_max) for k in range(3)), Poly())
claim(exact_row <= (sum_ * of_ray).scaled(U).lower({}), "the margin of a ray's row")
end()
