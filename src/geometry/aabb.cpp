#include "ecods/primitives.hpp"

#include "base/double_key.hpp"

namespace ecods {
namespace {

bool is_above(double a, double b) noexcept {
    return key_of(a) > key_of(b);
}

}  // namespace

bool overlap(const Aabb& a, const Aabb& b) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        if (is_above(a.min[axis], b.max[axis]) || is_above(b.min[axis], a.max[axis])) return false;
    }
    return true;
}

bool contains(const Aabb& outer, const Aabb& inner) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        if (is_above(outer.min[axis], inner.min[axis]) || is_above(inner.max[axis], outer.max[axis])) return false;
    }
    return true;
}

Aabb merge(const Aabb& a, const Aabb& b) noexcept {
    Aabb both = a;
    for (int axis = 0; axis < 3; ++axis) {
        if (is_above(a.min[axis], b.min[axis])) both.min[axis] = b.min[axis];
        if (is_above(b.max[axis], a.max[axis])) both.max[axis] = b.max[axis];
    }
    return both;
}

}  // namespace ecods
