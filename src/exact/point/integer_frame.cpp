#include "exact/point/integer_frame.hpp"

#include <algorithm>

#include "geometry/same_bits.hpp"

namespace ecods::exact {

void IntegerFrame::bind(std::span<const BodyRef> bodies) {
    ECODS_ASSERT(!bodies.empty());
    if (bodies.size() > bodies_.size()) bodies_.resize(bodies.size());
    body_count_ = bodies.size();
    for (std::size_t i = 0; i < body_count_; ++i) {
        bodies_[i].ref = bodies[i];
        bodies_[i].points.clear();
    }
}

// Sets the digits of all bodies and the unit. A coordinate is the sum of three products and a difference of
// translations, each below 2^high. So the difference of two coordinates is below 2^(high + 3), which must fit into
// difference_bits.
//
// If consecutive bodies have the same rotation, as in assemblies with many parallel faces, the rotation is decoded
// once. Since coordinates contain differences of translations, bodies that are near each other have short coordinates
// even far from the origin.
void IntegerFrame::measure(const BitRange& others) noexcept {
    digits_ = {};
    const Vec3& t0 = bodies_[0].ref.pose->t;
    const Body* last = nullptr;
    for (Body& body : bodies()) {
        const Pose& pose = *body.ref.pose;
        if (last != nullptr && same_bits(pose.R, last->ref.pose->R)) {
            body.terms = last->terms;
        } else {
            body.terms.set_rotation(pose.R);
        }
        if (last == nullptr) {
            body.terms.set_no_offset();
        } else {
            body.terms.set_offset(pose.t, t0);
        }
        digits_.include(body.terms.digits(body.ref.extent->digits));
        last = &body;
    }
    BitRange digits = digits_;
    digits.include(others);
    if (digits.width() + 3 > difference_bits) digits = digits_;
    is_exact_ = digits.width() + 3 <= difference_bits;
    unit_ = digits.empty() ? 0 : std::max(digits.low, digits.high + 3 - difference_bits);
    for (Body& body : bodies()) {
        body.offset = body.terms.offset().in<Int128>(unit_);
        body.products.forget();
    }
}

void IntegerFrame::pose(Body& of, std::uint32_t vertex, Point& p) const noexcept {
    if (is_exact_ && !of.products.is_bound()) {
        const auto& v = of.ref.extent->digits;
        of.products.bind(of.ref.pose->R, v, of.terms.digits_of_products(v));
    }
    p = of.offset;
    of.products.add(of.terms, of.ref.mesh->vertices()[vertex], unit_, p);
}

}  // namespace ecods::exact
