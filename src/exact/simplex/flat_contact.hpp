// flat_contact decides from signs alone (exact/sign/exact_signs.hpp) how a triangle without area, which spans a segment
// or a point, meets a triangle with an area. flat_contact also finds where pieces of the segment may begin on the
// boundary of the second triangle. Points 0 to 2 are the corners of the first triangle, 3 to 5 the corners of the
// second.
#pragma once

#include <array>

#include "exact/sign/exact_signs.hpp"
#include "exact/simplex/segment_pair.hpp"

namespace ecods::exact {

struct FlatContact {
    bool meets = false;
    bool crosses = false;  // the open segment and the open triangle share exactly one point
    // `from` and `to` are the corners of the first triangle at the ends of the segment. They are equal if the segment
    // is a point.
    int from = 0;
    int to = 0;
    // Both arrays are false if crosses is true. holds_vertex[k] is true if corner k of the second triangle is on the
    // segment, but not at its end `to`. crosses_edge[k] is true if the segment meets the second triangle's side from
    // corner k to the next one in exactly one point, which is inside the side and is not `to`.
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
    contact.meets = relation != Relation::apart;
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
