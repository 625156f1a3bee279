#include "query/certificate/exact_points.hpp"

namespace ecods {

using namespace exact;

IntegerVector3 minus(const IntegerVector3& a, const IntegerVector3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
IntegerVector3 cross(const IntegerVector3& a, const IntegerVector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Integer dot(const IntegerVector3& a, const IntegerVector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

namespace {

BitRange digits_of(const BodyRef& body) {
    BitRange range;
    for (int column = 0; column < 3; ++column) {
        BitRange of_column;
        for (int row = 0; row < 3; ++row) of_column.include(decode(body.pose->R(row, column)));
        range.include(of_column * body.extent->digits[static_cast<std::size_t>(column)]);
    }
    for (int row = 0; row < 3; ++row) range.include(decode(body.pose->t[row]));
    return range;
}

BitRange digits_of(const ecods::Segment& segment) {
    BitRange range;
    for (const Vec3& end : {segment.a, segment.b}) {
        for (int axis = 0; axis < 3; ++axis) range.include(decode(end[axis]));
    }
    return range;
}

}  // namespace

ExactPoints::ExactPoints(const BodyRef& a, const BodyRef& b) : bodies_{a, b} {
    BitRange range = digits_of(a);
    range.include(digits_of(b));
    low_ = range.empty() ? 0 : range.low;
}

ExactPoints::ExactPoints(const BodyRef& a, const ecods::Segment& segment, const Parameter& finest) : bodies_{a, a} {
    BitRange range = digits_of(a);
    const BitRange ends = digits_of(segment);
    range.include(ends);
    if (!ends.empty() && finest.m != 0) range.include(ends.low + finest.e, ends.high);
    low_ = range.empty() ? 0 : range.low;
}

void ExactPoints::add(Integer& sum, Int128 m, int e) const {
    if (m != 0) sum = sum + (Integer(m) << (e - low_));
}

IntegerVector3 ExactPoints::vertex(std::size_t body, std::uint32_t index) const {
    const BodyRef& of = bodies_[body];
    const Vec3& v = of.mesh->vertices()[index];
    std::array<Dyadic, 3> of_v;
    for (std::size_t k = 0; k < 3; ++k) of_v[k] = decode(v[static_cast<int>(k)]);
    IntegerVector3 point;
    for (int row = 0; row < 3; ++row) {
        Integer& sum = point[static_cast<std::size_t>(row)];
        for (std::size_t k = 0; k < 3; ++k) {
            const Dyadic r = decode(of.pose->R(row, static_cast<int>(k)));
            add(sum, Int128{r.m} * of_v[k].m, r.e + of_v[k].e);
        }
        const Dyadic t = decode(of.pose->t[row]);
        add(sum, t.m, t.e);
    }
    return point;
}

IntegerVector3 ExactPoints::on_segment(const ecods::Segment& segment, const Parameter& s) const {
    IntegerVector3 point;
    for (int axis = 0; axis < 3; ++axis) {
        Integer& sum = point[static_cast<std::size_t>(axis)];
        const Dyadic from = decode(segment.a[axis]), to = decode(segment.b[axis]);
        add(sum, from.m, from.e);
        if (s.m == 0) continue;
        add(sum, Int128{to.m} * s.m, to.e + s.e);
        add(sum, -(Int128{from.m} * s.m), from.e + s.e);
    }
    return point;
}

}  // namespace ecods
