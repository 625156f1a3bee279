#include "exact/point/frame.hpp"

#include <algorithm>
#include <limits>

namespace ecods::exact {
namespace {

// Divides the coordinates of p by the unit of their axis. If the coordinates are multiples of the unit and the
// quotients are doubles, the division is exact, because division rounds correctly.
void divide(Point& p, const Vec3& unit) noexcept {
    for (std::size_t k = 0; k < 3; ++k) p[k] /= unit[static_cast<Eigen::Index>(k)];
}

}  // namespace

void Frame::bind(std::span<const BodyRef> bodies) {
    integers_.bind(bodies);
    if (bodies.size() > bodies_.size()) bodies_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies_[i].offset = i == 0 ? Vec3::Zero() : Vec3(bodies[i].pose->t - bodies[0].pose->t);
    }
    forget_points();
    arithmetic_ = Arithmetic::unknown;
    is_counted_ = false;
    find_bounds();
}

void Frame::forget_points() noexcept {
    for (std::size_t i = 0; i < body_count(); ++i) bodies_[i].rounded.clear();
}

void Frame::pose(std::size_t body, std::uint32_t vertex, Point& p) const noexcept {
    const BodyRef& of = this->body(body);
    p = pose_point(of.pose->R, of.mesh->vertices()[vertex], bodies_[body].offset);
    if (is_counted_) divide(p, unit_);
}

// Sets delta_ and extent_ from the posed boxes of all bodies. A posed box has |R| times half the mesh's box around the
// posed center.
void Frame::find_bounds() noexcept {
    delta_ = 0;
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
    for (std::size_t i = 0; i < body_count(); ++i) {
        Body& body = bodies_[i];
        const MeshExtent& extent = *this->body(i).extent;
        const Mat3& R = this->body(i).pose->R;
        body.delta = point_error_bound(R, extent.magnitude, body.offset);
        delta_ = std::max(delta_, body.delta);
        const Vec3 center = R * extent.center + body.offset;
        const Vec3 half = R.cwiseAbs() * extent.half;
        low = low.cwiseMin(center - half);
        high = high.cwiseMax(center + half);
    }
    // 8 delta covers the rounding errors of the boxes: each of center, half and their sums is within delta of its exact
    // value.
    extent_ = high - low + Vec3::Constant(8 * delta_);
}

// Measures the width of all exact coordinates, and chooses the cheapest arithmetic that is exact for this width.
void Frame::measure_digits() noexcept {
    arithmetic_ = Arithmetic::many_limbs;
    integers_.measure();
    if (!integers_.is_exact()) return;
    // A coordinate is a sum of three products and a translation. The sum needs two more bits than its terms.
    const BitRange& digits = integers_.digits();
    const bool is_one_limb = digits.width() + 2 <= OneLimbKernel::coordinate_bits;
    arithmetic_ = is_one_limb ? Arithmetic::one_limb : Arithmetic::two_limbs;
    if (!points_are_doubles(digits)) return;
    if (digits.empty() || are_short(Vec3::Constant(std::ldexp(1.0, digits.low)))) {
        arithmetic_ = Arithmetic::plain;
        return;
    }
    const Vec3 unit = common_unit();
    if (are_short(unit)) return count_in(unit);
    arithmetic_ = Arithmetic::differences;
    to_integers_ = std::ldexp(1.0, -integers_.unit());
}

// Returns true if points whose terms have these digits are posed without rounding errors, far from underflow and
// overflow. The reason: every partial sum of R v + d is a multiple of 2^low below 2^(high + 2), and therefore a double.
bool Frame::points_are_doubles(const BitRange& digits) const noexcept {
    if (digits.empty()) return true;
    if (digits.width() + 3 > mantissa_bits || digits.low < -300 || digits.high > 200) return false;
    for (std::size_t i = 0; i < body_count(); ++i) {
        for (const auto& column : integers_.terms(i).columns()) {
            for (const Dyadic& r : column) {
                if (r.m != 0 && (r.e < -300 || r.e > 200)) return false;
            }
        }
        for (const BitRange& v : body(i).extent->digits) {
            if (!v.empty() && (v.low < -300 || v.high > 300)) return false;
        }
        for (int row = 0; row < 3; ++row) {
            const Dyadic t = decode(body(i).pose->t[row]);
            if (t.m != 0 && (t.e < -300 || t.e > 200)) return false;
        }
    }
    return true;
}

// Returns true if determinants in doubles have no rounding errors. The points' coordinates must be doubles, and
// multiples of `unit` on each axis. In these units, let differences on the three axes be integers of at most E0, E1 and
// E2, all at least 1. Products of two differences are at most Ei Ej, minors 2 Ei Ej, the three terms of a determinant 2
// E0 E1 E2, and their sum 6 E0 E1 E2. If E0 E1 E2 <= 2^50, all are integers of at most 6 * 2^50 < 2^53, and therefore
// doubles. The factor 8 / 6 between these two numbers covers the roundings in E.
bool Frame::are_short(const Vec3& unit) const noexcept {
    return (extent_.array() / unit.array()).max(1.0).prod() <= 0x1p50;
}

// Returns for each axis a unit that divides all coordinates of R v + t - t0; 1 if all are zero. Call this function only
// if points_are_doubles(): then a product of an entry of R and a coordinate of a mesh has at most 50 bits. The product
// of the entry and the mesh's own unit, and the difference of the translations, have at most 50 bits, too.
Vec3 Frame::common_unit() const noexcept {
    Vec3 result;
    for (int row = 0; row < 3; ++row) {
        CommonUnit unit;
        for (std::size_t i = 0; i < body_count(); ++i) {
            const PoseTerms& terms = integers_.terms(i);
            unit.include(terms.offset()[static_cast<std::size_t>(row)][0]);
            for (std::size_t column = 0; column < 3; ++column) {
                unit.include(terms.columns()[column][static_cast<std::size_t>(row)], body(i).extent->units[column]);
            }
        }
        result[row] = unit.m == 0 ? 1 : std::ldexp(static_cast<double>(unit.m), unit.e);
    }
    return result;
}

// Changes the unit of rounded points: they are divided by `unit`, which makes determinants in doubles exact. Scaling
// the axes changes no sign.
void Frame::count_in(const Vec3& unit) noexcept {
    unit_ = unit;
    is_counted_ = true;
    arithmetic_ = Arithmetic::plain;
    forget_points();
}

}  // namespace ecods::exact
