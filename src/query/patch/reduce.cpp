#include "query/patch/reduce.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/next.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/point/vectors.hpp"

namespace ecods::patches {
namespace {

using exact::cross;
using exact::dot;
using exact::minus;

// Holds a lower and an upper bound of an area.
struct Bounds {
    double low = 0, high = 0;
};

// Returns bounds of a sum of two areas. An addition is off by less than an ulp in every rounding mode; and by at most 3
// * 2^-1022 if numbers below 2^-1022 count as zeros, which is less than an ulp of a sum of at least 2^-960. separates()
// ignores smaller bounds.
Bounds sum(const Bounds& x, const Bounds& y) noexcept {
    return {next_down(next_down(x.low + y.low)), next_up(next_up(x.high + y.high))};
}
bool separates(const Bounds& more, const Bounds& less) noexcept {
    constexpr double least = 0x1p-960;
    return more.low > less.high && more.low >= least && less.high >= least;
}

// Quotient is the fraction num / den, with den > 0.
struct Quotient {
    ScaledInteger num, den{1.0};
};

// Triangles holds the differences of all points from the first one, and the areas of the triangles that the first point
// makes with two others, seen along the normal. Let point i be N_i / d_i, and M_i = N_i d_0 - N_0 d_i. The area of
// triangle (0, i, j), times 2 |n| d_0^2, is [n, M_i, M_j] / (d_i d_j); this factor is left out everywhere. A sum of
// areas has the denominators of its own points only.
class Triangles {
  public:
    Triangles(const std::vector<LongPoint>& points, const ScaledLongVector& normal) : normal_(normal) {
        const LongPoint& first = points.front();
        for (const LongPoint& p : points) {
            ScaledLongVector from_first;
            for (std::size_t k = 0; k < 3; ++k) from_first[k] = p.num[k] * first.den - first.num[k] * p.den;
            at_.push_back(std::move(from_first));
            dens_.push_back(p.den);
        }
        bounds_.resize(points.size() * points.size());
        areas_.resize(points.size() * points.size());
        for (std::size_t j = 1; j < points.size(); ++j) {
            const ScaledLongVector left = cross(normal, at_[j]);
            for (std::size_t i = 1; i < j; ++i) set(i, j, -dot(at_[i], left));
        }
    }

    const Bounds& bounds(std::size_t i, std::size_t j) const noexcept { return bounds_[i * at_.size() + j]; }
    Quotient area(std::size_t i, std::size_t j) const { return {areas_[i * at_.size() + j], dens_[i] * dens_[j]}; }
    // Returns the squared distance, across the normal, of point i from the first one, times n . n d_0^2. Of a vector p
    // this is (p . p)(n . n) - (p . n)^2.
    Quotient across(std::size_t i) const {
        const ScaledInteger along = dot(at_[i], normal_);
        return {dot(at_[i], at_[i]) * dot(normal_, normal_) - along * along, dens_[i] * dens_[i]};
    }

  private:
    void set(std::size_t i, std::size_t j, ScaledInteger area) {
        const ScaledInteger den = dens_[i] * dens_[j];
        Bounds& bounds = bounds_[i * at_.size() + j];
        if (den.m().limbs().size() <= exact::divisor_limbs) {
            const double rounded =
                exact::round_quotient(area.m().limbs(), den.m().limbs(), area.e() - den.e(), area.sign() < 0);
            bounds = {next_down(rounded), next_up(rounded)};
        } else {
            bounds = {0, std::numeric_limits<double>::infinity()};
        }
        areas_[i * at_.size() + j] = std::move(area);
    }

    const ScaledLongVector& normal_;
    std::vector<ScaledLongVector> at_;
    std::vector<ScaledInteger> dens_;
    std::vector<Bounds> bounds_;        // of triangles (0, i, j), i < j
    std::vector<ScaledInteger> areas_;  // their numerators
};

// A Chain is a choice of points in ascending order, with bounds of the area of their polygon.
struct Chain {
    Bounds area;
    std::vector<std::size_t> points;

    bool has(std::size_t i, std::size_t j) const noexcept {
        const auto found = std::ranges::find(points, i);
        return found != points.end() && found + 1 != points.end() && *(found + 1) == j;
    }
};

// Returns the sign of (area of x) - (area of y).
int compare(const Chain& x, const Chain& y, const Triangles& triangles) {
    if (separates(x.area, y.area)) return 1;
    if (separates(y.area, x.area)) return -1;
    Quotient difference;
    const auto add = [&](const Chain& of, const Chain& other, bool is_minus) {
        for (std::size_t k = 2; k < of.points.size(); ++k) {
            const std::size_t i = of.points[k - 1], j = of.points[k];
            if (other.has(i, j)) continue;
            const Quotient area = triangles.area(i, j);
            const ScaledInteger part = area.num * difference.den;
            difference.num = difference.num * area.den + (is_minus ? -part : part);
            difference.den = difference.den * area.den;
        }
    };
    add(x, y, false);
    add(y, x, true);
    return difference.num.sign();
}

bool is_better(const Chain& x, const Chain& y, const Triangles& triangles) {
    const int more = compare(x, y, triangles);
    return more > 0 || (more == 0 && x.points < y.points);
}

std::size_t furthest_across(const Triangles& triangles, std::size_t count) {
    std::size_t furthest = 1;
    Quotient most = triangles.across(1);
    for (std::size_t i = 2; i < count; ++i) {
        Quotient across = triangles.across(i);
        if (compare(across.num * most.den, most.num * across.den) <= 0) continue;
        most = std::move(across);
        furthest = i;
    }
    return furthest;
}

}  // namespace

std::vector<std::size_t> choose_corners(const std::vector<LongPoint>& points, const ScaledLongVector& normal,
                                        std::size_t count) {
    if (count == 1) return {0};
    const Triangles triangles(points, normal);
    if (count == 2) return {0, furthest_across(triangles, points.size())};
    std::vector<std::optional<Chain>> best(points.size());  // by the point at the end
    for (std::size_t i = 1; i < points.size(); ++i) best[i] = Chain{{}, {0, i}};
    for (std::size_t length = 3; length <= count; ++length) {
        std::vector<std::optional<Chain>> longer(points.size());
        for (std::size_t j = length - 1; j < points.size(); ++j) {
            for (std::size_t i = length - 2; i < j; ++i) {
                Chain chain{sum(best[i]->area, triangles.bounds(i, j)), best[i]->points};
                chain.points.push_back(j);
                if (!longer[j] || is_better(chain, *longer[j], triangles)) longer[j] = std::move(chain);
            }
        }
        best = std::move(longer);
    }
    const Chain* first = nullptr;
    for (const auto& chain : best) {
        if (chain && (first == nullptr || is_better(*chain, *first, triangles))) first = &*chain;
    }
    return first->points;
}

}  // namespace ecods::patches
