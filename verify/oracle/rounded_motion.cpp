#include "oracle/rounded_motion.hpp"

#include <bit>
#include <cstdint>

#include "oracle/triangle_distance.hpp"

namespace ecods::oracle {
namespace {

TriangleOf<mpz_class> in_units(const RoundedMotion::Corners& corners, const mpz_class& unit) {
    std::array<Vector<mpz_class>, 3> result;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) result[i][k] = mpq_class(corners[i][k] * unit).get_num();
    }
    return TriangleOf<mpz_class>(result);
}

mpz_class common_unit(const RoundedMotion::Corners& a, const RoundedMotion::Corners& b) {
    mpz_class unit = 1;
    for (const RoundedMotion::Corners* const corners : {&a, &b}) {
        for (const auto& corner : *corners) {
            for (const mpq_class& x : corner) unit = lcm(unit, x.get_den());
        }
    }
    return unit;
}

bool pierce(const TriangleOf<mpz_class>& s, const TriangleOf<mpz_class>& t) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (pierces(s, i, t).may_be) return true;
    }
    return false;
}

}  // namespace

RoundedMotion::Corners RoundedMotion::moved(const mpq_class& time) const {
    Corners result = a_;
    for (auto& corner : result) {
        for (std::size_t k = 0; k < 3; ++k) corner[k] += time * motion_[k];
    }
    return result;
}

std::array<Vector<mpq_class>, 2> RoundedMotion::closest(const mpq_class& time) const {
    const Corners first = moved(time);
    const mpz_class unit = common_unit(first, b_);
    const TriangleOf<mpz_class> a = in_units(first, unit), b = in_units(b_, unit);
    std::optional<mpq_class> least;
    const FeaturePair* best = nullptr;
    for (const FeaturePair& pair : feature_pairs()) {
        const FeatureDistance<mpz_class> d = feature_distance(pair, a, b);
        if (!d.is_inside) continue;
        mpq_class square(d.num, d.den);
        square.canonicalize();
        if (least && square >= *least) continue;
        least = square;
        best = &pair;
    }
    std::array<Vector<mpq_class>, 2> result;
    const auto points = closest_points(*best, a, b);
    for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t k = 0; k < 3; ++k) {
            result[side][k] = mpq_class(points[side].num[k], points[side].den * unit);
            result[side][k].canonicalize();
        }
    }
    return result;
}

mpq_class RoundedMotion::squared(const mpq_class& time) const {
    const Corners first = moved(time);
    const mpz_class unit = common_unit(first, b_);
    const TriangleOf<mpz_class> a = in_units(first, unit), b = in_units(b_, unit);
    if (pierce(a, b) || pierce(b, a)) return 0;
    std::optional<mpq_class> least;
    for (const FeaturePair& pair : feature_pairs()) {
        const FeatureDistance<mpz_class> d = feature_distance(pair, a, b);
        if (!d.is_inside) continue;
        mpq_class square(d.num, d.den);
        square.canonicalize();
        if (!least || square < *least) least = square;
    }
    return *least / (unit * unit);
}

// The distance is a convex function of time. So before the first time it is more than p and falls.
std::optional<double> RoundedMotion::first(double last) const {
    const auto is_before = [&](const mpq_class& time) {
        const mpq_class square = squared(time);
        if (square <= square_) return false;
        mpq_class later = time;
        mpz_class den = 1;
        den <<= 200;
        later += time / mpq_class(den);
        return squared(later) < square;
    };
    if (is_before(exactly(last))) return std::nullopt;
    std::uint64_t low = 0, high = std::bit_cast<std::uint64_t>(last);
    while (low < high) {
        const std::uint64_t middle = low + (high - low) / 2;
        is_before(middle_above(middle)) ? low = middle + 1 : high = middle;
    }
    const double time = std::bit_cast<double>(low);
    // The real times that round to this double: the triangles may be near in a part of them alone.
    mpq_class from = low == 0 ? mpq_class(0) : middle_above(low - 1), to = middle_above(low);
    if (to > exactly(last)) to = exactly(last);
    for (int i = 0; i < 120; ++i) {
        if (is_near(to)) return time;
        const mpq_class middle = (from + to) / 2;
        is_before(middle) ? from = middle : to = middle;
    }
    return std::nullopt;
}

bool RoundedMotion::is_last(double time) const {
    const auto bits = std::bit_cast<std::uint64_t>(time);
    return (bits == 0 || is_near(middle_above(bits - 1))) && !is_near(middle_above(bits));
}

}  // namespace ecods::oracle
