#include <ostream>

#include "ecods/primitives.hpp"

namespace ecods {

std::ostream& operator<<(std::ostream& out, Sign sign) {
    return out << (sign == Sign::zero ? "zero" : sign == Sign::positive ? "positive" : "negative");
}

}  // namespace ecods
