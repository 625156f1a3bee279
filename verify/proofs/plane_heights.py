"""Heights of points and boxes above the plane of a posed half space, and lengths of its normal.

Proved for src/query/half_space/heights.hpp: the bounds as computed cover the errors of the polynomials as computed, for
all magnitudes of poses, normals, offsets and points; boxes of a tree reach to 1 + 2^-20 at most."""
from rounding import *

SOURCE = "src/query/half_space/heights.cpp"
of_point = constant(SOURCE, r"error = (\d+) \* two_u \* \(dot\(M_size_")
of_box = constant(SOURCE, r"\? (\d+) \* two_u \* size \+ underflow")
of_length = constant(SOURCE, r"error = (\d+) \* two_u \* \(length")

columns = [vector(name) for name in ("R", "S", "T")]
n, v, body = vector("n"), vector("v"), [vector(name) for name in ("A", "B", "C")]
start, end_ = vector("t"), vector("q")


def plane(minus, product):
    """N and E, with differences, or with sums of magnitudes in their place."""
    pairs = (columns[1], columns[2]), (columns[2], columns[0]), (columns[0], columns[1])
    C = [product(x, y) for x, y in pairs]
    N = [(C[0][k] * n[0] + C[1][k] * n[1]) + C[2][k] * n[2] for k in range(3)]
    E = dot(columns[0], C[0]) * exact("d")
    offset = [minus(end_[k], start[k]) for k in range(3)]
    return N, [dot(N, column) for column in body], minus(dot(N, offset), E)


def plus(x, y):
    return x + y


N, M, c = plane(lambda x, y: x - y, cross)


def cross_size(x, y):
    return [x[1] * y[2] + x[2] * y[1], x[2] * y[0] + x[0] * y[2], x[0] * y[1] + x[1] * y[0]]


def magnitudes(minus):
    """The same in magnitudes; a difference of translations is taken as it was rounded, so its size has one rounding."""
    return plane(minus, cross_size)


N_size, M_size, c_size = magnitudes(plus)
h = dot(M, v) + c
bound = (dot(M_size, v) + c_size) * exact("one")
scale = {"one": Poly.of(of_point * U)}
# In the code the size of a difference is |q - t| as computed, which may be less than |q| + |t|: the two letters of a
# difference are one then.
one_offset = {f"t{k}": Poly.of(0) for k in range(3)}
error = h.error(one_offset) + (h.upper(one_offset) + bound.upper(scale | one_offset)) * U
claim(error <= bound.lower(scale | one_offset), "the height of a point")

# Boxes: P = M map, q = M . center + c, and both ends of a box along each axis.
mapping = [vector(name) for name in ("F", "G", "H")]
center, x, half = vector("m"), vector("x"), vector("w")
P = [dot(M, column) for column in mapping]
P_size = [dot(M_size, column) for column in mapping]
low = ((dot(P, x) + (dot(M, center) + c))) + dot(P, half)
size = dot(M_size, center) + c_size
for k in range(3):
    size = size + P_size[k].scaled(2)
reach = Poly.of(1 + Q(1, 2**20))
sizes = one_offset | {f"x{k}": reach for k in range(3)} | {f"w{k}": Poly.of(1) * Q(1) for k in range(3)}
error = low.error(sizes) + low.upper(sizes) * (2 * U)
claim(error <= size.lower(sizes) * (of_box * U * (1 - U) ** 2), "the heights of a box")

# |N| d: letters L for the computed normal's length, S for that of its sizes.
length = (Factor() * Factor() + Factor() * Factor() + Factor() * Factor()).root()
of_N = N[0].error({})
claim(of_N <= N_size[0].lower({}) * ((1 + U) ** 5 * Q(1) - 1 + U) * Q(11, 10), "the error of a normal")
spread = ((1 + U) ** 5 - 1 + U) * Q(11, 10)
# The length as computed, times d, and the sum with the bound: two more roundings.
of_L = length.high * (1 + U) ** 2 - 1
most = of_length * U * (1 + U) ** 4 * length.high
least = of_length * U * (1 - U) ** 4 * length.low
claim(of_L + U * most <= least, "the part of the length")
claim(spread * (1 + U) + U * most <= least, "the part of the sizes")
end()
