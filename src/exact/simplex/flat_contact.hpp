// How the segment or point that a zero-area triangle spans meets a triangle of positive area, decided from signs alone
// (exact/sign/exact_signs.hpp): where on the triangle's boundary pieces of the segment may begin. Points 0 to 2 are the
// corners of the first, 3 to 5 those of the second.
#pragma once

#include <array>

#include "exact/sign/exact_signs.hpp"
#include "exact/simplex/segment_pair.hpp"

namespace ecods::exact {

struct FlatContact {
    bool meets = false;
    bool crosses = false;  // the open segment and the open triangle share a single point
    // The ends of the segment, as corners of the first; equal for a point.
    int from = 0;
    int to = 0;
    // Unless it crosses: the corners of the second on the segment, but for one at its end `to`; and the sides, from
    // that corner to the next one, inside which it has a single point that is not that end.
    std::array<bool, 3> holds_vertex{};
    std::array<bool, 3> crosses_edge{};
};

template <class Signs>
FlatContact flat_contact(Signs& signs) {
    const Segment s = find_segment(signs, 0);
    FlatContact contact;
    contact.from = s.a;
    contact.to = s.b;
    const Relation relation = segment_triangle(signs, s, 3);
    contact.meets = relation != Relation::disjoint;
    contact.crosses = relation == Relation::crossing;
    if (!contact.meets || contact.crosses || s.a == s.b) return contact;
    std::array<bool, 3> is_on{};
    for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        is_on[at] = is_on_segment(signs, 3 + k, s);
        contact.holds_vertex[at] = is_on[at] && compare_lexicographically(signs, 3 + k, s.b) != 0;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const Segment side{3 + static_cast<int>(k), 3 + static_cast<int>((k + 1) % 3)};
        if (is_on[k] || is_on[(k + 1) % 3] || is_on_segment(signs, s.b, side)) continue;
        contact.crosses_edge[k] = segments_meet(signs, s, side);
    }
    return contact;
}

}  // namespace ecods::exact
