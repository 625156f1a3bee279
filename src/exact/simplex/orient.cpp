#include <cmath>

#include "ecods/predicates.hpp"
#include "exact/point/integer_width.hpp"
#include "exact/point/rounded_points.hpp"
#include "exact/sign/filtered_signs.hpp"
#include "exact/sign/kernel_signs.hpp"

namespace ecods {
namespace {

using namespace exact;

const Pose identity;

Sign to_sign(int s) noexcept {
    return static_cast<Sign>(s);
}

// `ask` asks one question of a provider of signs.
template <class Ask>
Sign decide(const SixPoints& exact, const RoundedPoints& rounded, Ask&& ask) noexcept {
    const PairBound bound = pair_bound(rounded.points, rounded.delta);
    if (const int s = ask(FilterSigns(rounded.points, bound))) return to_sign(s);
    return to_sign(with_kernel(exact, [&](const auto& kernel) { return ask(KernelSigns(kernel)); }));
}

// Points that a question does not name repeat its first one.
SixPoints six(const PosedPoint& a, const PosedPoint& b, const PosedPoint& c, const PosedPoint& d) noexcept {
    const PointRef first{&a.pose, &a.v};
    return {first, PointRef{&b.pose, &b.v}, PointRef{&c.pose, &c.v}, PointRef{&d.pose, &d.v}, first, first};
}

SixPoints six(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept {
    const PointRef first{&identity, &a};
    return {first, PointRef{&identity, &b}, PointRef{&identity, &c}, PointRef{&identity, &d}, first, first};
}

}  // namespace

Sign orient2d(const Vec2& a, const Vec2& b, const Vec2& c) noexcept {
    // In the plane z = 0, seen along z.
    const Vec3 p(a[0], a[1], 0), q(b[0], b[1], 0), r(c[0], c[1], 0);
    const SixPoints points = six(p, q, r, p);
    return decide(points, plain_points(points), [](const auto& signs) { return signs.orient2d(0, 1, 2, 2); });
}

Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept {
    const SixPoints points = six(a, b, c, d);
    return decide(points, plain_points(points), [](const auto& signs) { return signs.orient3d(0, 1, 2, 3); });
}

Sign orient2d(const PosedPoint& a, const PosedPoint& b, const PosedPoint& c, int axis) noexcept {
    const SixPoints points = six(a, b, c, a);
    return decide(points, round_points(points), [axis](const auto& signs) { return signs.orient2d(0, 1, 2, axis); });
}

Sign orient3d(const PosedPoint& a, const PosedPoint& b, const PosedPoint& c, const PosedPoint& d) noexcept {
    const SixPoints points = six(a, b, c, d);
    return decide(points, round_points(points), [](const auto& signs) { return signs.orient3d(0, 1, 2, 3); });
}

}  // namespace ecods
