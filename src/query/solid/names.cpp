#include <ostream>

#include "base/write_name.hpp"
#include "ecods/solid.hpp"

namespace ecods {

std::ostream& operator<<(std::ostream& out, Side side) {
    constexpr std::array names{"outside", "on", "inside"};
    return write_name(out, side, names);
}

std::ostream& operator<<(std::ostream& out, SolidRelation relation) {
    constexpr std::array names{"apart", "touching", "overlapping", "inside", "contains", "equal"};
    return write_name(out, relation, names);
}

std::ostream& operator<<(std::ostream& out, SurfaceRelation relation) {
    constexpr std::array names{"apart", "touching", "inside", "partly inside"};
    return write_name(out, relation, names);
}

}  // namespace ecods
