#include <ostream>

#include "ecods/solid.hpp"

namespace ecods {

std::ostream& operator<<(std::ostream& out, Side side) {
    return out << (side == Side::outside ? "outside" : side == Side::on ? "on" : "inside");
}

std::ostream& operator<<(std::ostream& out, SolidRelation relation) {
    switch (relation) {
        case SolidRelation::apart:
            return out << "apart";
        case SolidRelation::touching:
            return out << "touching";
        case SolidRelation::overlapping:
            return out << "overlapping";
        case SolidRelation::inside:
            return out << "inside";
        case SolidRelation::contains:
            return out << "contains";
        case SolidRelation::equal:
            break;
    }
    return out << "equal";
}

std::ostream& operator<<(std::ostream& out, SurfaceRelation relation) {
    return out << (relation == SurfaceRelation::apart      ? "apart"
                   : relation == SurfaceRelation::touching ? "touching"
                   : relation == SurfaceRelation::inside   ? "inside"
                                                           : "partly inside");
}

}  // namespace ecods
