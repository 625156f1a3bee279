#include "exact/measure/contact/possible_features.hpp"

#include <bit>
#include <cmath>

namespace ecods::exact {
namespace {

class Sieve {
  public:
    Sieve(const MovingPoints& points, const TimeSpan& time) noexcept {
        const MovingCorners corners(points);
        is_bounded_ = corners.is_bounded();
        if (!is_bounded_) return;
        const double length = time.to - time.from;
        p_ = corners.at(time.from + 0.5 * length);
        const Point way = corners.way();
        for (std::size_t k = 0; k < 3; ++k) error_[k] = corners.error()[k] + 2.25 * length * way[k];
        edges_ = edges_of(p_);
    }
    Sieve(const TurningPoints& points, const TimeSpan& time) noexcept : Sieve(TurningCorners(points), time) {}
    Sieve(const BothTurningPoints& points, const TimeSpan& time) noexcept : Sieve(BothTurningCorners(points), time) {}
    Sieve(const TurnAndStraightPoints& points, const TimeSpan& time) noexcept
        : Sieve(TurnAndStraightCorners(points), time) {}

    template <class Corners>
    Sieve(const Corners& corners, const TimeSpan& time) noexcept {
        is_bounded_ = corners.is_bounded();
        if (!is_bounded_) return;
        const double length = time.to - time.from;
        const typename Corners::At at = corners.at(time.from + 0.5 * length);
        p_ = at.points;
        const double way = corners.way(at, length);
        for (std::size_t k = 0; k < 3; ++k) error_[k] = at.error[k] + 1.125 * way;
        edges_ = edges_of(p_);
    }

    // Returns the pairs of features that may share a point. Tries vectors that are cheap to compute first; after these
    // vectors, usually one pair is left.
    FeatureSet run() noexcept {
        if (!is_bounded_) return all_features;
        for (const Point& axis : {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}}) look_along(axis);
        const auto& [a, b] = edges_;
        const Point normal_a = cross(a[0], a[1]), normal_b = cross(b[0], b[1]);
        look_along(normal_a);
        look_along(normal_b);
        for (std::size_t i = 0; i < 3; ++i) {
            look_along(cross(normal_a, a[i]));
            look_along(cross(normal_b, b[i]));
            for (std::size_t j = 0; j < 3; ++j) look_along(cross(a[i], b[j]));
        }
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3 && std::popcount(left_) > 1; ++j) look_past_edges(i, j);
        }
        return left_;
    }

  private:
    // Removes the pairs of features that vector n certainly separates from left_.
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

    // Tries more separating vectors for edge i of the first and edge j of the second triangle: along each edge;
    // perpendicular to it in the plane that is parallel to both; and perpendicular to it towards the start of the other
    // edge.
    void look_past_edges(std::size_t i, std::size_t j) noexcept {
        const Point between = minus(p_[3 + j], p_[i]), across = cross(edges_[0][i], edges_[1][j]);
        for (const Point& edge : {edges_[0][i], edges_[1][j]}) {
            look_along(edge);
            look_along(cross(across, edge));
            look_along(cross(edge, cross(between, edge)));
        }
    }

    bool is_bounded_ = false;
    Points<6> p_;
    Point error_;
    TriangleEdges edges_;
    FeatureSet left_ = all_features;
};

}  // namespace

FeatureSet possible_features(const MovingPoints& points, const TimeSpan& time) noexcept {
    return Sieve(points, time).run();
}

FeatureSet possible_features(const TurningPoints& points, const TimeSpan& time) noexcept {
    return Sieve(points, time).run();
}

FeatureSet possible_features(const BothTurningPoints& points, const TimeSpan& time) noexcept {
    return Sieve(points, time).run();
}

FeatureSet possible_features(const TurnAndStraightPoints& points, const TimeSpan& time) noexcept {
    return Sieve(points, time).run();
}

}  // namespace ecods::exact
