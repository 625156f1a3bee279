"""Small certificates made by hand, with the verdicts that they must get, and meshes that are malformed: for cases.py."""
import hashlib


def numbers(values):
    return " ".join(float(x).hex() for x in values)


def pose(x=0.0, y=0.0, z=0.0):
    return numbers([1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z])


def scaled(factor):
    return numbers([factor, 0, 0, 0, 0, factor, 0, 0, 0, 0, factor, 0])


def mesh(vertices, triangles, tree):
    lines = ["ecods-mesh 1", f"vertices {len(vertices)} triangles {len(triangles)} nodes {len(tree)}"]
    lines += [numbers(v) for v in vertices] + [" ".join(map(str, t)) for t in triangles] + tree
    return "".join(line + "\n" for line in lines)


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()


def linear_digest(text):
    """What format 1 called a digest."""
    return f"{int.from_bytes(text.encode(), 'big') % (2**128 - 159):032x}"


# One triangle in z = 0; a square in z = 0, its triangles in turned order, below a root; a needle; a point.
TRIANGLE = mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2, 0)], ["l 1"])
SQUARE = mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 2, 3, 1), (0, 1, 2, 0)], ["n 2", "l 1", "l 1"])
NEEDLE = mesh([(0.25, 0.25, 0), (0.25, 0.25, 1)], [(0, 1, 1, 0)], ["l 1"])
POINT = mesh([(0.25, 0.25, 0)], [(0, 0, 0, 0)], ["l 1"])
WALL = mesh([(0, 0, -1), (0, 0, 1), (0, 1, 0)], [(0, 1, 2, 0)], ["l 1"])
DEEP = mesh([(0, 10, 0), (1, 10, 0), (0, 11, 0)], [(0, 1, 2, 0)], ["n 1", "l 1"])
TWO = mesh([(5, 10, 0), (6, 10, 0), (5, 11, 0), (0, 10, 0), (1, 10, 0), (0, 11, 0)], [(0, 1, 2, 0), (3, 4, 5, 1)], ["n 2", "l 1", "l 1"])
# Two meshes with one digest in format 1: byte p + 16 of a file, counted from its end, weighed 159 times as much as byte p.
DIGITS = mesh([(0, 0, 0)], [(0, 0, 0, 0)], ["l 1"]).replace("0x0.0p+0 0x0.0p+0", "0x1.0000000000000p+0 0x1.0050000000000p+0", 1)
TWIN = DIGITS.replace("0x1.0000000000000p+0 0x1.0050000000000p+0", "0x1.0000000080000p+0 0x1.0008000000000p+0")
MESHES = {"digits": DIGITS, "deep": DEEP, "two": TWO, "triangle": TRIANGLE, "square": SQUARE, "needle": NEEDLE, "point": POINT, "wall": WALL}


def pair(a, pose_a, b, pose_b, *lines):
    head = ["ecods-certificate 2", f"a {digest(MESHES[a])} {pose_a}", f"b {digest(MESHES[b])} {pose_b}"]
    return "".join(line + "\n" for line in [*head, *lines, "end"])


def segment(a, pose_a, start, end, *lines):
    head = ["ecods-certificate 2", f"a {digest(MESHES[a])} {pose_a}", f"segment {numbers((*start, *end))}"]
    return "".join(line + "\n" for line in [*head, *lines, "end"])


TINY = 2.0**-1074
Z = "axis 0x0p+0 0x0p+0 0x1p+0"
Y = "axis 0x0p+0 0x1p+0 0x0p+0"
X = "axis 0x1p+0 0x0p+0 0x0p+0"


def above(gap, *lines, a="square"):
    return pair(a, pose(), "square", pose(z=gap), *lines)


def sqrt2_neighbors():
    root = 2**0.5
    return float(root).hex(), float(root - 2**-52).hex(), float(root + 2**-52).hex()


ROOT, BELOW_ROOT, ABOVE_ROOT = sqrt2_neighbors()


def diagonal(d):
    """Two triangles whose nearest corners are (1, 0, 0) and (2, 1, 0)."""
    return pair("triangle", pose(), "triangle", pose(2, 1, 0), f"claim distance {d} v 0 1 v 0 0",
                "axis 0x1p+0 0x1p+0 0x0p+0", "k 0")


def tie(ulps, d):
    """The distance is 1 + ulps 2^-53: odd ulps are ties between two doubles, of which the even one is right."""
    return pair("point", pose(-ulps * 2.0**-53), "point", pose(1), f"claim distance {d.hex()} v 0 0 v 0 0", X, "k 0")


def hit_tie(ulps, s):
    """The triangle is met at 1/2 + ulps 2^-54, likewise."""
    start = -3 * 2.0**-54 if ulps == 3 else -(2.0**-53)
    length = 0.5 if ulps == 3 else 1
    height = {1: 0.5 - 2.0**-54, 3: 0.25 - 3 * 2.0**-55}[ulps]
    return segment("square", pose(z=height), (0.5, 0.25, start), (0.5, 0.25, start + length),
                   f"claim hit {s.hex()} 0", Z, "k 0")


GOOD = [
    tie(1, 1.0),
    tie(3, 1 + 2.0**-51),
    tie(2, 1 + 2.0**-52),
    hit_tie(1, 0.5),
    hit_tie(3, 0.5 + 2.0**-52),
    above(1, "claim disjoint", Z, "k 0"),
    above(1, "claim disjoint", Z, "ab 0"),
    above(TINY, "claim disjoint", Z, "ab 0"),
    above(1, "claim disjoint", "axis na 1", "ab 0"),
    above(1, "claim disjoint", "axis nb 0", "ab 0"),
    above(1, "claim disjoint", "axis x 0 0 1 0", "a | 0 1", "b 0", "ab 0"),
    above(1, "claim disjoint", Z, "ab | 0 1 2 3", "k 0", "ab 0", "k 0", "k 0"),
    above(1, "claim disjoint", Z, "ab 0 | 1", "ab | 0", "t na"),
    above(1, "claim disjoint", Z, "ab 0 | 1", "b | 0", "a | 0", "t c 2"),
    above(1, "claim disjoint", X, Z, "ab 0 1 | 1", "ab | 0", "t ea 0 1"),
    above(0, "claim touching 0 1", Z, "k 0"),
    above(0, "claim touching 1 0", "axis na 0", "ab 0"),
    above(1, "claim distance 0x1p+0 v 0 0 v 0 0", Z, "k 0"),
    above(1, "claim distance 0x1p+0 f 0 v 0 0", Z, "ab 0"),
    above(1, "claim distance 0x1p+0 e 0 0 v 0 1", Z, "ab 0"),
    above(1, "claim distance 0x1p+0 e 0 0 e 0 1", "axis na 0", "ab 0"),
    above(TINY, "claim distance 0x1p-1074 v 0 0 v 0 0", Z, "k 0"),
    above(0, "claim distance 0x0p+0 0 0"),
    above(1, "claim within 0x1p+0 v 0 0 v 0 0"),
    above(1, "claim within inf v 0 0 v 1 0"),
    above(1, "claim within inf v 0 0 f 0"),
    above(1, "claim within inf v 0 0 e 1 2"),
    pair("triangle", pose(), "needle", pose(0, -2, -0.5), "claim within inf e 0 0 e 0 0"),
    pair("point", pose(-1.5 * 2.0**1023), "point", pose(1.5 * 2.0**1023), "claim within inf v 0 0 v 0 0"),
    above(0, "claim within 0x0p+0 0 1"),
    above(0, "claim within 0x0p+0 v 0 0 v 0 0"),
    above(1, "claim beyond 0x1.fffffffffffffp-1", Z, "k 0"),
    above(1, "claim beyond 0x0p+0", Z, "k 0"),
    pair("square", pose(), "needle", pose(x=0.25, z=-0.5), "claim crossing 0 0"),
    pair("square", pose(), "needle", pose(), "claim touching 0 0", Z, "k 0"),
    pair("square", pose(), "wall", pose(x=0.5), "claim crossing 0 0"),
    diagonal(ROOT),
    pair("point", pose(-(2.0**1023)), "point", pose(2.0**1023), "claim distance inf", X, "k 0"),
    pair("point", pose(-(2.0**1022)), "point", pose(2.0**1022), "claim distance 0x1p+1023 v 0 0 v 0 0", X, "k 0"),
    pair("triangle", pose(), "point", pose(z=3), "claim distance 0x1.8p+1 f 0 v 0 1", Z, "ab | 0", "t na"),
    pair("triangle", pose(), "point", pose(0.25, -1.25, 0), "claim distance 0x1p+0 e 0 0 v 0 0", "ab | 0", "t vb 0 0"),
    pair("point", pose(0.25, -1.25, 0), "triangle", pose(), "claim distance 0x1p+0 v 0 0 e 0 0", "ab | 0", "t va 0 0"),
    pair("point", pose(0.25, -1.25, 0), "point", pose(), "claim disjoint", "ab | 0", "t vv 1 2"),
    # A distance below the least double: 2^-1076 sqrt(2).
    pair("point", scaled(TINY), "point", scaled(0), f"claim distance {TINY.hex()} v 0 0 v 0 0", X, "k 0"),
    segment("square", pose(), (0.5, 0.25, 1), (0.5, 0.25, -1), "claim hit 0x1p-1 0", "axis na 0", "a 0"),
    segment("square", pose(), (0.5, 0.5, 1), (0.5, 0.5, -1), "claim hit 0x1p-1 1", "axis na 0", "ab 0"),
    segment("square", pose(), (0.5, 0.25, 0), (0.5, 0.25, -1), "claim hit 0x0p+0 0"),
    segment("square", pose(), (0.5, 0.25, 1), (0.5, 0.25, 0), "claim hit 0x1p+0 0", "axis na 0", "k 0"),
    segment("square", pose(), (0.5, 0.25, 1), (0.5, 0.25, -2), f"claim hit {(1 / 3).hex()} 0", "axis na 0", "k 0"),
    segment("square", pose(), (-1, 0.25, 0), (1, 0.25, 0), "claim hit 0x1p-1 1", X, "k 0"),
    segment("square", pose(), (0.5, 0.25, TINY), (0.5, 0.25, -1), "claim hit 0x1p-1074 0", "axis na 0", "k 0"),
    segment("square", pose(), (0.5, 0.25, 1), (0.5, 0.25, TINY), "claim miss", "axis na 0", "k 0"),
    segment("square", pose(), (2, 2, 0), (2, 2, 0), "claim miss", X, "k 0"),
]
BAD = [
    # A part's range along one axis is none along another: in x it is beside what lies where it is in y.
    pair("deep", pose(), "two", pose(), "claim disjoint", X, Y, "ab | 0 1", "ab 0", "ab 1"),
    # Only the first of b's parts is apart.
    pair("deep", pose(), "two", pose(), "claim disjoint", X, "ab 0"),
    tie(1, 1 + 2.0**-52),
    tie(3, 1 + 2.0**-52),
    tie(2, 1.0),
    hit_tie(1, 0.5 + 2.0**-53),
    hit_tie(3, 0.5 + 2.0**-53),
    above(1, "claim disjoint", X, "k 0"),
    above(0, "claim disjoint", Z, "k 0"),
    above(1, "claim disjoint"),
    above(1, "claim disjoint", Z),
    above(1, "claim disjoint", Z, "k 1"),
    above(1, "claim disjoint", "k 0", Z),
    above(1, "claim disjoint", Z, "k 0", "k 0"),
    above(1, "claim disjoint", Z, "ab 0 0"),
    above(1, "claim disjoint", Z, "ab 0 | 4", "k 0"),
    above(1, "claim disjoint", Z, "ab 0 | 4"),
    above(1, "claim disjoint", Z, "ab 0 | 1 1", "k 0", "k 0"),
    above(1, "claim disjoint", Z, "ab 0 | 1"),
    above(1, "claim disjoint", Z, "ab 0 |"),
    above(1, "claim disjoint", Z, "ab"),
    above(1, "claim disjoint", Z, "ab | 0 1 2"),
    above(1, "claim disjoint", Z, "k"),
    above(1, "claim disjoint", Z, "k 0 "),
    above(1, "claim disjoint", "axis 0x0p+0 0x0p+0 0x0p+0", "k 0"),
    above(1, "claim disjoint", "axis na 2", "k 0"),
    above(1, "claim disjoint", "axis x 0 0 0 0", "k 0"),
    above(1, "claim disjoint", "t c 2"),
    above(1, "claim disjoint", Z, "ab 0 | 1", "ab | 0", "ab | 0", "t na"),
    above(1, "claim disjoint", Z, "ab 0 | 1", "ab | 0", "t x 1 0"),
    above(1, "claim disjoint", Z, "ab 0 | 1", "ab | 0", "t c 0"),
    above(1, "claim disjoint", Z, "ab 0 | 1", "ab | 0", "t c 3"),
    above(0, "claim touching 0 2", Z, "k 0"),
    above(1, "claim touching 0 0", Z, "k 0"),
    above(0, "claim touching 0 0", X, "k 0"),
    above(0, "claim crossing 0 0"),
    above(0, "claim crossing 0 0", Z),
    above(1, "claim distance 0x1p+0 v 0 0 v 0 1", Z, "k 0"),
    above(1, "claim distance 0x1.0000000000001p+0 v 0 0 v 0 0", Z, "k 0"),
    above(1, "claim distance 0x1.fffffffffffffp-1 v 0 0 v 0 0", Z, "k 0"),
    above(1, "claim distance 0x1p+0 v 0 0 v 0 0", X, "k 0"),
    above(1, "claim distance 0x1p+0 0 0", Z, "k 0"),
    above(1, "claim distance inf", Z, "k 0"),
    above(1, "claim distance 0x0p+0 0 0"),
    above(1, "claim within 0x1.fffffffffffffp-1 v 0 0 v 0 0"),
    above(1, "claim within 0x1p+0 0 0"),
    above(1, "claim within 0x1p+0 e 0 0 f 0"),
    above(1, "claim beyond 0x1p+0", Z, "k 0"),
    above(1, "claim beyond -0x0p+0", Z, "k 0"),
    above(1, "claim hit 0x1p-1 0", Z, "k 0"),
    above(1, "claim hit 0x0p+0 0"),
    above(0, "claim hit 0x0p+0 0"),
    above(1, "claim miss", Z, "k 0"),
    above(1, "claim within 0x1p-1 e 0 0 e 0 0"),
    # Feet outside of the features, where any distance will do: beside an edge or a triangle, on parallel edges, beyond an end.
    pair("triangle", pose(), "triangle", pose(12, 0, 1), "claim within inf v 0 0 e 0 0"),
    pair("triangle", pose(), "triangle", pose(12, 0, 1), "claim within inf v 0 0 f 0"),
    pair("triangle", pose(), "triangle", pose(12, 0, 1), "claim within inf f 0 v 0 0"),
    pair("triangle", pose(), "triangle", pose(12, 0, 1), "claim within inf e 0 1 v 0 2"),
    pair("triangle", pose(), "triangle", pose(12, 0, 1), "claim within inf e 0 0 e 0 0"),
    pair("triangle", pose(), "triangle", pose(12, 0, 1), "claim within inf e 0 0 e 0 1"),
    pair("point", pose(), "point", pose(5), "claim within inf v 0 0 e 0 0"),
    # Feet outside of the features: before and behind an edge, beside each edge of a triangle; and features of no extent.
    pair("point", pose(-3.25, 0.25, 0), "triangle", pose(), "claim within 0x1p-1 v 0 0 e 0 0"),
    pair("point", pose(2.75, 0.25, 0), "triangle", pose(), "claim within 0x1p-1 v 0 0 e 0 0"),
    pair("point", pose(0, -1.25, 1), "triangle", pose(), "claim within 0x1p+0 v 0 0 f 0"),
    pair("point", pose(0.75, 0.75, 1), "triangle", pose(), "claim within 0x1p+0 v 0 0 f 0"),
    pair("point", pose(-1.25, 0, 1), "triangle", pose(), "claim within 0x1p+0 v 0 0 f 0"),
    pair("point", pose(5), "point", pose(), "claim within 0x1p+0 v 0 0 e 0 0"),
    pair("point", pose(5), "needle", pose(), "claim within 0x1p+0 v 0 0 f 0"),
    # A point in the plane and in the box of a triangle, and outside: an edge of the one x a coordinate axis parts them.
    pair("point", pose(0.5, 0.5, 0), "triangle", pose(), "claim distance 0x0p+0 0 0"),
    pair("triangle", pose(), "point", pose(0.5, 0.5, 0), "claim distance 0x0p+0 0 0"),
    # A point in the second part, which the axis parts from the first one only.
    pair("square", pose(), "point", pose(x=0.5), "claim disjoint", "axis 0x1p+0 -0x1p+0 0x0p+0", "a 0"),
    # A formula that is zero parts nothing.
    pair("triangle", pose(), "triangle", pose(), "claim touching 0 0", "ab | 0", "t x 0 0"),
    pair("square", pose(), "needle", pose(), "claim crossing 0 0"),
    pair("square", pose(), "needle", pose(x=0.25, z=-0.5), "claim touching 0 0", Z, "k 0"),
    diagonal(BELOW_ROOT),
    diagonal(ABOVE_ROOT),
    pair("point", pose(-(2.0**1022)), "point", pose(2.0**1022), "claim distance inf", X, "k 0"),
    segment("square", pose(), (0.5, 0.25, 1), (0.5, 0.25, -1), "claim hit 0x1p-1 1", "axis na 0", "k 0"),
    segment("square", pose(), (0.5, 0.25, 1), (0.5, 0.25, -1), "claim hit 0x1.0000000000001p-1 0", "axis na 0", "k 0"),
    segment("square", pose(), (0.5, 0.25, 1), (0.5, 0.25, -1), "claim hit 0x1.fffffffffffffp-2 0", "axis na 0", "k 0"),
    segment("square", pose(), (0.5, 0.25, 1), (0.5, 0.25, -1), "claim hit 0x1.0000000000001p+0 0", "axis na 0", "k 0"),
    segment("square", pose(), (0.5, 0.25, 1), (0.5, 0.25, -1), "claim hit 0x0p+0 0"),
    segment("square", pose(), (0.5, 0.25, 1), (0.5, 0.25, 0.25), "claim hit 0x1.5555555555555p+0 0", "axis na 0", "k 0"),
    segment("square", pose(), (0.5, 0.25, 1), (0.5, 0.25, 0), "claim miss", "axis na 0", "k 0"),
    segment("square", pose(), (0.5, 0.25, 1), (0.5, 0.25, TINY), "claim disjoint", "axis na 0", "k 0"),
    above(1, "claim disjoint", Z, "k 0").replace("ecods-certificate 2", "ecods-certificate 3"),
    above(1, "claim disjoint", Z, "k 0").replace(digest(SQUARE), "0" * 64),
    above(1, "claim disjoint", Z, "k 0").replace(digest(SQUARE), digest(SQUARE)[:32]),
    above(1, "claim disjoint", Z, "k 0").replace(digest(SQUARE), digest(SQUARE).upper()),
    above(1, "claim disjoint", Z, "k 0").replace(digest(SQUARE), linear_digest(SQUARE)),
    above(1, "claim disjoint", "axis 0x0p+0 0x0p+0 0x1p+1024", "k 0"),
    above(1, "claim disjoint", "axis 0x0p+0 0x0p+0 0x1p-1075", "k 0"),
    above(1, "claim disjoint", "axis 0x0p+0 0x0p+0 0x1.p+0", "k 0"),
    above(1, "claim disjoint", "axis 0x0p+0 0x0p+0 1", "k 0"),
    above(1, "claim disjoint", "axis 0x0p+0 0x0p+0 inf", "k 0"),
    "",
    "\n",
    above(1, "claim disjoint", Z, "k 0")[:-1],
]


def world(clearance, bodies, *lines):
    head = ["ecods-world-certificate 2", f"clearance {clearance}"]
    for name, (mesh_name, place, *filters) in bodies.items():
        groups, mask = filters or ("1", "ffffffffffffffff")
        head.append(f"body {name} {digest(MESHES[mesh_name])} {groups} {mask} {pose(*place)}")
    return "".join(line + "\n" for line in [*head, *lines, "end world"])


STACK = {"1.0": ("square", (0, 0, 0)), "2.0": ("square", (0, 0, 1)), "10.3": ("square", (0.5, 0, 1))}
APART = ["claim disjoint", Z, "k 0", "end"]
TOUCH = ["claim touching 0 0", Z, "k 0", "end"]
BEYOND = ["claim beyond 0x1p-1", Z, "k 0", "end"]
NEAR = ["claim within 0x1p+0 v 0 0 v 0 0", "end"]
SLOPE = {"1.0": ("triangle", (0, 0, 0)), "2.0": ("triangle", (1, 0.5, 0))}
SLOPED = ["claim disjoint", "axis 0x1p+0 0x1p+0 0x0p+0", "k 0", "end"]
GOOD += [
    world("none", STACK, "pair 2.0 10.3", *TOUCH),
    world("none", STACK, "pair 1.0 2.0", *APART, "pair 2.0 10.3", *TOUCH),
    world("none", STACK, "off 2.0 10.3"),
    world("0x1p-1", STACK, "pair 2.0 10.3", *TOUCH),
    world("0x1p-1", STACK, "pair 1.0 2.0", *BEYOND, "pair 2.0 10.3", *TOUCH),
    world("0x1p+0", STACK, "pair 1.0 2.0", *APART, "pair 1.0 2.0", *NEAR, "pair 1.0 10.3", *APART, "pair 1.0 10.3",
          "claim within 0x1p+0 e 0 0 v 0 0", "end", "pair 2.0 10.3", *TOUCH),
    world("none", {"1.0": ("square", (0, 0, 0), "1", "2"), "2.0": ("square", (0, 0, 0), "1", "3")}),
    world("none", {}),
    world("none", SLOPE, "pair 1.0 2.0", *SLOPED),
    world("none", {"1.0": ("square", (0, 0, 0)), "2.0": ("square", (0, 0, TINY))}),
    world("none", {"1.0": ("square", (2.0**1000, 0, 0)), "2.0": ("square", (2.0**1001, 0, 0))}),
]
BAD += [
    world("none", STACK),
    world("none", STACK, "pair 1.0 2.0", *APART),
    world("none", STACK, "pair 2.0 10.3", *APART),
    world("none", STACK, "pair 2.0 10.3", *TOUCH, "pair 1.0 2.0", *APART),
    world("none", STACK, "pair 2.0 10.3", *TOUCH, "pair 2.0 10.3", *TOUCH),
    world("none", STACK, "pair 10.3 2.0", *TOUCH),
    world("none", STACK, "off 2.0 10.3", "pair 2.0 10.3", *TOUCH),
    world("none", STACK, "off 1.0 10.3"),
    world("none", STACK, "pair 1.0 2.0", *BEYOND, "pair 2.0 10.3", *TOUCH),
    world("none", STACK, "pair 1.0 3.0", *APART, "pair 2.0 10.3", *TOUCH),
    world("none", STACK, "pair 1.0 3.0", *TOUCH, "pair 2.0 10.3", *TOUCH),
    world("0x1p+0", STACK, "pair 2.0 10.3", *TOUCH),
    world("0x1p+0", STACK, "pair 1.0 2.0", *APART, "pair 1.0 10.3", *APART, "pair 2.0 10.3", *TOUCH),
    world("0x1p+0", STACK, "pair 1.0 2.0", *NEAR, "pair 1.0 10.3", *APART, "pair 2.0 10.3", *TOUCH),
    world("0x1p-2", STACK, "pair 1.0 2.0", *BEYOND, "pair 2.0 10.3", *TOUCH),
    world("none", STACK, "pair 1.0 2.0", "claim distance 0x1p+0 v 0 0 v 0 0", Z, "k 0", "end", "pair 2.0 10.3", *TOUCH),
    world("none", SLOPE),
    world("none", {"2.0": ("square", (0, 0, 0)), "1.0": ("square", (0, 0, 1))}),
    world("none", {"1.0": ("square", (0, 0, 0)), "1.1": ("square", (0, 0, 0))}),
    world("none", {"1.0": ("square", (2.0**1000, 0, 0)), "2.0": ("square", (2.0**1000, 0, 0))}),
    world("inf", {}),
    # These ids name no body of the world; slot 0 is nobody's.
    world("none", STACK, "off 1.0 3.0", "pair 2.0 10.3", *TOUCH),
    world("none", STACK, "off 1.1 2.0", "pair 2.0 10.3", *TOUCH),
    world("none", STACK, "off 2.0 10.3", "off 10.3 11.0"),
    world("none", STACK, "off 0.0 1.0", "pair 2.0 10.3", *TOUCH),
    world("none", {}, "off 1.0 2.0"),
    world("none", {"0.0": ("square", (0, 0, 0))}),
    world("none", {"0.1": ("square", (0, 0, 0)), "1.0": ("square", (0, 0, 1))}),
]
BAD_MESHES = [
    "",
    "ecods-mesh 2\n",
    TRIANGLE[:-1],
    TRIANGLE + "l 1\n",
    TRIANGLE.replace("l 1", "l 2"),
    TRIANGLE.replace("l 1", "n 1"),
    TRIANGLE.replace("0 1 2 0", "0 1 3 0"),
    TRIANGLE.replace("0 1 2 0", "0 1 2 1"),
    TRIANGLE.replace("0 1 2 0", "0 1 2 00"),
    SQUARE.replace("0 1 2 0", "0 1 2 1"),
    SQUARE.replace("n 2", "n 1"),
    SQUARE.replace("n 2", "n 3"),
    SQUARE.replace("l 1\nl 1", "n 1\nl 2"),
    TRIANGLE.replace("vertices 3", "vertices 4294967295"),
    TRIANGLE.replace("triangles 1", "triangles 4294967295"),
    TRIANGLE.replace("nodes 1", "nodes 4294967296"),
    "ecods-mesh 1\nvertices 0 triangles 0 nodes 0\n",
    mesh([(0, 0, 0)], [(0, 0, 0, 0)], ["n 1"] * 201 + ["l 1"]),
]
