"""For check.py: the vectors of triangles, and when ranges along a vector are apart, as README.md defines them."""
from itertools import product

from reading import ZERO

UNITS = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def minus(p, q):
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def cross(p, q):
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]


def bits(n):
    return max(map(abs, n)).bit_length()


# Units of work of so many products of numbers of this size in bits.
def effort(size, count=1):
    return count * (10 + (size >> 9) ** 2)


# The part of w that is normal to e, e.e times.
def off(w, e):
    along, length = dot(w, e), dot(e, e)
    return tuple(length * x - along * y for x, y in zip(w, e))


def edge(corners, i):
    return minus(corners[(i + 1) % 3], corners[i])


def normal(corners):
    return cross(edge(corners, 0), edge(corners, 1))


def span(n, points):
    values = [dot(n, point) for point in points]
    return min(values), max(values)


# The vectors that two triangles p and q have, by name.
FORMULAS = {
    "na": lambda p, q: normal(p),
    "nb": lambda p, q: normal(q),
    "x": lambda p, q, i, j: cross(edge(p, i), edge(q, j)),
    "ea": lambda p, q, i, c: cross(edge(p, i), UNITS[c]),
    "eb": lambda p, q, j, c: cross(edge(q, j), UNITS[c]),
    "c": lambda p, q, c: UNITS[c],
    "vv": lambda p, q, i, j: minus(q[j], p[i]),
    "va": lambda p, q, i, j: off(minus(p[i], q[j]), edge(q, j)),
    "vb": lambda p, q, i, j: off(minus(q[i], p[j]), edge(p, j)),
}
INDICES = {name: formula.__code__.co_argcount - 2 for name, formula in FORMULAS.items()}


# Whether two triangles are apart along one of the 32 vectors that suffice.
def is_apart_by_any(rule, p, q):
    vectors = (FORMULAS[name](p, q, *indices) for name in ("na", "nb", "c", "ea", "eb", "x") for indices in product(range(3), repeat=INDICES[name]))
    return any(any(n) and rule(n, span(n, p), span(n, q)) for n in vectors)


# Whether ranges along n are apart: the gap is positive and more than `least` times the length of n, or (not is_more) that.
class Apart:
    def __init__(self, fine, least=ZERO, is_more=True):
        self.is_more, self.left, self.right = is_more, 2 * least[1], least[0] ** 2 << 2 * fine
        self.bits = self.right.bit_length() // 2

    def __call__(self, n, a, b):
        gap = max(b[0] - a[1], a[0] - b[1])
        left, right = gap * gap << self.left, self.right * dot(n, n)
        return gap > 0 and (left > right or left == right and not self.is_more)

    # The least gap in doubles, in units of 2^unit. No gap reaches 8, so that 16 is as good as more.
    def floor(self, n, unit):
        square, power = self.right * dot(n, n), self.left + 2 * unit
        return (square / (1 << power)) ** 0.5 if square >> power < 256 else 16.0


# Whether they do not overlap; touching is allowed.
class Weak(Apart):
    def __call__(self, n, a, b):
        return max(b[0] - a[1], a[0] - b[1]) >= 0


# Whether a is apart from a piece of a segment: its start is strictly on one side, its stop too, or (not is_more) level with a.
class Ahead(Apart):
    def __init__(self, fine, piece, is_more):
        super().__init__(fine, ZERO, is_more)
        self.piece = piece

    def __call__(self, n, a, b):
        start, (low, high) = dot(n, self.piece[0]), b
        return high < a[0] or low > a[1] or not self.is_more and (start < a[0] and high <= a[0] or start > a[1] and low >= a[1])
