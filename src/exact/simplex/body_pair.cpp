#include "exact/simplex/body_pair.hpp"

#include <algorithm>

#include "exact/point/pose_point.hpp"
#include "exact/sign/difference_signs.hpp"
#include "exact/sign/edge_axes.hpp"
#include "exact/sign/filter.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/sign/filtered_signs.hpp"
#include "exact/sign/kernel_signs.hpp"
#include "exact/sign/regular.hpp"
#include "geometry/same_bits.hpp"

namespace ecods::exact {
namespace {

const Pose identity;

// Exact if every coordinate is a multiple of the unit, and the quotient a double: a quotient is rounded correctly.
void divide(Point& p, const Vec3& unit) noexcept {
    for (std::size_t k = 0; k < 3; ++k) p[k] /= unit[static_cast<Eigen::Index>(k)];
}

}  // namespace

BodyPair::BodyPair() = default;

void BodyPair::bind(const BodySide& a, const BodySide& b) {
    sides_[0].body = a;
    sides_[1].body = b;
    // A common affine bijection changes no answer: bodies with one regular pose are compared where they were modelled.
    if (same_bits(*a.pose, *b.pose) && is_regular(a.pose->R)) sides_[0].body.pose = sides_[1].body.pose = &identity;
    sides_[0].offset = Vec3::Zero();
    sides_[1].offset = sides_[1].body.pose->t - sides_[0].body.pose->t;
    forget_points();
    exact_state_ = ExactState::not_prepared;
    plain_is_exact_ = false;
    differences_are_exact_ = false;
    is_counted_ = false;
    find_bounds();
}

void BodyPair::forget_points() noexcept {
    for (Side& side : sides_) {
        side.rounded.clear();
        side.one_limb.clear();
        side.two_limbs.clear();
    }
}

// Bounds over the boxes of the two bodies: |R| times half the mesh's box around its centre.
void BodyPair::find_bounds() {
    delta_ = 0;
    Vec3 low = Vec3::Constant(infinite_bound);
    Vec3 high = -low;
    for (const Side& side : sides_) {
        const MeshExtent& extent = *side.body.extent;
        const Mat3& R = side.body.pose->R;
        delta_ = std::max(delta_, point_error_bound(R, extent.magnitude, side.offset));
        const Vec3 center = R * extent.center + side.offset;
        const Vec3 half = R.cwiseAbs() * extent.half;
        low = low.cwiseMin(center - half);
        high = high.cwiseMax(center + half);
    }
    // The extents have roundings of their own: each of center, half and their sums is within delta of its value.
    extent_ = high - low + Vec3::Constant(8 * delta_);
    static_bound_ = orient3d_bound(difference_bound({extent_[0], extent_[1], extent_[2]}, delta_));
}

void BodyPair::pose(const Side& side, std::uint32_t vertex, Point& p) const {
    p = pose_point(side.body.pose->R, side.body.mesh->vertices()[vertex], side.offset);
    if (is_counted_) divide(p, unit_);
}

ECODS_ALWAYS_INLINE const Point& BodyPair::rounded_point(Side& side, std::uint32_t vertex) {
    return side.rounded.get(vertex, [&](Point& p) { pose(side, vertex, p); });
}

Relation BodyPair::relation(std::uint32_t a, std::uint32_t b) {
    ++counts_.triangle_tests;
    const Triangle& ta = sides_[0].body.mesh->triangles()[a];
    const Triangle& tb = sides_[1].body.mesh->triangles()[b];
    SixRounded points;
    for (std::size_t i = 0; i < 3; ++i) {
        points[i] = rounded_point(sides_[0], ta[i]);
        points[3 + i] = rounded_point(sides_[1], tb[i]);
    }
    if (plain_is_exact_) return decide_plainly(points);
    if (differences_are_exact_) return decide_by_differences(points);
    FilterTrace trace;
    const FilterAnswer answer = filter(points, static_bound_, trace);
    return decide(ta, tb, points, answer, trace);
}

// Counts what the filter decided, and decides the rest.
inline Relation BodyPair::decide(const Triangle& a, const Triangle& b, const SixRounded& points, FilterAnswer answer,
                                 const FilterTrace& trace) {
    if (answer == FilterAnswer::unknown) [[unlikely]]
        return decide_open(a, b, points, trace);
    ++counts_.filter_passes;
    return answer == FilterAnswer::disjoint ? Relation::disjoint : Relation::crossing;
}

Relation BodyPair::decide_plainly(const SixRounded& points) {
    ++counts_.local_passes;
    PlainSigns signs(points);
    return triangle_pair(signs);
}

Relation BodyPair::decide_by_differences(const SixRounded& points) {
    DifferenceSigns signs(points, to_integers_);
    const Relation relation = triangle_pair(signs);
    ++(signs.has_used_integers() ? counts_.one_limb : counts_.semi_static_passes);
    return relation;
}

[[gnu::noinline]] Relation BodyPair::decide_open(const Triangle& a, const Triangle& b, const SixRounded& points,
                                                 const FilterTrace& trace) {
    if (exact_state_ == ExactState::not_prepared) prepare_exact();
    if (plain_is_exact_) {
        if (!is_counted_) return decide_plainly(points);
        SixRounded counted = points;
        for (Point& p : counted) divide(p, unit_);
        return decide_plainly(counted);
    }
    if (differences_are_exact_) return decide_by_differences(points);
    const PairBound bound = pair_bound(points, delta_);
    switch (filter_again(points, bound.orient3d, trace)) {
        case FilterAnswer::disjoint:
            ++counts_.semi_static_passes;
            return Relation::disjoint;
        case FilterAnswer::crossing:
            ++counts_.semi_static_passes;
            return Relation::crossing;
        case FilterAnswer::unknown:
            break;
    }
    const bool may_be_flat = certain_normal_axis(points, 0, bound) < 0 || certain_normal_axis(points, 1, bound) < 0;
    if (may_be_flat && edges_separate(points, bound.orient3d)) {
        ++counts_.semi_static_passes;
        return Relation::disjoint;
    }
    return use_kernel(a, b, [&](const auto& kernel) {
        FilteredSigns signs(points, bound, trace, kernel);
        return triangle_pair(signs);
    });
}

// Finds out, once for a pair of bodies, how wide their exact coordinates are.
void BodyPair::prepare_exact() {
    BitRange digits;
    for (const Side& side : sides_) {
        for (int column = 0; column < 3; ++column) {
            BitRange r;
            for (int row = 0; row < 3; ++row) r.include(decode(side.body.pose->R(row, column)));
            digits.include(r * side.body.extent->digits[static_cast<std::size_t>(column)]);
        }
    }
    // The difference, not the translations, is in the coordinates: near bodies far from the origin have short ones.
    std::array<DyadicDifference, 3> offset;
    for (std::size_t row = 0; row < 3; ++row) {
        const auto at = static_cast<Eigen::Index>(row);
        const auto difference = subtract(decode(sides_[1].body.pose->t[at]), decode(sides_[0].body.pose->t[at]));
        if (!difference) {
            exact_state_ = ExactState::too_wide;
            return;
        }
        offset[row] = *difference;
        digits.include(difference->digits());
    }
    // A coordinate is a sum of three products and a translation: two more bits. With two limbs differences are made, of
    // one bit more.
    if (digits.width() + 2 <= OneLimbKernel::coordinate_bits) {
        exact_state_ = ExactState::one_limb_fits;
    } else if (digits.width() + 3 <= TwoLimbKernel::coordinate_bits) {
        exact_state_ = ExactState::two_limbs_fit;
    } else {
        exact_state_ = ExactState::too_wide;
        return;
    }
    exact_low_ = digits.empty() ? 0 : digits.low;
    for (std::size_t row = 0; row < 3; ++row) exact_offset_[row] = offset[row].at(exact_low_);
    if (!points_are_doubles(digits)) return;
    plain_is_exact_ = digits.empty() || are_short(Vec3::Constant(std::ldexp(1.0, digits.low)));
    if (plain_is_exact_) return;
    const Vec3 unit = common_unit(offset);
    if (are_short(unit)) return count_in(unit);
    differences_are_exact_ = true;
    to_integers_ = std::ldexp(1.0, -exact_low_);
}

// Whether points of these digits are posed without a rounding error, none of the numbers near the ends of the range of
// doubles: every partial sum of R v + d is a multiple of 2^low below 2^(high + 3), hence a double.
bool BodyPair::points_are_doubles(const BitRange& digits) const {
    if (digits.empty()) return true;
    if (digits.width() + 3 > mantissa_bits || digits.low < -300 || digits.high > 200) return false;
    for (const Side& side : sides_) {
        for (int i = 0; i < 9; ++i) {
            const Dyadic r = decode(side.body.pose->R.data()[i]);
            if (r.m != 0 && (r.e < -300 || r.e > 200)) return false;
        }
        for (const BitRange& v : side.body.extent->digits) {
            if (!v.empty() && (v.low < -300 || v.high > 300)) return false;
        }
        for (int row = 0; row < 3; ++row) {
            const Dyadic t = decode(side.body.pose->t[row]);
            if (t.m != 0 && (t.e < -300 || t.e > 200)) return false;
        }
    }
    return true;
}

// Whether plain double makes no rounding error with points whose coordinates are doubles and multiples of `unit`, by
// axis. Counted in units, let differences be integers of at most E0, E1 and E2, all of them at least 1. Products of two
// are at most Ei Ej, minors 2 Ei Ej, the three terms of a determinant 2 E0 E1 E2, and their sum 6 E0 E1 E2. With
// E0 E1 E2 <= 2^50 all are integers below 2^53, hence doubles (the last factor, 8 / 6, covers the roundings in E).
bool BodyPair::are_short(const Vec3& unit) const {
    return (extent_.array() / unit.array()).max(1.0).prod() <= 0x1p50;
}

// Of which all coordinates of R v + t - t0 are multiples, by axis; 1 where all are zero. Only where points are doubles
// by their digits: then a product of an entry of R and a coordinate of a mesh has at most 50 bits, and so has one of
// the entry and what divides all coordinates; so has the difference of the translations.
Vec3 BodyPair::common_unit(const std::array<DyadicDifference, 3>& offset) const {
    Vec3 result;
    for (int row = 0; row < 3; ++row) {
        CommonUnit unit;
        unit.include(offset[static_cast<std::size_t>(row)]);
        for (const Side& side : sides_) {
            for (int column = 0; column < 3; ++column) {
                unit.include(decode(side.body.pose->R(row, column)),
                             side.body.extent->units[static_cast<std::size_t>(column)]);
            }
        }
        result[row] = unit.m == 0 ? 1 : std::ldexp(static_cast<double>(unit.m), unit.e);
    }
    return result;
}

// From now on rounded points are counted in units, in which plain double is exact: an affine bijection changes no sign.
void BodyPair::count_in(const Vec3& unit) {
    unit_ = unit;
    is_counted_ = plain_is_exact_ = true;
    forget_points();
}

// R v + t - t0 in units of 2^exact_low_. The digits fit, see prepare_exact.
BodyPair::TwoLimbPoint BodyPair::exact_point(const Side& side, std::uint32_t vertex) const {
    TwoLimbPoint p = &side == &sides_[1] ? exact_offset_ : TwoLimbPoint{};
    const Vec3& v = side.body.mesh->vertices()[vertex];
    for (int column = 0; column < 3; ++column) {
        const Dyadic x = decode(v[column]);
        if (x.m == 0) continue;
        for (int row = 0; row < 3; ++row) {
            const Dyadic r = decode(side.body.pose->R(row, column));
            if (r.m != 0) p[static_cast<std::size_t>(row)] += (Int128{r.m} * x.m) << (r.e + x.e - exact_low_);
        }
    }
    return p;
}

const BodyPair::OneLimbPoint& BodyPair::one_limb_point(Side& side, std::uint32_t vertex) {
    return side.one_limb.get(vertex, [&](OneLimbPoint& p) {
        const TwoLimbPoint wide = exact_point(side, vertex);
        for (std::size_t k = 0; k < 3; ++k) p[k] = static_cast<std::int64_t>(wide[k]);
    });
}

const BodyPair::TwoLimbPoint& BodyPair::two_limb_point(Side& side, std::uint32_t vertex) {
    return side.two_limbs.get(vertex, [&](TwoLimbPoint& p) { p = exact_point(side, vertex); });
}

template <class Use>
Relation BodyPair::use_kernel(const Triangle& a, const Triangle& b, Use&& use) {
    const auto counted = [&](const auto& kernel) {
        using Kernel = std::decay_t<decltype(kernel)>;
        if constexpr (std::is_same_v<Kernel, OneLimbKernel>)
            ++counts_.one_limb;
        else if constexpr (std::is_same_v<Kernel, TwoLimbKernel>)
            ++counts_.two_limbs;
        else
            ++counts_.many_limbs;
        return use(kernel);
    };
    if (exact_state_ == ExactState::one_limb_fits) {
        OneLimbKernel kernel;
        for (std::size_t i = 0; i < 3; ++i) {
            kernel.points[i] = one_limb_point(sides_[0], a[i]);
            kernel.points[3 + i] = one_limb_point(sides_[1], b[i]);
        }
        return counted(kernel);
    }
    if (exact_state_ == ExactState::two_limbs_fit) {
        SixInt128 points;
        for (std::size_t i = 0; i < 3; ++i) {
            points[i] = two_limb_point(sides_[0], a[i]);
            points[3 + i] = two_limb_point(sides_[1], b[i]);
        }
        return use_narrowest(points, counted);
    }
    SixPoints points;
    for (std::size_t i = 0; i < 3; ++i) {
        points[i] = {sides_[0].body.pose, &sides_[0].body.mesh->vertices()[a[i]]};
        points[3 + i] = {sides_[1].body.pose, &sides_[1].body.mesh->vertices()[b[i]]};
    }
    return with_kernel(points, counted);
}

}  // namespace ecods::exact
