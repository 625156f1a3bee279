#include "base/assert.hpp"
#include "ecods/primitives.hpp"
#include "exact/point/integer_points.hpp"
#include "exact/point/posed_points.hpp"
#include "exact/sign/exact_signs.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/sign/filtered_signs.hpp"

namespace ecods {
namespace {

using namespace exact;

const Pose identity;

// Returns ask(signs), the sign of one determinant. `signs` is first the filter; if the filter's sign is 0 (unknown),
// `signs` computes in integers.
template <std::size_t N, class Ask>
Sign decide(const PosedPoints<N>& exact, const RoundedPoints<N>& rounded, Ask&& ask) noexcept {
    const DeterminantBounds bounds = determinant_bounds(rounded.points, rounded.delta);
    if (const int s = ask(FilterSigns<N>(rounded.points, bounds))) return static_cast<Sign>(s);
    return static_cast<Sign>(with_integers(exact, [&](const auto& points) { return ask(ExactSigns(points)); }));
}

constexpr auto ask_orient3d = [](const auto& signs) { return signs.orient3d(0, 1, 2, 3); };

template <std::size_t N>
PosedPoints<N> refer_to(const std::array<const Vec3*, N>& points) noexcept {
    PosedPoints<N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = {&identity, points[i]};
    return result;
}
template <std::size_t N>
PosedPoints<N> refer_to(const std::array<const PosedPoint*, N>& points) noexcept {
    PosedPoints<N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = {&points[i]->pose, &points[i]->v};
    return result;
}

}  // namespace

Sign orient2d(const Vec2& a, const Vec2& b, const Vec2& c) noexcept {
    // The points are in the plane z = 0, seen along z.
    const Vec3 p(a[0], a[1], 0), q(b[0], b[1], 0), r(c[0], c[1], 0);
    const PosedPoints<3> points = refer_to(std::array{&p, &q, &r});
    return decide(points, plain_points(points), [](const auto& signs) { return signs.orient2d(0, 1, 2, 2); });
}

Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept {
    const PosedPoints<4> points = refer_to(std::array{&a, &b, &c, &d});
    return decide(points, plain_points(points), ask_orient3d);
}

Sign orient2d(const PosedPoint& a, const PosedPoint& b, const PosedPoint& c, int axis) noexcept {
    ECODS_ASSERT(axis >= 0 && axis < 3);
    const PosedPoints<3> points = refer_to(std::array{&a, &b, &c});
    return decide(points, round_points(points), [axis](const auto& signs) { return signs.orient2d(0, 1, 2, axis); });
}

Sign orient3d(const PosedPoint& a, const PosedPoint& b, const PosedPoint& c, const PosedPoint& d) noexcept {
    const PosedPoints<4> points = refer_to(std::array{&a, &b, &c, &d});
    return decide(points, round_points(points), ask_orient3d);
}

}  // namespace ecods
