// Implements the functions of solid.hpp for two half spaces. Two half spaces share a point unless their normals are
// opposed.
//
// With N2 = -(b / a) N1 for a, b > 0, the sets N1 . x <= F1 and N2 . x <= F2 are N1 . x <= F1 and N1 . x >= -F2 a / b.
// So they are apart if the gap -(F1 b + F2 a) is positive, and their distance is then gap / (b |N1|). Translations by
// m1 and m2 reduce the gap by N1 . m1 b + N2 . m2 a.
#include <optional>

#include "base/limits.hpp"
#include "ecods/error.hpp"
#include "ecods/solid.hpp"
#include "geometry/find_invalid.hpp"
#include "geometry/same_bits.hpp"
#include "query/half_space/heights.hpp"
#include "query/half_space/lowest.hpp"
#include "query/half_space/round.hpp"

namespace ecods {
namespace {

using exact::ScaledInteger;
using half_spaces::Plane;

ScaledInteger size_of(const ScaledInteger& x) {
    return x.sign() < 0 ? -x : x;
}

// TwoPlanes compares two half spaces whose planes may be parallel.
class TwoPlanes {
  public:
    TwoPlanes(const Posed<HalfSpace>& a, const Posed<HalfSpace>& b) : first_(a, 0), second_(b, 1) {
        const auto &N1 = first_.exact().N, &N2 = second_.exact().N;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t l = (k + 1) % 3;
            if (compare(N1[k] * N2[l], N1[l] * N2[k]) != 0) return;
        }
        std::size_t axis = 0;
        while (N1[axis].sign() == 0) ++axis;
        direction_ = N1[axis].sign() * N2[axis].sign();
        const ScaledInteger F1 = offset(first_, a.pose), F2 = offset(second_, b.pose);
        const ScaledInteger size1 = size_of(N1[axis]), size2 = size_of(N2[axis]);
        const ScaledInteger x = F1 * size2, y = F2 * size1;
        gap_ = direction_ < 0 ? -(x + y) : y - x;
        square_ = size2 * size2 * first_.exact().square;
        size1_ = size1;
        size2_ = size2;
    }

    bool are_opposed() const noexcept { return direction_ < 0; }
    bool have_one_direction() const noexcept { return direction_ > 0; }

    // Returns the gap between opposed half spaces, which is negative if they overlap. If the normals have the same
    // direction, returns the signed gap from the first plane to the second. The gap is a multiple of the distance: the
    // squared distance is gap^2 / square.
    const ScaledInteger& gap() const noexcept { return gap_; }
    const ScaledInteger& square() const noexcept { return square_; }
    bool are_apart() const noexcept { return are_opposed() && gap_.sign() > 0; }

    // Return the amount by which the gap shrinks if the first, or second, half space is translated by `to` - `from`.
    ScaledInteger closed_by_first(const Vec3& from, const Vec3& to) const {
        return (first_.along(to) - first_.along(from)) * size2_;
    }
    ScaledInteger closed_by_second(const Vec3& from, const Vec3& to) const {
        return (second_.along(to) - second_.along(from)) * size1_;
    }

    // Returns the first contact up to the time `latest` if the gap shrinks by `closed` in the time from 0 to 1;
    // otherwise nullopt.
    std::optional<FirstContact> meet(const ScaledInteger& closed, double latest) const {
        FirstContact contact{0, ClosestKind::intersecting, half_spaces::plane_feature, half_spaces::plane_feature};
        if (!are_apart()) return contact;
        if (closed.sign() <= 0) return std::nullopt;
        const half_spaces::Quotient time(gap_, closed);
        if (exact::compare(time.ref(), latest) > 0) return std::nullopt;
        contact.time = exact::round_fraction(time.ref());
        return contact;
    }

  private:
    static ScaledInteger offset(const Plane& plane, const Pose& pose) { return plane.exact().E + plane.along(pose.t); }

    Plane first_, second_;
    int direction_ = 0;  // if the planes are parallel, 1 or -1: the sign of the product of the normals; otherwise 0
    ScaledInteger gap_, square_, size1_, size2_;
};

}  // namespace

bool intersects(const Posed<HalfSpace>& a, const Posed<HalfSpace>& b, const Ask& /*ask*/) {
    return !TwoPlanes(a, b).are_apart();
}

Relation relation(const Posed<HalfSpace>& a, const Posed<HalfSpace>& b, const Ask& /*ask*/) {
    const TwoPlanes planes(a, b);
    const int gap = planes.gap().sign();
    if (planes.are_opposed()) return gap > 0 ? Relation::apart : gap == 0 ? Relation::touching : Relation::overlapping;
    if (!planes.have_one_direction()) return Relation::overlapping;
    return gap > 0 ? Relation::inside : gap == 0 ? Relation::equal : Relation::contains;
}

double distance(const Posed<HalfSpace>& a, const Posed<HalfSpace>& b, const Ask& /*ask*/) {
    const TwoPlanes planes(a, b);
    return planes.are_apart() ? half_spaces::round_ratio(planes.gap(), planes.square()) : 0;
}

bool within(const Posed<HalfSpace>& a, const Posed<HalfSpace>& b, double max_distance, const Ask& /*ask*/) {
    require_distance(max_distance);
    const TwoPlanes planes(a, b);
    return !planes.are_apart() || key_of(max_distance) == infinity_key ||
           half_spaces::compare_ratio(planes.gap(), planes.square(), ScaledInteger(max_distance)) <= 0;
}

std::optional<FirstContact> cast(const Posed<HalfSpace>& a, const Vec3& motion, const Posed<HalfSpace>& b,
                                 double max_time, const Ask& /*ask*/) {
    const double latest = require_time(max_time);
    validate_motion(motion);
    const TwoPlanes planes(a, b);
    return planes.meet(planes.closed_by_first(Vec3::Zero(), motion), latest);
}

std::optional<FirstContact> cast(const Moving<HalfSpace>& a, const Moving<HalfSpace>& b, double max_time,
                                 const Ask& /*ask*/) {
    const double latest = require_time(max_time);
    const TwoPlanes planes({*a.what, a.from}, {*b.what, b.from});
    const bool are_translated = same_bits(a.from.R, a.to.R) && same_bits(b.from.R, b.to.R);
    if (planes.are_apart() && !are_translated) {
        throw NotSupported(Question::cast_moving, ShapeKind::half_space(), ShapeKind::half_space());
    }
    return planes.meet(planes.closed_by_first(a.from.t, a.to.t) + planes.closed_by_second(b.from.t, b.to.t), latest);
}

}  // namespace ecods
