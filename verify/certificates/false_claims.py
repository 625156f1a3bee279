"""False claims, each with the best proof that can be made for it: both checkers must refuse them all.

usage: false_claims.py CHECKER [--claims N] [--seed S]

The steps hold for every pair of triangles but those that make the claim false; there a formula stands that fails by the least.
"""
import argparse
import collections
import math
import random
import sys
from fractions import Fraction

import small_certificates
import triangles
import truth
from checkers import HERE, Checkers
from small_certificates import Steps, shown


class FalseSteps(Steps):
    """Steps that go on where nothing parts two triangles."""

    def step(self, one, other):
        try:
            return super().step(one, other)
        except AssertionError:
            t, u = self.a[one[1]], self.b[other[1]]
            self.lines.append("t " + " ".join(max(small_certificates.FORMULAS, key=lambda words: self.gap(words, t, u))))
            return []

    def gap(self, words, t, u):
        n = self.proof.formula(t, u, *words)
        if not any(n):
            return -math.inf
        one, other = [triangles.dot(n, p) for p in t], [triangles.dot(n, p) for p in u]
        gap = max(min(other) - max(one), min(one) - max(other))
        return float(Fraction(abs(gap) * gap, 1) / Fraction(triangles.dot(n, n))) if abs(gap) < 2**400 else 0.0


def steps_of(random_, words, a, b, soups, power):
    if words[0] in ("crossing", "within") or words[:2] == ["distance", "0x0p+0"]:
        return ["end"]
    least = truth.bounds(words, power)
    return FalseSteps(random_, a, b, lambda n, t, u: truth.parts_pair(n, t, u, least)).prove(soups[0].tree, soups[1].tree)


def ulp(value, random_):
    """A neighbour of a double, or one a little further away."""
    way = random_.choice([0, math.inf])
    near = math.nextafter(value, way)
    return math.nextafter(near, way) if random_.random() < 0.2 else near


def false_pair(random_):
    """A false claim about two bodies, as words; None if none of the chosen kind is false here."""
    texts = [small_certificates.random_mesh(random_) for _ in range(2)]
    soups = [truth.Soup(text.encode()) for text in texts]
    reach = random_.choice([1, 2, 4])
    poses = [small_certificates.pose_text(1.0, small_certificates.random_pose(random_, reach)) for _ in range(2)]
    (a, b), power = truth.integers(*(truth.posed(soup, pose.split()) for soup, pose in zip(soups, poses)))
    square = triangles.least_squared(a, b)
    words = false_words(random_, a, b, square, power)
    if words is None or truth.claim_holds(words, a, b, power):
        return None
    heads = [f"{name} {soup.digest} {pose}" for name, soup, pose in zip("ab", soups, poses)]
    steps = steps_of(random_, words, a, b, soups, power)
    return f"{words[0]}, {'met' if square == 0 else 'apart'}", texts, ["ecods-certificate 2", *heads, "claim " + " ".join(words), *steps]


def false_feet(random_):
    """Two features that are within infinity of each other as all are, but whose closest points are not in them."""
    texts = [small_certificates.random_mesh(random_) for _ in range(2)]
    soups = [truth.Soup(text.encode()) for text in texts]
    poses = [small_certificates.pose_text(1.0, small_certificates.random_pose(random_, 4)) for _ in range(2)]
    (a, b), _ = truth.integers(*(truth.posed(soup, pose.split()) for soup, pose in zip(soups, poses)))
    kinds, words = random_.choice([("v", "e"), ("e", "v"), ("v", "f"), ("f", "v"), ("e", "e")]), ["within", "inf"]
    for kind, body in zip(kinds, (a, b)):
        words += [kind, str(random_.choice(list(body))), *([] if kind == "f" else [str(random_.randrange(3))])]
    if truth.has_feet(words[2:], a, b):
        return None
    heads = [f"{name} {soup.digest} {pose}" for name, soup, pose in zip("ab", soups, poses)]
    return "no feet", texts, ["ecods-certificate 2", *heads, "claim " + " ".join(words), "end"]


def false_words(random_, a, b, square, power):
    if square == 0:
        pairs = [(i, j) for i in a for j in b if triangles.meet(a[i], b[j])]
        crossing = [(i, j) for i, j in pairs if triangles.cross_each_other(a[i], b[j])]
        level = [pair for pair in pairs if pair not in crossing]
        if random_.random() < 0.4:
            return random_.choice([["disjoint"], ["beyond", "0x0p+0"], ["distance", "0x0.0000000000001p-1022", "v", "0", "0", "v", "0", "0"]])
        if crossing and random_.random() < 0.7:
            return ["touching", *map(str, random_.choice(crossing))]
        return ["crossing", *map(str, random_.choice(level))] if level else None
    value = small_certificates.rounded(square, power)
    features = small_certificates.features(a, b, square)
    apart = [str(random_.choice(list(a))), str(random_.choice(list(b)))]
    kind = random_.choice(["touching", "crossing", "distance", "distance", "within", "beyond", "zero"])
    if kind == "distance":
        return ["distance", shown(ulp(value, random_)), *features]
    if kind == "zero":
        return [*random_.choice([["distance", "0x0p+0"], ["within", shown(value)]]), *apart]
    if kind == "within":
        return ["within", shown(random_.choice([value, ulp(value, random_), 0.0])), *features]
    if kind == "beyond":
        return ["beyond", shown(random_.choice([value, ulp(value, random_), value * 2]))]
    return [kind, *apart]


def false_hit(random_):
    """A hit too early, too late, of another triangle, or none where there is one."""
    texts, certificate = small_certificates.random_hit(random_)
    lines = certificate.split("\n")
    soup = truth.Soup(texts[0].encode())
    numbers = [triangles.real(word) for word in lines[2].split()[1:]]
    (body, piece), _ = truth.integers(truth.posed(soup, lines[1].split()[2:]), {0: [numbers[:3], numbers[3:]]})
    words = lines[3].split()[1:]
    name = str(random_.choice(list(body)))
    if words[0] == "hit":
        value = float.fromhex(words[1])
        near = min(max(ulp(value, random_) if random_.random() < 0.6 else random_.random(), 0.0), 1.0)
        words = random_.choice([["hit", shown(near), words[2]], ["hit", words[1], name], ["miss"]])
    else:
        words = ["hit", shown(random_.choice([0.0, 1.0, 0.5, 2.0**-1074])), name]
    if truth.hit_holds(words, body, piece[0]):
        return None
    steps, ends = ["end"], piece[0]
    value = float.fromhex(words[1]) if words[0] == "hit" else 1.0
    if value > 0:
        m, is_strict = Fraction(1), int(value / math.ulp(value)) % 2 == 1
        if words[0] == "hit":
            m = Fraction(0) if value == 2.0**-1074 else (Fraction(math.nextafter(value, 0)) + Fraction(value)) / 2
        stop = [x + m * (y - x) for x, y in zip(*ends)]
        (body, part), _ = truth.integers(body, {0: [ends[0], stop, stop]})
        apart = (
            (lambda n, t, u: truth.heads_off(n, t, u, is_strict))
            if words[0] == "hit"
            else (lambda n, t, u: truth.parts_pair(n, t, u, (Fraction(0), True)))
        )
        steps = FalseSteps(random_, body, part, apart).prove(soup.tree, ("t", 0))
    return words[0], texts, [*lines[:3], "claim " + " ".join(words), *steps]


def false_world(random_):
    """A world with a section left out, or with a body more."""
    texts, certificate = small_certificates.random_world(random_)
    lines = certificate.split("\n")[:-1]
    starts = [at for at, line in enumerate(lines) if line.startswith("pair ")]
    if not starts:
        return None
    start = random_.choice(starts)
    stop = next(at for at in range(start, len(lines)) if lines[at] == "end") + 1
    kept = lines[:start] + lines[stop:]
    soups = {soup.digest: soup for soup in (truth.Soup(text.encode()) for text in texts)}
    try:
        if truth.world_holds("\n".join(kept) + "\n", soups):
            return None
    except (StopIteration, ValueError, IndexError, KeyError):
        pass
    return "world", texts, kept


def false_moved(random_):
    """An old certificate of bodies that have moved into each other since."""
    texts, certificate = small_certificates.random_pair(random_)
    lines = certificate.split("\n")
    if lines[3].split()[1] not in ("disjoint", "distance", "beyond", "touching"):
        return None
    one, other = (line.split() for line in lines[1:3])
    soups = {soup.digest: soup for soup in (truth.Soup(text.encode()) for text in texts)}
    (p, *_), (q, *_) = (random_.choice(list(truth.posed(soups[words[1]], words[2:]).values())) for words in (one, other))
    for at, (x, y) in zip((5, 9, 13), zip(p, q)):
        other[at] = shown(float.fromhex(other[at]) + float(x - y))
    (a, b), power = truth.integers(*(truth.posed(soups[words[1]], words[2:]) for words in (one, other)))
    if truth.claim_holds(lines[3].split()[1:], a, b, power):
        return None
    return "moved", texts, [*lines[:2], " ".join(other), *lines[3:-1]]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("checker")
    parser.add_argument("--python", default=HERE / "check.py", help="another Python checker")
    parser.add_argument("--claims", type=int, default=150)
    parser.add_argument("--seed", type=int, default=18)
    options = parser.parse_args()
    random_ = random.Random(options.seed)
    claims, report, wrong, checkers = [], collections.Counter(), 0, Checkers(options.checker, options.python)
    while sum(report.values()) < options.claims:
        found = random_.choice([false_pair, false_pair, false_pair, false_hit, false_world, false_moved, false_feet])(random_)
        if found:
            claims.append(found)
            report[found[0]] += 1
        if len(claims) == 500 or sum(report.values()) == options.claims:
            texts = ["\n".join(lines) + "\n" for _, _, lines in claims]
            judged = checkers.verdicts(texts, {mesh for _, meshes, _ in claims for mesh in meshes})
            for (kind, meshes, _), text, (one, other) in zip(claims, texts, judged):
                if one != ["refused"] or other != ["refused"]:
                    wrong += 1
                    print(f"--- {kind}: C++ {one}, Python {other}\n{text}" + "".join(meshes), flush=True)
            claims = []
    print(", ".join(f"{kind} {count}" for kind, count in sorted(report.items())))
    print(f"{sum(report.values())} false claims: {wrong} not refused by both")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
