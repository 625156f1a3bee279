#include "exact/point/line_points.hpp"

namespace ecods::exact {

void LinePoints::bind(const BodyRef& body) noexcept {
    digits_ = {};
    for (int column = 0; column < 3; ++column) {
        BitRange r;
        for (int row = 0; row < 3; ++row) {
            const Dyadic x = decode(body.pose->R(row, column));
            columns_[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)] = x;
            r.include(x);
        }
        digits_.include(r * body.extent->digits[static_cast<std::size_t>(column)]);
    }
    for (int row = 0; row < 3; ++row) t_[static_cast<std::size_t>(row)] = decode(body.pose->t[row]);
}

// A coordinate is a sum of three products and a difference, each below 2^high: two more bits. Differences of corners
// are taken by the kernel.
bool LinePoints::bind(const Line& line) noexcept {
    BitRange digits = digits_;
    std::array<DyadicDifference, 3> offset, direction;
    for (std::size_t row = 0; row < 3; ++row) {
        const auto k = static_cast<Eigen::Index>(row);
        const Dyadic a = decode(line.a[k]), b = decode(line.b[k]);
        const auto from_a = subtract(t_[row], a), along = subtract(b, line.is_ray ? Dyadic{} : a);
        if (!from_a || !along) return false;
        offset[row] = *from_a;
        direction[row] = *along;
        digits.include(from_a->digits());
        digits.include(along->digits());
    }
    if (digits.width() + 3 > TwoLimbKernel::coordinate_bits) return false;
    unit_ = digits.empty() ? 0 : digits.low;
    for (std::size_t row = 0; row < 3; ++row) {
        offset_[row] = offset[row].at(unit_);
        direction_[row] = direction[row].at(unit_);
    }
    return true;
}

LinePoints::Point LinePoints::at(const Vec3& v) const noexcept {
    Point p = offset_;
    for (std::size_t column = 0; column < 3; ++column) {
        const Dyadic x = decode(v[static_cast<Eigen::Index>(column)]);
        if (x.m == 0) continue;
        for (std::size_t row = 0; row < 3; ++row) {
            const Dyadic& r = columns_[column][row];
            if (r.m != 0) p[row] += (Int128{r.m} * x.m) << (r.e + x.e - unit_);
        }
    }
    return p;
}

}  // namespace ecods::exact
