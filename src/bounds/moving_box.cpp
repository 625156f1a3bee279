#include "bounds/moving_box.hpp"

#include <cmath>

#include "base/next.hpp"

namespace ecods {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double speed_min = 0x1p-1000, speed_max = 0x1p1000;
constexpr double less = 1 - 0x1p-48, more = 1 + 0x1p-48;

// Returns an upper bound of the real difference b - a. If the computed difference may be subnormal, and flushed to
// zero, only its sign is used.
double difference_above(double a, double b) noexcept {
    if (key_of(a) == key_of(b)) return 0;
    const double difference = b - a;
    if (std::abs(difference) < MovingBox::gap_min) return key_of(b) > key_of(a) ? 2 * MovingBox::gap_min : 0;
    return next_up(difference);
}

}  // namespace

// Sets one side of the box to the position p with its outward velocity. A side at infinity does not move. Let e be the
// position of the facing side of another box (moving_box.hpp). If p is infinity, e <= p holds at all times. If p is
// -infinity and the velocity is not positive, e <= p holds only for e = -infinity.
void MovingBox::set(std::size_t side, double p, double velocity) noexcept {
    const std::int64_t key = key_of(velocity);
    Side& s = sides_[side];
    s = {Course::resting, p, key_of(p), 0};
    if (p == infinite) {
        s.course = Course::without_end;
    } else if (key > 0) {
        s.course = Course::coming;
        s.factor = velocity > speed_max ? 0 : less * (1 / std::max(velocity, speed_min));
    } else if (key < 0 && p != -infinite) {
        s.course = Course::going;
        s.factor = -velocity < speed_min ? infinite : more * (1 / std::min(-velocity, speed_max));
    }
}

MovingBox::MovingBox(const Aabb& box, const Vec3& motion) noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        set(k, box.max[axis], motion[axis]);
        set(k + 3, -box.min[axis], -motion[axis]);
    }
}

MovingBox::MovingBox(const Ray& ray) noexcept : MovingBox(Aabb{ray.origin, ray.origin}, ray.direction) {}

MovingBox::MovingBox(const Segment& segment) noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        set(k, segment.a[axis], difference_above(segment.a[axis], segment.b[axis]));
        set(k + 3, -segment.a[axis], difference_above(-segment.a[axis], -segment.b[axis]));
    }
}

}  // namespace ecods
