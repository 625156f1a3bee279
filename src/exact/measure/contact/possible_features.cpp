#include "exact/measure/contact/possible_features.hpp"

#include <array>
#include <bit>
#include <cmath>

namespace ecods::exact {
namespace {

// Pairs of corners: bit 3 a + b.
using CornerPairs = std::uint32_t;

// Of each of feature_pairs the pairs of the corners that it is made of.
constexpr std::array<CornerPairs, feature_pairs.size()> corners_of_features = [] {
    std::array<CornerPairs, feature_pairs.size()> result{};
    for (std::size_t k = 0; k < feature_pairs.size(); ++k) {
        const FeaturePair& pair = feature_pairs[k];
        const auto corners = [&](std::size_t side) -> std::uint32_t {
            const std::size_t corner = pair.corner(side);
            if (pair.has_vertex(side)) return 1u << corner;
            return pair.kind == FeatureKind::vertex_face ? 7u : 1u << corner | 1u << next_corner(corner);
        };
        for (std::size_t a = 0; a < 3; ++a) {
            if (corners(0) >> a & 1) result[k] |= corners(1) << 3 * a;
        }
    }
    return result;
}();

class Sieve {
  public:
    Sieve(const MovingPoints& points, const TimeSpan& time) noexcept : corners_(points) {
        if (!corners_.is_bounded()) return;
        const double length = time.to - time.from;
        p_ = corners_.at(time.from + 0.5 * length);
        const Point way = corners_.way();
        for (std::size_t k = 0; k < 3; ++k) error_[k] = corners_.error()[k] + 2.25 * length * way[k];
        for (std::size_t i = 0; i < 3; ++i) {
            a_[i] = minus(p_[next_corner(i)], p_[i]);
            b_[i] = minus(p_[3 + next_corner(i)], p_[3 + i]);
        }
    }

    // Cheap vectors first; mostly one pair is left after them.
    FeatureSet run() noexcept {
        if (!corners_.is_bounded()) return all_features;
        for (const Point& axis : {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}}) look_along(axis);
        const Point normal_a = cross(a_[0], a_[1]), normal_b = cross(b_[0], b_[1]);
        look_along(normal_a);
        look_along(normal_b);
        for (std::size_t i = 0; i < 3; ++i) {
            look_along(cross(normal_a, a_[i]));
            look_along(cross(normal_b, b_[i]));
            for (std::size_t j = 0; j < 3; ++j) look_along(cross(a_[i], b_[j]));
        }
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3 && std::popcount(left_) > 1; ++j) look_past_edges(i, j);
        }
        return left_;
    }

  private:
    // Drops the features that this vector parts.
    void look_along(const Point& n) noexcept {
        const auto on = [&](std::size_t i) { return (n[0] * p_[i][0] + n[1] * p_[i][1]) + n[2] * p_[i][2]; };
        const double bound = ((std::abs(n[0]) * error_[0] + std::abs(n[1]) * error_[1]) + std::abs(n[2]) * error_[2]) +
                             MovingCorners::underflow;
        const double b[3] = {on(3), on(4), on(5)};
        CornerPairs above = 0, below = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double a = on(i);
            for (std::size_t j = 0; j < 3; ++j) {
                above |= CornerPairs{b[j] - a > bound} << (3 * i + j);
                below |= CornerPairs{a - b[j] > bound} << (3 * i + j);
            }
        }
        if ((above | below) == 0) return;
        for (FeatureSet rest = left_; rest != 0; rest &= rest - 1) {
            const CornerPairs pairs = corners_of_features[static_cast<std::size_t>(std::countr_zero(rest))];
            if ((above & pairs) == pairs || (below & pairs) == pairs) left_ &= ~(rest & -rest);
        }
    }

    // Along and across each edge, in the plane of both, and from one of its ends to a corner.
    void look_past_edges(std::size_t i, std::size_t j) noexcept {
        const Point across = cross(a_[i], b_[j]), between = minus(p_[3 + j], p_[i]);
        look_along(a_[i]);
        look_along(b_[j]);
        look_along(cross(across, a_[i]));
        look_along(cross(across, b_[j]));
        look_along(cross(a_[i], cross(between, a_[i])));
        look_along(cross(b_[j], cross(between, b_[j])));
    }

    MovingCorners corners_;
    Points<6> p_;
    Point error_, a_[3], b_[3];
    FeatureSet left_ = all_features;
};

}  // namespace

FeatureSet possible_features(const MovingPoints& points, const TimeSpan& time) noexcept {
    return Sieve(points, time).run();
}

}  // namespace ecods::exact
