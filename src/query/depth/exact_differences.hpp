// ExactDifferences computes the vertices of two posed convex solids, and differences of these vertices, as integers of
// L limbs in one common unit.
//
// Widths. Products and translations are below 2^high and multiples of 2^unit. A point, relative to the first solid's
// translation, is a sum of three products and two translations. The difference of two points is below 2^(high + 4). The
// difference m of two such differences, an edge of the Minkowski difference, is below 2^(high + 5). With high - unit +
// sum_bits <= 64 L all differences are below 2^k, k = 64 L - 2. The widths of products follow as in
// exact/measure/distance/exact_features.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "exact/measure/round/limb_vectors.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/limbs.hpp"
#include "exact/point/pose_terms.hpp"
#include "query/depth/convex_pair.hpp"
#include "query/depth/difference_face.hpp"

namespace ecods::depths {

// PairTerms holds the poses of both solids as sums of terms. Translations are relative to the first solid's
// translation.
struct PairTerms {
    explicit PairTerms(const ConvexPair& pair) noexcept {
        for (std::size_t side = 0; side < 2; ++side) {
            of[side].set(*pair[side].body.pose, pair[0].body.pose->t);
            digits.include(of[side].digits(pair[side].body.extent->digits));
        }
    }
    int unit() const noexcept { return digits.empty() ? 0 : digits.low; }
    int bits() const noexcept { return digits.width() + exact::sum_bits; }

    std::array<exact::PoseTerms, 2> of;
    exact::BitRange digits;  // digits that the vertices of both solids may have
};

template <int L>
class ExactDifferences {
  public:
    using Point = std::array<exact::Limbs<L>, 3>;
    using Normal = exact::LimbVector<2 * L>;

    static constexpr int k = 64 * L - 2;
    static_assert(2 * k + 2 < 64 * (2 * L));
    static_assert(3 * k + 3 < 64 * (3 * L));
    static_assert(4 * k + 4 < 64 * (4 * L));

    ExactDifferences(const ConvexPair& pair, const PairTerms& terms) noexcept : pair_(pair), terms_(terms) {}

    int unit() const noexcept { return terms_.unit(); }
    const convex::Hull& hull(std::size_t side) const noexcept { return *pair_[side].hull; }

    Point point(std::size_t side, std::uint32_t vertex) const noexcept {
        return terms_.of[side].template point_in<exact::Limbs<L>>(unit(), pair_[side].vertex(vertex));
    }

    Point difference(const DifferenceVertex& v) const noexcept {
        const Point p = point(0, v.p), q = point(1, v.q);
        Point result;
        for (std::size_t i = 0; i < 3; ++i) result[i] = exact::subtract<L>(p[i], q[i]);
        return result;
    }

    // Returns the sign of (height of vertex `to` - height of vertex `from`). Heights are along n for the first solid,
    // and against n for the second.
    int beyond(std::size_t side, const Normal& n, const Point& from, const Point& to) const noexcept {
        const int s = exact::sign<3 * L>(exact::dot<2 * L, L>(n, exact::difference<L>(to, from)));
        return side == 0 ? s : -s;
    }

    // Returns a vertex of one solid that is extreme along n (for the second solid, against n), and the edges from the
    // vertex to vertices that are as far.
    convex::Furthest furthest(std::size_t side, const Normal& n, std::uint32_t from) const {
        const auto signs = [&](std::uint32_t vertex, std::span<const convex::Hull::Neighbor> neighbors) {
            std::array<int, convex::signs_at_once> result{};
            const Point at = point(side, vertex);
            for (std::size_t i = 0; i < neighbors.size() && (i == 0 || result[i - 1] <= 0); ++i)
                result[i] = beyond(side, n, at, point(side, neighbors[i].vertex));
            return result;
        };
        return convex::climb(*pair_[side].hull, from, signs);
    }

  private:
    const ConvexPair& pair_;
    const PairTerms& terms_;
};

}  // namespace ecods::depths
