// How the elements of a building are to each other, by integers alone. This shares no code with the library, nor with
// what it is compared with: volumes of blocks, and separating lines of convex polygons.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scenes/building/building.hpp"

namespace ecods::scenes {

enum class Contact : std::uint8_t { apart, touching, overlapping, inside, contains, equal, partly_inside };

struct KnownRelation {
    std::size_t a = 0;  // indices in the building, a < b
    std::size_t b = 0;
    Contact contact = Contact::apart;

    // Of elements that are apart: their distance in meters, rounded once, as the difference of two coordinates.
    std::optional<double> distance = {};

    // Of two whole boxes that share inner points: how deep they are, rounded once; and of those that share points, all
    // of these.
    std::optional<double> depth = {};
    std::optional<Block> common = {};
};

// Every pair that is not apart, and of those that are apart every pair at a distance of at most `clearance`. Ascending.
// Throws std::logic_error for a pair of which these integers do not tell how it is: a building is to have none.
std::vector<KnownRelation> known_relations(const std::vector<Element>& elements, Length clearance);

}  // namespace ecods::scenes
