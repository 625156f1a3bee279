#include "query/depth/exact_depth_along.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

#include "exact/number/integer.hpp"
#include "query/depth/exact_expansion.hpp"

namespace ecods::depths {
namespace {

using exact::Integer;

// A Direction is a direction as integers in a unit of its own.
struct Direction {
    std::array<exact::Dyadic, 3> x;
    exact::BitRange digits;

    explicit Direction(const Vec3& d) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            x[k] = exact::decode(d[static_cast<Eigen::Index>(k)]);
            digits.include(x[k]);
        }
    }
    template <int L>
    exact::LimbVector<L> in_limbs() const noexcept {
        exact::LimbVector<L> result;
        for (std::size_t k = 0; k < 3; ++k) {
            exact::Limbs<L> limbs{};
            if (x[k].m != 0) exact::add_term(limbs, exact::Int128{x[k].m}, x[k].e - digits.low);
            result[k] = exact::magnitude<L>(limbs);
        }
        return result;
    }
};

// LeftFirst orders planes by the parameters at which a line from the origin leaves through the planes.
template <int L>
struct LeftFirst {
    exact::LimbVector<L> d;

    exact::Magnitude<3 * L> along(const ExactPlane<L>& plane) const noexcept {
        return exact::dot<2 * L, L>(plane.n, d);
    }

    // Returns 0 for planes that have the origin beyond them, 1 for planes through the origin, 2 for planes that the
    // line meets, and 3 for others.
    int rank(const ExactPlane<L>& plane) const noexcept {
        return plane.side < 0 ? 0 : plane.side == 0 ? 1 : exact::sign<3 * L>(along(plane)) > 0 ? 2 : 3;
    }
    int operator()(const ExactPlane<L>& x, const ExactPlane<L>& y) const noexcept {
        const int of_x = rank(x), of_y = rank(y);
        if (of_x != of_y) return of_x < of_y ? -1 : 1;
        if (of_x != 2) return 0;
        exact::Limbs<6 * L> sum{};
        exact::add_product<3 * L, 3 * L>(sum, x.h, along(y));
        exact::add_product<3 * L, 3 * L>(sum, y.h, along(x), exact::all_ones);
        return exact::sign<6 * L>(sum);
    }
};

template <int L>
Integer integer(const exact::Magnitude<L>& x) {
    return {exact::without_leading_zeros(x.limbs), x.negative != 0};
}

// Sets result.parameter to h / n . d, for the plane n . x = h, and result.length to the parameter times |d|.
template <int L>
void measure(const ExactPlane<L>& plane, const LeftFirst<L>& order, int unit, int unit_of_d, ExactDepthAlong& result) {
    if (plane.side == 0) return;
    const Integer h = integer<3 * L>(plane.h), along = integer<3 * L>(order.along(plane));
    Integer dd;
    for (const auto& x : order.d) dd = dd + integer<L>(x) * integer<L>(x);
    const double parameter = exact::round_quotient(h.limbs(), along.limbs(), unit - unit_of_d, false);
    result.parameter = std::max(parameter, std::numeric_limits<double>::denorm_min());
    result.length = exact::round_root((h * h * dd).limbs(), (along * along).limbs(), unit);
}

}  // namespace

std::optional<ExactDepthAlong> exact_depth_along(const ConvexPair& pair, const Vec3& d) {
    const PairTerms terms(pair);
    const Direction direction(d);
    const int bits = std::max(terms.bits(), direction.digits.width() + exact::sum_bits);
    return exact::with_limb_count<2>(bits,
                                     [&]<int L>(std::integral_constant<int, L>) -> std::optional<ExactDepthAlong> {
                                         const ExactDifferences<L> points(pair, terms);
                                         const LeftFirst<L> order{direction.in_limbs<L>()};
                                         ExactExpansion<L, LeftFirst<L>> expansion(points, order);
                                         const auto found = expansion.find();
                                         if (!found) return std::nullopt;
                                         ExactDepthAlong result;
                                         result.face = found->face;
                                         result.normal = exact::round_direction<2 * L>(found->plane->n);
                                         measure<L>(*found->plane, order, points.unit(), direction.digits.low, result);
                                         return result;
                                     });
}

}  // namespace ecods::depths
