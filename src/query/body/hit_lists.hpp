// Lists the hits of many lines, for HitLists and BodyHitLists.
#pragma once

#include <span>

#include "geometry/validate_lines.hpp"

namespace ecods {

// Calls find(line) for each line, in their order; it returns the hits of the line. Throws InvalidArgument before that
// if a line is not valid.
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
