#include "ecods/pose.hpp"

#include "ecods/error.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {

void validate(const Pose& pose) {
    if (const auto bad = find_invalid(pose)) throw InvalidPose(bad->row, bad->column, bad->value);
}

}  // namespace ecods
