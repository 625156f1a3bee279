"""For check.py: which pairs of a world's bodies may meet. Bodies are by ids: what they are, their groups and their masks."""
from collections import Counter
from functools import reduce
from operator import or_


def do_filters_agree(one, other):
    return one[0] & other[1] and other[0] & one[1]


def may_meet(bodies, off_pairs, pair):
    return pair not in off_pairs and do_filters_agree(bodies[pair[0]][1:], bodies[pair[1]][1:])


# How many pairs of bodies may not meet. Filters are compared with each other, not bodies; bits that no filter asks for are left out.
def count_unjudged(lines, bodies, off_pairs):
    filters = [(groups, mask) for _, groups, mask in bodies.values()]
    all_groups, all_masks = (reduce(or_, each) for each in zip(*filters, (0, 0)))
    kinds = list(Counter((groups & all_masks, mask & all_groups) for groups, mask in filters).items())
    lines.spend(2 * len(kinds) ** 2)
    count = sum(1 for pair in off_pairs if may_meet(bodies, (), pair))
    for at, (one, size) in enumerate(kinds):
        count += 0 if do_filters_agree(one, one) else size * (size - 1) // 2
        count += size * sum(more for other, more in kinds[:at] if not do_filters_agree(one, other))
    return count
