"""A point and the triangles of a leaf, in floats: src/bvh/walks/walk_point_text.hpp.

Proved for any n: a corner off by E, products n . c of coordinates up to M, the margin and its own roundings leave a
lower bound of n . y over the triangle; its square over n . n, times the factor, is one of the squared distance; and the
nearest point as computed is off by less than distance_above() adds."""
from rounding import *

TEXT = "src/bvh/walks/walk_point_text.hpp"
of_error = constant(TEXT, r"sum \* \((\d+) \* error \+ \d+ \* 0x1p-23f \* size\)")
of_size = constant(TEXT, r"sum \* \(\d+ \* error \+ (\d+) \* 0x1p-23f \* size\)")

n, c = vector("n", V), vector("c", V, given)
product = dot(n, c)
sizes = {f"c{k}": Poly.of("M") for k in range(3)} | {f"~c{k}": Poly.of("E") for k in range(3)}
length = (n[0] + n[1]) + n[2]  # the n_k stand for their magnitudes
margin = length * (exact("E", V).scaled(of_error) + exact("M", V) * (of_size * V))
off = product.error(sizes) + (product.upper(sizes) + margin.upper({})) * V
claim(off <= margin.lower({}), "a lower bound of n . y")

# gap * (gap / n.n) * square, and n.n as computed: three roundings each.
slack = constant("src/bvh/axes/distance_axes_text.hpp", r"even\.factor \* \(1 - (0x1p-\d+)\)")
claim((1 + V) ** 3 * (1 - slack) <= (1 - V) ** 3, "the square of the gap")

# The nearest point of an edge or a face is off by E and 2.4 E as small_bounds.py proves, and by E of its corners.
nine = constant("src/bvh/axes/distance_axes.cpp", r"error = (\d+) \* static_cast<double>")
claim(root_above(3) * max(1 + 1, Q(24, 10) + 1) <= nine - 1, "the nearest point")
end()
