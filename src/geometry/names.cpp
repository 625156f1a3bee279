// Stream operators write the names of results, as messages and reports show them.
#include <array>
#include <ostream>

#include "base/write_name.hpp"
#include "ecods/results.hpp"

namespace ecods {

std::ostream& operator<<(std::ostream& out, Relation relation) {
    constexpr std::array names{"apart", "touching", "crossing", "overlapping", "inside", "contains", "equal"};
    return write_name(out, relation, names);
}

std::ostream& operator<<(std::ostream& out, ClosestKind kind) {
    constexpr std::array names{"vertex and vertex", "vertex and edge", "vertex and face",
                               "edge and edge",     "intersecting",    "contained"};
    return write_name(out, kind, names);
}

std::ostream& operator<<(std::ostream& out, HitKind kind) {
    constexpr std::array names{"front", "back", "face", "edge", "vertex", "along", "inside"};
    return write_name(out, kind, names);
}

std::ostream& operator<<(std::ostream& out, Side side) {
    constexpr std::array names{"outside", "on", "inside"};
    return write_name(out, side, names);
}

}  // namespace ecods
