// Checks lists of segments or rays.
#pragma once

#include <cstddef>
#include <span>

#include "ecods/error.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

// Throws InvalidArgument for the first line of a list that is not valid; its index is the line's place.
template <class SegmentOrRay>
void validate_all(std::span<const SegmentOrRay> lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        try {
            validate(lines[i]);
        } catch (const InvalidArgument& error) {
            throw error.at({}, i);
        }
    }
}

}  // namespace ecods
