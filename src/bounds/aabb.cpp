#include "ecods/aabb.hpp"

namespace ecods {

bool overlap(const Aabb& a, const Aabb& b) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(a.min[axis] <= b.max[axis] && b.min[axis] <= a.max[axis])) return false;
    }
    return true;
}

bool contains(const Aabb& outer, const Aabb& inner) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(outer.min[axis] <= inner.min[axis] && inner.max[axis] <= outer.max[axis])) return false;
    }
    return true;
}

Aabb merge(const Aabb& a, const Aabb& b) noexcept {
    return {a.min.cwiseMin(b.min), a.max.cwiseMax(b.max)};
}

}  // namespace ecods
