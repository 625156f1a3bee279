#include "exact/point/line_points.hpp"

namespace ecods::exact {

void LinePoints::bind(const BodyRef& body) noexcept {
    terms_.set_rotation(body.pose->R);
    t_ = body.pose->t;
    digits_ = terms_.digits_of_products(body.extent->digits);
    products_.bind(body.pose->R, body.extent->digits, digits_);
}

// Sets the digits, the unit, and the line's beginning and direction in that unit; returns false if the digits do not
// fit. A coordinate needs two more bits than its terms: it is a sum of three products and a difference, each below
// 2^high. The kernel computes differences of corners itself. Far from the origin, the differences computed here are
// shorter than their operands.
bool LinePoints::bind(const Line& line) noexcept {
    terms_.set_offset(t_, line.a);
    DifferenceTerms along;
    along.set(line.b, line.is_ray ? Vec3(Vec3::Zero()) : line.a);
    BitRange digits = digits_;
    digits.include(terms_.offset().digits());
    digits.include(along.digits());
    if (digits.width() + 2 > TwoLimbKernel::coordinate_bits) return false;
    is_one_limb_ = digits.width() + 2 <= OneLimbKernel::coordinate_bits;
    unit_ = digits.empty() ? 0 : digits.low;
    offset_ = terms_.offset().in<Int128>(unit_);
    direction_ = along.in<Int128>(unit_);
    return true;
}

LinePoints::Point LinePoints::at(const Vec3& v) const noexcept {
    Point p = offset_;
    products_.add(terms_, v, unit_, p);
    return p;
}

}  // namespace ecods::exact
