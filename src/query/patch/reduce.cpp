#include "query/patch/reduce.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "exact/point/vectors.hpp"

namespace ecods::patches {
namespace {

using exact::cross;
using exact::dot;
using exact::minus;

// A choice of points that ends at some point, with its area.
struct Chain {
    ScaledInteger area;
    std::vector<std::size_t> points;

    bool is_better(const Chain& other) const {
        const int more = compare(area, other.area);
        return more > 0 || (more == 0 && points < other.points);
    }
};

// Returns the differences of all points from the first, in units of a common denominator.
std::vector<ScaledLongVector> from_first(const std::vector<LongPoint>& points) {
    std::vector<ScaledInteger> dens;  // the different ones
    std::vector<std::size_t> den_of;  // by point
    for (const LongPoint& p : points) {
        const auto known = std::ranges::find_if(dens, [&](const ScaledInteger& d) { return compare(d, p.den) == 0; });
        den_of.push_back(static_cast<std::size_t>(known - dens.begin()));
        if (known == dens.end()) dens.push_back(p.den);
    }
    std::vector<ScaledInteger> others(dens.size(), ScaledInteger(1.0));  // by denominator: the product of the others
    for (std::size_t i = 0; i < dens.size(); ++i) {
        for (std::size_t j = 0; j < dens.size(); ++j) {
            if (i != j) others[i] = others[i] * dens[j];
        }
    }
    std::vector<ScaledLongVector> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ScaledInteger& factor = others[den_of[i]];
        const auto& [x, y, z] = points[i].num;
        result.push_back({x * factor, y * factor, z * factor});
        if (i > 0) result[i] = minus(result[i], result[0]);
    }
    result[0] = {};
    return result;
}

// The square of the distance across the normal, times n . n, is (p . p)(n . n) - (p . n)^2.
std::size_t furthest_across(const std::vector<ScaledLongVector>& points, const ScaledLongVector& n) {
    const ScaledInteger nn = dot(n, n);
    std::size_t furthest = 1;
    std::optional<ScaledInteger> most;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const ScaledInteger along = dot(points[i], n);
        ScaledInteger across = dot(points[i], points[i]) * nn - along * along;
        if (most && compare(across, *most) <= 0) continue;
        most = std::move(across);
        furthest = i;
    }
    return furthest;
}

}  // namespace

std::vector<std::size_t> choose_corners(const std::vector<LongPoint>& points, const ScaledLongVector& normal,
                                        std::size_t count) {
    if (count == 1) return {0};
    const std::vector<ScaledLongVector> at = from_first(points);
    if (count == 2) return {0, furthest_across(at, normal)};
    std::vector<std::optional<Chain>> best(at.size());  // by the point at the end
    for (std::size_t i = 1; i < at.size(); ++i) best[i] = Chain{{}, {0, i}};
    for (std::size_t length = 3; length <= count; ++length) {
        std::vector<std::optional<Chain>> longer(at.size());
        for (std::size_t i = length - 1; i < at.size(); ++i) {
            const ScaledLongVector left = cross(normal, at[i]);
            for (std::size_t j = length - 2; j < i; ++j) {
                // [n, a, b] = a . (b x n) = -a . (n x b)
                Chain chain{best[j]->area - dot(at[j], left), best[j]->points};
                chain.points.push_back(i);
                if (!longer[i] || chain.is_better(*longer[i])) longer[i] = std::move(chain);
            }
        }
        best = std::move(longer);
    }
    const Chain* first = nullptr;
    for (const auto& chain : best) {
        if (chain && (first == nullptr || chain->is_better(*first))) first = &*chain;
    }
    return first->points;
}

}  // namespace ecods::patches
