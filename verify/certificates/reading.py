"""Reading for check.py: numbers and mesh files, as README.md defines them. Nothing is decided here."""
import gc
import hashlib
import math

gc.set_threshold(100_000, 20, 100)  # what is read stays, and most else goes without it

SIZE_MAX = 64  # children of a node, triangles of a leaf
DEPTH_MAX = 200
INFINITY = math.inf
ZERO, ONE = (0, 0), (1, 0)  # real numbers: (n, power) is n 2^-power


class Unreadable(Exception):
    """A mesh file that is malformed."""


# What numbers look like once 0x0 and 0x1 are replaced by X, and each further digit by 0.
SHAPES = {
    sign + "X" + fraction + "p" + plus + "0" * exponent
    for sign in ("", "-")
    for fraction in ["", *("." + "0" * count for count in range(1, 14))]
    for plus in "+-"
    for exponent in range(1, 5)
}
ANY_DIGIT = str.maketrans("123456789abcdef", "0" * 15)


def is_double(word, value):
    """Whether a number of the right shape, whose nearest double is below the least normal one, is that double exactly."""
    significand, exponent = word.removeprefix("-")[2:].split("p")
    whole, _, fraction = significand.partition(".")
    power = int(exponent) - 4 * len(fraction)
    numerator, denominator = abs(value).as_integer_ratio()
    return int(whole + fraction, 16) * denominator << max(power, 0) == numerator << max(-power, 0)


def scaled(values):
    """Doubles as integers, and the power p: they are in units of 2^-p."""
    ratios = [value.as_integer_ratio() for value in values]
    power = max(denominator for _, denominator in ratios).bit_length() - 1
    return [numerator << power + 1 - denominator.bit_length() for numerator, denominator in ratios], power


def to_double(x, power):
    """x 2^power, rounded to a double."""
    return (x << max(power, 0)) / (1 << max(-power, 0))


def exactly(value):
    (n,), power = scaled([value])
    return n, power


def middle(low, high):
    """The midpoint of adjacent doubles, like `exactly`; 2^1024 follows the largest."""
    (x, y), power = scaled((low, min(high, 2.0**1023)))
    return x + (y if high < math.inf else 2 * y), power + 1


def below(value):
    """The least real number that may round to a positive double, or to infinity."""
    return ZERO if value == 2.0**-1074 else middle(math.nextafter(value, 0), value)


def above(value):
    """The greatest such number."""
    return middle(value, math.nextafter(value, math.inf))


def is_odd(value):
    """Whether the last bit of a double's significand is 1."""
    return 0 < value < math.inf and int(value / math.ulp(value)) % 2 == 1


def numbers(words):
    """The doubles that words say, or None if one of them is not a number."""
    text = " ".join(words)
    shapes = text.replace("0x1", "X").replace("0x0", "X").translate(ANY_DIGIT).split(" ")
    if not set(shapes) <= SHAPES:
        return None
    try:
        values = list(map(float.fromhex, words))
    except (ValueError, OverflowError):
        return None
    small = {word for word, value in zip(words, values) if -(2.0**-1022) < value < 2.0**-1022}
    return values if all(is_double(word, float.fromhex(word)) for word in small) else None


COUNTS = {str(number): number for number in range(4096)}


def counts(words):
    """The counts that words say, or None if one of them is not a count."""
    if len(words) < 8192 and None not in (values := list(map(COUNTS.get, words))):
        return values
    text = "  ".join(words)
    if not text.isascii() or not text.replace(" ", "").isdecimal() or "" in words:
        return None
    text = f" {text} "
    if text.count(" 0") != text.count(" 0 ") or max(map(len, words)) > 10:
        return None
    values = list(map(int, words))
    return values if max(values) < 2**32 else None


class Kept(dict):
    """The results of a function of one argument."""

    def __init__(self, function):
        super().__init__()
        self.function = function

    def __missing__(self, argument):
        self[argument] = result = self.function(argument)
        return result


NO_SEPARATORS = bytes(set(range(256)) - set(b" \n"))


class Mesh:
    """A mesh and its tree. Parts: node i of the tree is part i, the triangle in line k is part node_count + k."""

    def __init__(self, data):
        self.digest = hashlib.sha256(data).hexdigest()
        lines = data.decode("latin-1").split("\n")
        if lines.pop() != "":
            raise Unreadable("the last line does not end")
        if len(lines) < 2 or lines[0] != "ecods-mesh 1":
            raise Unreadable("its first line is not ecods-mesh 1")
        head = lines[1].split(" ")
        sizes = counts(head[1::2])
        if len(head) != 6 or head[::2] != ["vertices", "triangles", "nodes"] or not sizes or min(sizes[1:]) == 0:
            raise Unreadable("line 2 does not give the counts")
        vertex_count, triangle_count, node_count = sizes
        if len(lines) != 2 + sum(sizes):
            raise Unreadable("it has not as many lines as its counts say")
        separators = data.translate(None, NO_SEPARATORS)
        rows = b"  \n" * vertex_count + b"   \n" * triangle_count + b" \n" * node_count
        if separators != b" \n     \n" + rows:
            raise Unreadable("a line has not as many fields as it should")
        first_triangle = 2 + vertex_count
        first_node = first_triangle + triangle_count
        self.read_vertices(lines[2:first_triangle])
        self.read_triangles(lines[first_triangle:first_node], vertex_count)
        self.read_tree(lines[first_node:])
        self.parts_points, self.boxes, self.leaf_places = {}, Kept(self.boxes_of), {}

    def read_vertices(self, lines):
        values = numbers(" ".join(lines).split(" ")) if lines else []
        if values is None:
            raise Unreadable("a coordinate is not a number")
        # Doubles are integers of 2^-fine, the last place of the least; the divided ones are at most 1, or 2 where 2^1024 would be needed.
        sizes = list(map(abs, values))
        self.fine = max(0, 1 - math.frexp(math.ulp(min(filter(None, sizes), default=1.0)))[1])
        largest = max(sizes, default=0)
        self.scale = min(max(math.frexp(largest)[1], -1022), 1023)
        unit = 2.0**self.scale
        divided = [value / unit for value in values]
        self.vertices = list(zip(values[::3], values[1::3], values[2::3]))
        self.divided = list(zip(divided[::3], divided[1::3], divided[2::3]))

    def read_triangles(self, lines, vertex_count):
        values = counts(" ".join(lines).split(" "))
        if values is None:
            raise Unreadable("a triangle's line has a field that is not a count")
        self.corners = list(zip(values[::4], values[1::4], values[2::4]))
        names = values[3::4]
        if max(max(values[k::4]) for k in range(3)) >= vertex_count:
            raise Unreadable("a triangle has a corner that is not a vertex")
        self.line_of = dict(zip(names, range(len(names))))
        if len(self.line_of) != len(names) or max(names) >= len(names):
            raise Unreadable("the triangles' numbers are not a permutation")

    def read_tree(self, lines):
        self.node_count = len(lines)
        self.children, self.first, self.last = [], [], [0] * len(lines)
        sizes = counts([line[2:] for line in lines]) if {line[:2] for line in lines} <= {"n ", "l "} else None
        if sizes is None or not all(1 <= size <= SIZE_MAX for size in sizes):
            raise Unreadable("a line of the tree is neither a node nor a leaf")
        above, at = [], 0  # the nodes that the next one is in, each with how many children it still lacks
        for node, size in enumerate(sizes):
            if above:
                self.children[above[-1][0]].append(node)
                above[-1][1] -= 1
            elif node > 0:
                raise Unreadable("the tree ends before its lines do")
            if len(above) > DEPTH_MAX:
                raise Unreadable("the tree is too deep")
            self.first.append(at)
            self.children.append([])
            if lines[node][0] == "n":
                above.append([node, size])
                continue
            self.children[node] = range(self.node_count + at, self.node_count + at + size)
            at += size
            self.last[node] = at
            while above and above[-1][1] == 0:
                self.last[above.pop()[0]] = at
        if above or at != len(self.corners):
            raise Unreadable("the tree has not all its nodes and triangles")

    def is_triangle(self, part):
        return part >= self.node_count

    def size(self, part):
        """How many triangles a part has."""
        return 1 if self.is_triangle(part) else self.last[part] - self.first[part]

    def parts(self, part):
        return [part] if self.is_triangle(part) else self.children[part]

    def points(self, part):
        """The vertices of a part's triangles, and their divided coordinates."""
        if part not in self.parts_points:
            if self.is_triangle(part):
                used = self.corners[part - self.node_count]
            else:
                used = list(set().union(*self.corners[self.first[part] : self.last[part]]))
            self.parts_points[part] = used, [self.divided[vertex] for vertex in used]
        return self.parts_points[part]

    def is_leaf(self, part):
        return not self.is_triangle(part) and self.children[part][0] >= self.node_count

    def boxes_of(self, of):
        """Of the parts of a node, or of a part itself: the least box around its points, its least and its greatest corner, six numbers."""
        part, is_opened = of
        if is_opened:
            return [self.boxes[child, False][0] for child in self.children[part]]
        corners = self.corners[self.first[part] : self.last[part]]
        vertices = [vertex for corner in corners for vertex in corner] if len(corners) <= SIZE_MAX else set().union(*corners)
        columns = list(zip(*[self.divided[vertex] for vertex in vertices]))
        return [(*map(min, columns), *map(max, columns))]

    def places(self, leaf):
        """Of each triangle of a leaf, which three of the leaf's points are its corners."""
        if leaf not in self.leaf_places:
            at = {vertex: number for number, vertex in enumerate(self.points(leaf)[0])}
            triangles = self.corners[self.first[leaf] : self.last[leaf]]
            self.leaf_places[leaf] = [(at[i], at[j], at[k]) for i, j, k in triangles]
        return self.leaf_places[leaf]

    def integers(self, vertex):
        """The coordinates of a vertex, in units of 2^-fine."""
        values, power = scaled(self.vertices[vertex])
        return [value << self.fine - power for value in values]


class Segment(Mesh):
    """The piece of a segment between two parameters, as a mesh of one triangle: start, stop, stop."""

    def __init__(self, ends, start, stop):
        values, power = scaled(ends)
        way, more = [y - x for x, y in zip(values[:3], values[3:])], max(start[1], stop[1])
        self.exact = [[(x << more) + (y * s << more - p) for x, y in zip(values, way)] for s, p in (start, stop)]
        self.fine, self.scale = power + more, max(map(abs, self.exact[0] + self.exact[1])).bit_length() - power - more
        self.divided = [[to_double(x, -self.fine - self.scale) for x in point] for point in self.exact]
        self.node_count, self.corners, self.line_of, self.parts_points = 0, [(0, 1, 1)], {0: 0}, {}

    def integers(self, vertex):
        return self.exact[vertex]
