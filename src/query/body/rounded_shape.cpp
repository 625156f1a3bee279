#include "ecods/rounded.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/double_key.hpp"
#include "base/hash.hpp"
#include "base/limits.hpp"
#include "base/make_error.hpp"
#include "base/next.hpp"
#include "exact/number/exact_sum.hpp"
#include "geometry/find_invalid.hpp"
#include "query/convex/convex_core.hpp"

namespace ecods {
namespace {

// Returns a double that is at most x - radius. The difference as computed is off by less than one unit in its last
// place, in any rounding mode, also if a processor takes a subnormal number for zero, because the result is then the
// other operand. A difference that may be subnormal is computed exactly.
double reach_down(double x, double radius) {
    const double difference = x - radius;
    if (std::abs(difference) >= 0x1p-900) return next_down(difference);
    return exact::ExactSum(x).minus(radius).lower();
}

std::shared_ptr<const Rounded> around(std::vector<Vec3> vertices, const Triangle& triangle, double radius) {
    auto core = std::make_shared<const MeshShape>(Mesh::create(std::move(vertices), {triangle}));
    return std::make_shared<const Rounded>(std::move(core), radius);
}

}  // namespace

Rounded::Rounded(std::shared_ptr<const MeshShape> core, double radius) : core_(std::move(core)), radius_(radius) {
    if (!core_) throw null_argument("shape");
    if (!is_from_zero(radius) || key_of(radius) == infinity_key) throw invalid_radius(radius);
    if (key_of(radius) == 0) radius_ = 0;  // turns -0 into +0
    kind_ = convex::is_convex_core(*core_) ? ShapeKind::rounded_convex() : ShapeKind::rounded();
}

Rounded::~Rounded() = default;

Aabb Rounded::box(const Pose& pose) const {
    Aabb box = core_->box(pose);
    if (key_of(radius_) == 0) return box;
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = reach_down(box.min[axis], radius_);
        box.max[axis] = -reach_down(-box.max[axis], radius_);
    }
    return box;
}

std::uint64_t Rounded::digest() const noexcept {
    return combine(core_->digest(), static_cast<std::uint64_t>(key_of(radius_)));
}

std::shared_ptr<const Rounded> sphere(double radius, const Vec3& center) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(center[axis])) throw invalid_center(axis, center[axis]);
    }
    return around({center}, {0, 0, 0}, radius);
}

std::shared_ptr<const Rounded> capsule(const Vec3& p, const Vec3& q, double radius) {
    for (const int end : {0, 1}) {
        for (int axis = 0; axis < 3; ++axis) {
            const double x = (end == 0 ? p : q)[axis];
            if (!is_finite(x)) throw invalid_segment(end, axis, x);
        }
    }
    return around({p, q}, {0, 1, 1}, radius);
}

std::shared_ptr<const Rounded> rounded(const std::shared_ptr<const Shape>& shape, double radius) {
    if (!shape) throw null_argument("shape");
    if (auto core = std::dynamic_pointer_cast<const MeshShape>(shape)) {
        return std::make_shared<const Rounded>(std::move(core), radius);
    }
    const auto* const known = dynamic_cast<const Rounded*>(shape.get());
    if (known == nullptr) {
        throw NotSupported("a shape of kind " + std::to_string(shape->kind().value) + " cannot be rounded");
    }
    const Rounded added(known->core_ptr(), radius);  // checks the radius
    const exact::ExactSum sum = exact::ExactSum(known->radius()).plus(added.radius());
    if (!sum.is_double()) throw NotSupported("the shape is rounded already, and the sum of the radii is no double");
    return std::make_shared<const Rounded>(known->core_ptr(), sum.lower());
}

}  // namespace ecods
