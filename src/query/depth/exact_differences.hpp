// The vertices of two posed convex solids, and their differences, as integers of L limbs in one unit.
//
// Widths. Products and translations are below 2^high and multiples of 2^unit. A point, counted from the first solid's
// translation, is a sum of three products and two translations, the difference of two points is below 2^(high + 4), and
// the difference m of two of these, an edge of the set of differences, below 2^(high + 5). With high - unit + sum_bits
// <= 64 L all differences are below 2^k, k = 64 L - 2; the widths of products follow as in
// exact/measure/distance/exact_features.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "exact/measure/round/limb_vectors.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/limbs.hpp"
#include "exact/point/integer_points.hpp"
#include "query/depth/convex_pair.hpp"
#include "query/depth/difference_face.hpp"

namespace ecods::depths {

// Where integer points are counted from, and in what.
struct PointScale {
    // t - t0 by row, as one difference or, where their digits are too far apart, as two terms.
    std::array<std::array<exact::DyadicDifference, 2>, 3> offset{};
    exact::BitRange digits;

    int unit() const noexcept { return digits.empty() ? 0 : digits.low; }
    int bits() const noexcept { return digits.width() + exact::sum_bits; }
};

inline PointScale find_scale(const ConvexPair& pair) noexcept {
    PointScale scale;
    for (const ConvexBody& side : pair) {
        for (int column = 0; column < 3; ++column) {
            exact::BitRange r;
            for (int row = 0; row < 3; ++row) r.include(exact::decode(side.body.pose->R(row, column)));
            scale.digits.include(r * side.body.extent->digits[static_cast<std::size_t>(column)]);
        }
    }
    for (std::size_t row = 0; row < 3; ++row) {
        const auto at = static_cast<Eigen::Index>(row);
        const exact::Dyadic t0 = exact::decode(pair[0].body.pose->t[at]), t = exact::decode(pair[1].body.pose->t[at]);
        if (const auto difference = exact::subtract(t, t0)) {
            scale.offset[row][0] = *difference;
        } else {
            scale.offset[row] = {{{t.m, t.e}, {-t0.m, t0.e}}};
        }
        for (const exact::DyadicDifference& term : scale.offset[row]) scale.digits.include(term.digits());
    }
    return scale;
}

template <int L>
class ExactDifferences {
  public:
    using Point = std::array<exact::Limbs<L>, 3>;
    using Normal = exact::LimbVector<2 * L>;

    static constexpr int k = 64 * L - 2;
    static_assert(2 * k + 2 < 64 * (2 * L));
    static_assert(3 * k + 3 < 64 * (3 * L));
    static_assert(4 * k + 4 < 64 * (4 * L));

    ExactDifferences(const ConvexPair& pair, const PointScale& scale) noexcept : pair_(pair), scale_(scale) {}

    int unit() const noexcept { return scale_.unit(); }
    const convex::Hull& hull(std::size_t side) const noexcept { return *pair_[side].hull; }

    Point point(std::size_t side, std::uint32_t vertex) const noexcept {
        Point result{};
        const Vec3& v = pair_[side].vertex(vertex);
        const Mat3& R = pair_[side].body.pose->R;
        for (int column = 0; column < 3; ++column) {
            const exact::Dyadic x = exact::decode(v[column]);
            if (x.m == 0) continue;
            for (int row = 0; row < 3; ++row) {
                const exact::Dyadic r = exact::decode(R(row, column));
                if (r.m == 0) continue;
                exact::add_shifted<L>(result[static_cast<std::size_t>(row)], exact::Int128{r.m} * x.m,
                                      r.e + x.e - unit());
            }
        }
        if (side == 0) return result;
        for (std::size_t row = 0; row < 3; ++row) {
            for (const exact::DyadicDifference& term : scale_.offset[row]) {
                if (term.m != 0) add_term(result[row], term);
            }
        }
        return result;
    }

    Point difference(const DifferenceVertex& v) const noexcept {
        const Point p = point(0, v.p), q = point(1, v.q);
        Point result;
        for (std::size_t i = 0; i < 3; ++i) result[i] = exact::subtract<L>(p[i], q[i]);
        return result;
    }

    // The sign of how much further along n vertex `to` of the first solid is than `from`; of the second, against n.
    int beyond(std::size_t side, const Normal& n, const Point& from, const Point& to) const noexcept {
        const int s = exact::sign<3 * L>(exact::dot<2 * L, L>(n, exact::difference<L>(to, from)));
        return side == 0 ? s : -s;
    }

    // A vertex of one solid than which none is further along n, or against n for the second, and what is as far.
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
    // A term is a multiple of the unit, which its own exponent may be below.
    void add_term(exact::Limbs<L>& sum, const exact::DyadicDifference& term) const noexcept {
        const int shift = term.e - unit();
        if (shift >= 0) {
            exact::add_shifted<L>(sum, term.m, shift);
        } else {
            exact::add_shifted<L>(sum, term.m >> -shift, 0);
        }
    }

    const ConvexPair& pair_;
    const PointScale& scale_;
};

}  // namespace ecods::depths
