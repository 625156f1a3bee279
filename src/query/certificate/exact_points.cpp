#include "query/certificate/exact_points.hpp"

namespace ecods {

using namespace exact;

// Binds a body, whose points are then relative to the world's origin, like the points of a segment. Returns the range
// of digits of the coordinates.
BitRange ExactPoints::bind(std::size_t body, const BodyRef& of) noexcept {
    meshes_[body] = of.mesh;
    terms_[body].set(*of.pose, Vec3::Zero());
    return terms_[body].digits(of.extent->digits);
}

ExactPoints::ExactPoints(const BodyRef& a, const BodyRef& b) noexcept {
    BitRange digits = bind(0, a);
    digits.include(bind(1, b));
    unit_ = digits.empty() ? 0 : digits.low;
}

ExactPoints::ExactPoints(const BodyRef& a, const ecods::Segment& segment, const Parameter& finest) noexcept {
    BitRange digits = bind(0, a), ends;
    for (const Vec3& end : {segment.a, segment.b}) {
        for (int axis = 0; axis < 3; ++axis) ends.include(decode(end[axis]));
    }
    digits.include(ends);
    if (!ends.empty() && finest.m != 0) digits.include(ends.low + finest.e, ends.high);
    unit_ = digits.empty() ? 0 : digits.low;
}

exact::LongVector ExactPoints::on_segment(const ecods::Segment& segment, const Parameter& s) const {
    exact::LongVector point;
    for (int axis = 0; axis < 3; ++axis) {
        Integer& sum = point[static_cast<std::size_t>(axis)];
        const Dyadic from = decode(segment.a[axis]), to = decode(segment.b[axis]);
        add_term(sum, from.m, from.e - unit_);
        if (s.m == 0) continue;
        add_term(sum, Int128{to.m} * s.m, to.e + s.e - unit_);
        add_term(sum, -(Int128{from.m} * s.m), from.e + s.e - unit_);
    }
    return point;
}

}  // namespace ecods
