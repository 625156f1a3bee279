"""Certificates with one thing changed: both checkers must agree, and refuse each, unless truth.py finds that it still proves what it says.

usage: tamper.py CHECKER [--changes N] [--seed S] [--certificates FOLDER]
"""
import argparse
import collections
import random
import sys

import small_certificates
import truth
from checkers import HEADERS, HERE, Checkers, digest, is_accepted

BATCH = 2000


def change_number(random_, word):
    """Another number of the same kind: hexadecimal floating-point, decimal, or hexadecimal digits."""
    if "0x" in word:
        value = float.fromhex(word)
        near = [value + 1, -value, value * 2, 0.0, value / 3, value + random_.choice([-1, 1]) * abs(value) * 2.0**-52]
        near += [value + random_.choice([-1, 1]) * 2.0 ** -random_.randrange(60), random_.choice([2.0**-1074, 1e308])]
        chosen = random_.choice(near)
        return small_certificates.shown(chosen) if abs(chosen) < 1.7e308 else "0x1.fffffffffffffp+1023"
    if word.isdigit():
        return str(max(0, int(word) + random_.choice([-2, -1, 1, 1, 2, 5, 2**32])))
    if set(word) <= set("0123456789abcdef."):
        at = random_.randrange(len(word))
        return word[:at] + random_.choice("0123456789abcdef") + word[at + 1 :]
    return random_.choice(["ab", "a", "b", "k", "t", "na", "nb", "x", "ea", "eb", "c", "vv", "va", "vb", "|", "v", "e", "f", "axis", "end", "0", "inf"])


def change_claim(random_, words):
    rest = words[2:]
    kind = random_.choice(["disjoint", "touching", "crossing", "distance", "within", "within inf", "beyond", "hit", "miss"])
    if kind == "within inf":
        names = [random_.choice([["v", "e", "e", "v"], ["v", "f", "e", "e"]])[at::2] for at in range(2)]
        pair = [[random_.choice(each), "0"] for each in names]
        return ["claim", "within", "inf", *(word for name, at in pair for word in (name, at, *([] if name == "f" else [random_.choice("012")])))]
    if kind in ("distance", "within", "beyond") and (not rest or "0x" not in rest[0]):
        rest = ["0x1p+0", *rest]
    if kind in ("disjoint", "miss"):
        rest = []
    if kind in ("touching", "crossing") and len(rest) != 2:
        rest = random_.sample([word for word in rest if word.isdigit()] + ["0", "0"], 2)
    return ["claim", kind, *(rest[:1] if kind == "beyond" else rest)]


def change_fields(random_, words):
    """One field of a line changed, taken out, repeated, or exchanged with another."""
    words, at = list(words), random_.randrange(len(words))
    kind = random_.random()
    if words[0] == "claim" and kind < 0.3:
        return change_claim(random_, words)
    if kind < 0.7:
        words[at] = change_number(random_, words[at])
    elif kind < 0.8:
        del words[at]
    elif kind < 0.9:
        words.insert(at, random_.choice([words[at], change_number(random_, words[at])]))
    else:
        other = random_.randrange(len(words))
        words[at], words[other] = words[other], words[at]
    return words


def change_order(random_, lines):
    """A line taken out, repeated or moved, two lines exchanged, or the rest cut off."""
    lines, kind = list(lines), random_.random()
    at, to = random_.randrange(len(lines)), random_.randrange(len(lines))
    if kind < 0.3:
        del lines[at]
    elif kind < 0.5:
        lines.insert(to, lines[at])
    elif kind < 0.7:
        lines.insert(to, lines.pop(at))
    elif kind < 0.9:
        lines[at], lines[to] = lines[to], lines[at]
    else:
        lines = lines[:at] + ([lines[at][: random_.randrange(len(lines[at]))]] if random_.random() < 0.5 else [])
    return lines


def change_mesh(random_, text):
    """A mesh file in which a coordinate, or a corner of a triangle, is another one; it may be malformed."""
    lines = text.split("\n")[:-1]
    head = lines[1].split()
    last = 2 + int(head[1]) + int(head[3])
    at = random_.randrange(2, last)
    words = lines[at].split(" ")
    field = random_.randrange(min(len(words), 3))
    words[field] = change_number(random_, words[field]) if "0x" in words[field] else str(random_.randrange(int(head[1])))
    lines[at] = " ".join(words)
    return "\n".join(lines) + "\n"


def changed(random_, meshes, text):
    """The kind of change, the certificate changed, and its meshes."""
    lines = text.split("\n")[:-1]
    steps = [at for at, line in enumerate(lines) if line.split()[0] in ("axis", "ab", "a", "b", "k", "t") and at > 2 and not line.startswith("body")]
    kind = random_.choice(["field", "step", "step", "step", "claim", "order", "mesh"])
    if kind == "mesh":
        old = random_.choice(meshes)
        new = change_mesh(random_, old)
        return kind, text.replace(digest(old), digest(new)), [new if mesh == old else mesh for mesh in meshes]
    if kind == "order":
        return kind, "\n".join(change_order(random_, lines)) + "\n", meshes
    claims = [at for at, line in enumerate(lines) if line.startswith("claim")]
    at = random_.choice(steps if kind == "step" and steps else claims if kind == "claim" and claims else range(len(lines)))
    lines[at] = " ".join(change_fields(random_, lines[at].split(" ")))
    return kind, "\n".join(lines) + "\n", meshes


def holds(text, meshes):
    """Whether a text has a true certificate. It stands behind one of the lines that begin one, which may have been repeated or moved."""
    lines, soups = text.split("\n"), {soup.digest: soup for soup in (truth.Soup(mesh.encode()) for mesh in meshes)}
    for at in (at for at, line in enumerate(lines) if line in HEADERS):
        try:
            if (truth.world_holds if "world" in lines[at] else truth.certificate_holds)("\n".join(lines[at:]), soups):
                return True
        except (StopIteration, ValueError, IndexError, KeyError, TypeError):
            pass
    return False


def known_certificates(random_, count):
    return [small_certificates.random_certificate(random_) for _ in range(count)]


def run(checkers, random_, sources, count, report):
    """Changes that are wrongly judged: printed, and counted."""
    wrong = 0
    for first in range(0, count, BATCH):
        batch = []
        while len(batch) < min(BATCH, count - first):
            meshes, text = random_.choice(sources)
            kind, new, new_meshes = changed(random_, meshes, text)
            if new != text:
                batch.append((kind, new, new_meshes))
        all_meshes = {mesh for _, _, meshes in batch for mesh in meshes}
        for (kind, text, meshes), (one, other) in zip(batch, checkers.verdicts([text for _, text, _ in batch], all_meshes)):
            verdict = "refused"
            if one != other:
                verdict = "judged differently"
            elif any(line.startswith("accepted") for line in one):
                accepted = [line for line in one if line.startswith("accepted")]
                verdict = "still true" if len(accepted) == 1 and holds(text, meshes) else "wrongly accepted"
            report[kind, verdict] += 1
            if verdict in ("judged differently", "wrongly accepted"):
                wrong += 1
                print(f"--- {verdict} ({kind}): C++ {one}, Python {other}\n{text}" + "".join(meshes), flush=True)
    return wrong


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("checker")
    parser.add_argument("--python", default=HERE / "check.py", help="another Python checker")
    parser.add_argument("--changes", type=int, default=1500)
    parser.add_argument("--sources", type=int, default=60)
    parser.add_argument("--seed", type=int, default=18)
    options = parser.parse_args()
    random_ = random.Random(options.seed)
    checkers, report = Checkers(options.checker, options.python), collections.Counter()
    sources = known_certificates(random_, options.sources)
    wrong = 0
    for (meshes, text), (one, other) in zip(sources, checkers.verdicts([text for _, text in sources], {mesh for meshes, _ in sources for mesh in meshes})):
        if one != other or not is_accepted(one):
            wrong += 1
            print(f"--- not accepted as made: C++ {one}, Python {other}\n{text}" + "".join(meshes))
    headed = [(meshes, text[: at + 1] + "a" + text[at + 5 :]) for meshes, text in sources for at in range(len(text)) if text.startswith("\npair ", at)]
    for (meshes, text), (one, other) in zip(headed, checkers.verdicts([text for _, text in headed], {mesh for meshes, _ in headed for mesh in meshes})):
        if one != other or is_accepted(one):
            wrong += 1
            print(f"--- a section that does not begin with pair: C++ {one}, Python {other}\n{text}" + "".join(meshes))
    wrong += run(checkers, random_, sources, options.changes, report)
    for (kind, verdict), count in sorted(report.items()):
        print(f"{kind:8} {verdict:20} {count}")
    print(f"{sum(report.values())} changes: {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
