// list_hits() lists the hits of many lines in a HitLists or a BodyHitLists.
#pragma once

#include <span>

#include "geometry/validate_lines.hpp"

namespace ecods {

// Calls find(line), which must return the hits of the line, for each line in order. If a line is not valid, throws
// InvalidArgument before the first call.
template <class Lists, class SegmentOrRay, class Find>
Lists list_hits(std::span<const SegmentOrRay> lines, const Find& find) {
    validate_all(lines);
    Lists lists;
    lists.first.reserve(lines.size() + 1);
    lists.first.push_back(0);
    for (const SegmentOrRay& line : lines) {
        const auto hits = find(line);
        lists.hits.insert(lists.hits.end(), hits.begin(), hits.end());
        lists.first.push_back(lists.hits.size());
    }
    return lists;
}

}  // namespace ecods
