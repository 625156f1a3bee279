"""Certificates of which the words of the verdict matter: for cases.py."""
from case_texts import DIGITS, STACK, TOUCH, TWIN, Z, above, digest, linear_digest, mesh, pose, world

WHOLE = above(1, "claim disjoint", Z, "k 0")
assert DIGITS != TWIN and linear_digest(DIGITS) == linear_digest(TWIN)

# A claim that is false of DIGITS, which it names, and true of TWIN, which had the same digest in format 1.
AT_TWIN = mesh([(1 + 2.0**-33, 1 + 2.0**-13, 0)], [(0, 0, 0, 0)], ["l 1"])
FORGED = f"ecods-certificate 2\na {digest(DIGITS)} {pose()}\nb {digest(AT_TWIN)} {pose()}\nclaim within 0x0p+0 v 0 0 v 0 0\nend\n"
FORGED_MESHES = [TWIN, AT_TWIN]

OLD = "refused: line 1: format 1: its mesh digests can be forged; issue the certificate again"
ONE, OTHER, ALL = ("1", "1"), ("2", "1"), ("ffffffffffffffff", "ffffffffffffffff")


def crowd(*filters):
    """Squares far from each other, with these groups and masks."""
    return {f"{at}.0": ("square", (16 * at, 0, 0), *each) for at, each in enumerate(filters, 1)}


VERDICTS = {
    WHOLE: ["accepted: disjoint"],
    WHOLE.replace("ecods-certificate 2", "ecods-certificate 1"): [OLD],
    world("none", {}).replace("certificate 2", "certificate 1") + WHOLE: [OLD, "accepted: disjoint"],
    WHOLE.replace("certificate 2", "certificate 1").replace(digest(DIGITS), linear_digest(DIGITS)): [OLD],
    # Pairs that filters or `off` keep from being judged are counted, once each.
    world("none", {}): ["accepted: world of 0 bodies, 0 colliding, 0 pairs not judged"],
    world("none", STACK, "pair 2.0 10.3", *TOUCH): ["accepted: world of 3 bodies, 1 colliding, 0 pairs not judged"],
    world("none", STACK, "off 2.0 10.3"): ["accepted: world of 3 bodies, 0 colliding, 1 pair not judged"],
    world("0x1p-2", STACK, "off 1.0 2.0", "off 2.0 10.3"): ["accepted: world of 3 bodies, 0 colliding, 0 close, 2 pairs not judged"],
    world("none", crowd(ONE, ONE, ("1", "0"), ALL)): ["accepted: world of 4 bodies, 0 colliding, 3 pairs not judged"],
    world("none", crowd(ONE, OTHER, ("1", "2"), ("4", "4"), ("4", "4"), ("4", "8"))): [
        "accepted: world of 6 bodies, 0 colliding, 13 pairs not judged"
    ],
    world("none", crowd(OTHER, OTHER, OTHER, ONE)): ["accepted: world of 4 bodies, 0 colliding, 6 pairs not judged"],
    # A pair that filters keep apart is switched off, too.
    world("none", crowd(ONE, ("2", "2"), ONE), "off 1.0 2.0", "off 1.0 3.0"): [
        "accepted: world of 3 bodies, 0 colliding, 3 pairs not judged"
    ],
    # Two of the filters are the same but for bits that nobody asks for.
    world("none", crowd(("11", "21"), ("101", "201"), ("2", "2"))): ["accepted: world of 3 bodies, 0 colliding, 2 pairs not judged"],
}
