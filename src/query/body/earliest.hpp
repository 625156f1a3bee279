// Searches for the first time at which a moving body is within a distance of another one, by bisecting times.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "base/double_key.hpp"
#include "ecods/ids.hpp"

namespace ecods {

using PairList = std::vector<TrianglePair>;

// Calls take(pairs) with the pairs of triangles that may be near in parts of the time from 0 to `last`, earlier parts
// first, until all pairs that may be the first to be near have been taken. take(pairs) returns the first time of all
// pairs taken so far, or infinity.
//
// list(from, to, most) must return all pairs that may be near at some time from `from` to `to`, and a little later;
// nullopt if there are more than `most`. In that case, the part is cut in two, and twice as many pairs are allowed in
// each half. So the number of parts stays bounded by the number of pairs, also where many pairs are near at every time:
// where a body slides along another one, or faces meet face on.
//
// If a part has more than a few pairs, some of them are taken first. If one of these has a time in the part, the part
// ends there, and about half of the pairs are near in what is left.
template <class List, class Take>
void search_earliest(double last, const List& list, const Take& take) {
    constexpr std::size_t most = 24, cuts_max = 40, some_max = 4;
    struct Part {
        double from, to;
        std::size_t cuts;
    };
    std::array<Part, cuts_max + 1> parts;
    std::size_t count = 0;
    parts[count++] = {0, last, 0};
    while (count > 0) {
        const Part part = parts[--count];
        const bool may_cut = part.cuts < cuts_max && last < std::numeric_limits<double>::infinity();
        const std::optional<PairList> pairs =
            list(part.from, part.to, may_cut ? most << part.cuts : std::numeric_limits<std::size_t>::max());
        if (!pairs) {
            const double middle = part.from + (part.to - part.from) / 2;
            parts[count++] = {middle, part.to, part.cuts + 1};
            parts[count++] = {part.from, middle, part.cuts + 1};
            continue;
        }
        if (pairs->size() > 2 * some_max) {
            PairList some;
            for (std::size_t k = 0; k < some_max; ++k) some.push_back((*pairs)[k * pairs->size() / some_max]);
            const double sooner = take(some);
            if (key_of(sooner) < key_of(part.to)) {
                parts[count++] = {part.from, sooner, part.cuts};
                continue;
            }
        }
        if (key_of(take(*pairs)) <= key_of(part.to)) return;
    }
}

}  // namespace ecods
