#include "exact/point/frame.hpp"

#include <algorithm>
#include <limits>

#include "geometry/same_bits.hpp"

namespace ecods::exact {
namespace {

// Divides coordinates by the unit of their axis. Exact if they are multiples of it and the quotients are doubles, since
// a quotient is rounded correctly.
void divide(Point& p, const Vec3& unit) noexcept {
    for (std::size_t k = 0; k < 3; ++k) p[k] /= unit[static_cast<Eigen::Index>(k)];
}

}  // namespace

void Frame::bind(std::span<const BodyRef> bodies) {
    ECODS_ASSERT(!bodies.empty());
    if (bodies.size() > bodies_.size()) bodies_.resize(bodies.size());
    body_count_ = bodies.size();
    for (std::size_t i = 0; i < body_count_; ++i) {
        bodies_[i].ref = bodies[i];
        bodies_[i].offset = i == 0 ? Vec3::Zero() : Vec3(bodies[i].pose->t - bodies[0].pose->t);
    }
    forget_points();
    arithmetic_ = Arithmetic::unknown;
    is_counted_ = false;
    find_bounds();
}

void Frame::forget_points() noexcept {
    for (Body& body : bodies()) {
        body.rounded.clear();
        body.one_limb.clear();
        body.two_limbs.clear();
    }
}

void Frame::pose(const Body& body, std::uint32_t vertex, Point& p) const noexcept {
    p = pose_point(body.ref.pose->R, body.ref.mesh->vertices()[vertex], body.offset);
    if (is_counted_) divide(p, unit_);
}

// Finds bounds from the boxes of all bodies: |R| times half the mesh's box, around its posed center.
void Frame::find_bounds() noexcept {
    delta_ = 0;
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
    for (Body& body : bodies()) {
        const MeshExtent& extent = *body.ref.extent;
        const Mat3& R = body.ref.pose->R;
        body.delta = point_error_bound(R, extent.magnitude, body.offset);
        delta_ = std::max(delta_, body.delta);
        const Vec3 center = R * extent.center + body.offset;
        const Vec3 half = R.cwiseAbs() * extent.half;
        low = low.cwiseMin(center - half);
        high = high.cwiseMax(center + half);
    }
    // The extents have roundings of their own: each of center, half and their sums is within delta of its value.
    extent_ = high - low + Vec3::Constant(8 * delta_);
}

// The digits of the products R_ij v_j of all bodies. Bodies under one rotation, which assemblies are made of, and of
// which many faces are parallel, have it taken to pieces once.
BitRange Frame::digits_of_products() noexcept {
    BitRange digits;
    std::array<BitRange, 3> of_columns;
    const Body* last = nullptr;
    for (Body& body : bodies()) {
        const bool is_again = last != nullptr && same_bits(body.ref.pose->R, last->ref.pose->R);
        if (is_again) body.columns = last->columns;
        last = &body;
        for (std::size_t column = 0; column < 3; ++column) {
            BitRange& r = of_columns[column];
            if (!is_again) {
                r = {};
                for (std::size_t row = 0; row < 3; ++row) {
                    Dyadic& entry = body.columns[column][row];
                    entry = decode(body.ref.pose->R.data()[3 * column + row]);
                    r.include(entry);
                }
            }
            digits.include(r * body.ref.extent->digits[column]);
        }
    }
    return digits;
}

// Includes the digits of t - t0 of all bodies, unless one is wider than a DyadicDifference can be. The differences, not
// the translations, are in the coordinates: near bodies far from the origin have short ones.
bool Frame::find_differences(BitRange& digits) noexcept {
    const Pose& base = *bodies_[0].ref.pose;
    bodies_[0].difference = {};
    for (Body& body : bodies().subspan(1)) {
        for (std::size_t row = 0; row < 3; ++row) {
            const auto at = static_cast<Eigen::Index>(row);
            const auto difference = subtract(decode(body.ref.pose->t[at]), decode(base.t[at]));
            if (!difference) return false;
            body.difference[row] = *difference;
            digits.include(difference->digits());
        }
    }
    return true;
}

// Finds the width of all exact coordinates, and from it the arithmetic.
void Frame::measure_digits() noexcept {
    arithmetic_ = Arithmetic::many_limbs;
    BitRange digits = digits_of_products();
    if (!find_differences(digits)) return;
    // A coordinate is a sum of three products and a translation: two more bits. With two limbs differences are made, of
    // one bit more.
    if (digits.width() + 2 <= OneLimbKernel::coordinate_bits) {
        arithmetic_ = Arithmetic::one_limb;
    } else if (digits.width() + 3 <= TwoLimbKernel::coordinate_bits) {
        arithmetic_ = Arithmetic::two_limbs;
    } else {
        return;
    }
    exact_low_ = digits.empty() ? 0 : digits.low;
    for (Body& body : bodies()) {
        for (std::size_t row = 0; row < 3; ++row) body.exact_offset[row] = body.difference[row].at(exact_low_);
    }
    if (!points_are_doubles(digits)) return;
    if (digits.empty() || are_short(Vec3::Constant(std::ldexp(1.0, digits.low)))) {
        arithmetic_ = Arithmetic::plain;
        return;
    }
    const Vec3 unit = common_unit();
    if (are_short(unit)) return count_in(unit);
    arithmetic_ = Arithmetic::differences;
    to_integers_ = std::ldexp(1.0, -exact_low_);
}

// Whether points of these digits are posed without a rounding error, none of the numbers near the ends of the range of
// doubles: every partial sum of R v + d is a multiple of 2^low below 2^(high + 2), hence a double.
bool Frame::points_are_doubles(const BitRange& digits) const noexcept {
    if (digits.empty()) return true;
    if (digits.width() + 3 > mantissa_bits || digits.low < -300 || digits.high > 200) return false;
    for (const Body& body : bodies()) {
        for (const auto& column : body.columns) {
            for (const Dyadic& r : column) {
                if (r.m != 0 && (r.e < -300 || r.e > 200)) return false;
            }
        }
        for (const BitRange& v : body.ref.extent->digits) {
            if (!v.empty() && (v.low < -300 || v.high > 300)) return false;
        }
        for (int row = 0; row < 3; ++row) {
            const Dyadic t = decode(body.ref.pose->t[row]);
            if (t.m != 0 && (t.e < -300 || t.e > 200)) return false;
        }
    }
    return true;
}

// Whether plain double makes no rounding error with points whose coordinates are doubles and multiples of `unit`, by
// axis. Counted in units, let differences be integers of at most E0, E1 and E2, all of them at least 1. Products of two
// are at most Ei Ej, minors 2 Ei Ej, the three terms of a determinant 2 E0 E1 E2, and their sum 6 E0 E1 E2. With
// E0 E1 E2 <= 2^50 all are integers below 2^53, hence doubles (the last factor, 8 / 6, covers the roundings in E).
bool Frame::are_short(const Vec3& unit) const noexcept {
    return (extent_.array() / unit.array()).max(1.0).prod() <= 0x1p50;
}

// The unit of which all coordinates of R v + t - t0 are multiples, by axis; 1 where all are zero. Only for points that
// points_are_doubles accepts: then a product of an entry of R and a coordinate of a mesh has at most 50 bits, and so
// has one of the entry and the mesh's own unit; so has the difference of the translations.
Vec3 Frame::common_unit() const noexcept {
    Vec3 result;
    for (int row = 0; row < 3; ++row) {
        CommonUnit unit;
        for (const Body& body : bodies()) {
            unit.include(body.difference[static_cast<std::size_t>(row)]);
            for (std::size_t column = 0; column < 3; ++column) {
                unit.include(body.columns[column][static_cast<std::size_t>(row)], body.ref.extent->units[column]);
            }
        }
        result[row] = unit.m == 0 ? 1 : std::ldexp(static_cast<double>(unit.m), unit.e);
    }
    return result;
}

// From now on rounded points are counted in units, in which plain double is exact: an affine bijection changes no sign.
void Frame::count_in(const Vec3& unit) noexcept {
    unit_ = unit;
    is_counted_ = true;
    arithmetic_ = Arithmetic::plain;
    forget_points();
}

// R v + t - t0 in units of 2^exact_low_. The digits fit, see measure_digits: each product is a multiple of the unit,
// and so many units are a number, as are all sums.
template <class Number>
void Frame::find_exact(const Body& body, std::uint32_t vertex, std::array<Number, 3>& p) const noexcept {
    for (std::size_t row = 0; row < 3; ++row) p[row] = static_cast<Number>(body.exact_offset[row]);
    const Vec3& v = body.ref.mesh->vertices()[vertex];
    for (std::size_t column = 0; column < 3; ++column) {
        const Dyadic x = decode(v[static_cast<Eigen::Index>(column)]);
        if (x.m == 0) continue;
        const int shift = x.e - exact_low_;
        for (std::size_t row = 0; row < 3; ++row) {
            const Dyadic& r = body.columns[column][row];
            if (r.m != 0) p[row] += (Number{r.m} * x.m) << (r.e + shift);
        }
    }
}

const OneLimbKernel::Point& Frame::one_limb(std::size_t body, std::uint32_t vertex) {
    return bodies_[body].one_limb.get(vertex, [&](OneLimbKernel::Point& p) { find_exact(bodies_[body], vertex, p); });
}

const TwoLimbKernel::Point& Frame::two_limbs(std::size_t body, std::uint32_t vertex) {
    return bodies_[body].two_limbs.get(vertex, [&](TwoLimbKernel::Point& p) { find_exact(bodies_[body], vertex, p); });
}

}  // namespace ecods::exact
