// Implements the functions of solid.hpp for a body and a half space, from the body's lowest vertices.
//
// A rounded body is treated by its core. The lowest point of a ball is its radius below the center, for every center,
// so the signed distance of a rounded body is the signed distance of its core minus the radius.
#include <optional>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "exact/measure/round/round_root_sum.hpp"
#include "exact/number/exact_sum.hpp"
#include "exact/number/root_sum.hpp"
#include "exact/point/posed_point.hpp"
#include "geometry/find_invalid.hpp"
#include "query/body/posed_body.hpp"
#include "query/body/rounded_pair.hpp"
#include "query/half_space/lowest.hpp"
#include "query/half_space/round.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {
namespace half_spaces {
namespace {

using exact::ScaledInteger;

// Asked holds a body and a half space, and computes the functions of solid.hpp for them.
class Asked {
  public:
    Asked(const CoreAndRadius& body, const Posed<HalfSpace>& half_space, const Ask& ask)
        : asking_(ask),
          body_(body.core),
          is_solid_(has_inside(*body.core.what)),
          radius_(body.radius),
          plane_(half_space),
          heights_(plane_, body.core.pose) {
        ++QueryMemoryAccess::state(asking_.memory()).counts.queries;
    }

    const Plane& plane() const noexcept { return plane_; }

    bool intersects() { return has_radius() ? is_within(0) : reaches_plane(shape(), heights_, asking_.memory()); }

    // Returns true if the real distance is at most max_distance, which must be finite.
    bool is_within(double max_distance) {
        find_lowest();
        const HeightBounds h = heights_.bounds(vertex());
        if (h.high <= 0) return true;
        const auto limit = exact::ExactSum(radius_).plus(max_distance);
        if (h.high <= plane_.times_length(limit.lower()).low) return true;
        if (h.low > plane_.times_length(limit.upper()).high) return false;
        const ScaledInteger height = this->height();
        return height.sign() <= 0 || compare_ratio(height, square(), limit.scaled()) <= 0;
    }

    Relation relation() {
        find_lowest();
        const int lowest = sign_of_distance(heights_);
        if (lowest >= 0) return lowest > 0 ? Relation::apart : Relation::touching;
        const bool is_solid = is_solid_ || has_radius();
        if (is_solid && !has_radius() && !body_.has_inside()) return Relation::touching;
        if (is_inside()) return Relation::inside;
        return is_solid ? Relation::overlapping : Relation::crossing;
    }

    SignedDistance signed_distance() {
        find_lowest();
        const ClosestPoints points = lowest_points(height());
        return {points.distance, points.kind, points.a, points.b, points.point_a, points.point_b, round_inward(plane_)};
    }

    double distance() {
        find_lowest();
        if (heights_.bounds(vertex()).high <= 0) return 0;
        const ScaledInteger height = this->height();
        return height.sign() <= 0 ? 0 : positive_part(round_ratio(height, square(), -radius()));
    }

    ClosestPoints closest() {
        find_lowest();
        const ScaledInteger height = this->height();
        if (height.sign() <= 0) {
            const Vec3 point = round_point(exact::posed_point(body_.boundary().pose, vertex()));
            return {0, ClosestKind::contained, feature(), no_feature, point, point};
        }
        ClosestPoints points = lowest_points(height);
        points.distance = positive_part(points.distance);
        return points;
    }

    std::optional<FirstContact> cast(const Vec3& motion, double latest) {
        const ScaledInteger rise = plane_.along(motion);
        if (rise.sign() >= 0 && !intersects()) return std::nullopt;
        find_lowest();
        if (has_radius() && heights_.sign(vertex()) > 0) return cast_ball(rise, latest);
        if (heights_.sign(vertex()) <= 0) return FirstContact{0, ClosestKind::contained, feature(), no_feature};
        const Quotient time(height(), -rise);
        if (exact::compare(time.ref(), latest) > 0) return std::nullopt;
        return FirstContact{exact::round_fraction(time.ref()), ClosestKind::vertex_face, feature(), plane_feature};
    }

  private:
    // Returns the first contact of the ball of radius r around the lowest vertex, whose height h is positive. The
    // center is at the height r |N| at the time (h - r |N|) / -rise (heights.hpp).
    std::optional<FirstContact> cast_ball(const ScaledInteger& rise, double latest) {
        FirstContact contact{0, ClosestKind::vertex_face, feature(), plane_feature};
        if (sign_of_distance(heights_) <= 0) return contact;
        const exact::RootSum time = exact::root_quotient(height(), radius() * radius() * square(), -rise, true);
        if (exact::compare(time, ScaledInteger(latest)) > 0) return std::nullopt;
        contact.time = exact::round_signed(time);
        return contact;
    }

    bool has_radius() const noexcept { return key_of(radius_) != 0; }
    ScaledInteger radius() const { return radius_; }
    const ScaledInteger& square() const { return plane_.exact().square; }
    const MeshShape& shape() const noexcept { return *body_.boundary().what; }

    // Sets lowest_ to the lowest vertex of the body, which the next functions use.
    void find_lowest() { lowest_ = half_spaces::find_lowest(shape(), heights_, asking_.memory()); }
    const Vec3& vertex() const noexcept { return shape().mesh().vertices()[lowest_.vertex]; }
    ScaledInteger height() const { return heights_.exact(vertex()); }
    // Returns the signed distance, and the points of the body and of the plane that are at this distance from each
    // other.
    ClosestPoints lowest_points(const ScaledInteger& height) const {
        const exact::ScaledLongVector point = exact::posed_point(body_.boundary().pose, vertex());
        return {round_ratio(height, square(), -radius()), ClosestKind::vertex_face,         feature(), plane_feature,
                round_lowest(point, radius(), plane_),    round_foot(point, height, plane_)};
    }
    Feature feature() const noexcept {
        Feature feature = lowest_.feature();
        body_.rename(feature);
        return feature;
    }

    // Returns the sign of (distance of the lowest vertex from the plane - radius).
    int sign_of_distance(const Heights& heights) const {
        if (!has_radius()) return heights.sign(vertex());
        const ScaledInteger height = heights.exact(vertex());
        return height.sign() <= 0 ? -1 : compare_ratio(height, square(), radius());
    }

    // Returns true if no point is above the plane: the highest vertex is at least as deep as the radius.
    bool is_inside() {
        const Heights depths(plane_, body_.boundary().pose, Heights::Side::below);
        const Corner highest = half_spaces::find_lowest(shape(), depths, asking_.memory());
        const ScaledInteger depth = depths.exact(shape().mesh().vertices()[highest.vertex]);
        return depth.sign() >= 0 && compare_ratio(depth, square(), radius()) >= 0;
    }

    Asking asking_;
    PosedBody body_;
    bool is_solid_;  // true if the given body is a solid with an inside; its boundary may be another mesh
    double radius_;
    Plane plane_;
    Heights heights_;
    Corner lowest_{};
};

}  // namespace
}  // namespace half_spaces

using half_spaces::Asked;

bool intersects(const Posed<MeshShape>& body, const Posed<HalfSpace>& half_space, const Ask& ask) {
    return Asked(body, half_space, ask).intersects();
}
bool intersects(const Posed<Rounded>& body, const Posed<HalfSpace>& half_space, const Ask& ask) {
    return Asked(body, half_space, ask).intersects();
}

Relation relation(const Posed<MeshShape>& body, const Posed<HalfSpace>& half_space, const Ask& ask) {
    return Asked(body, half_space, ask).relation();
}
Relation relation(const Posed<Rounded>& body, const Posed<HalfSpace>& half_space, const Ask& ask) {
    return Asked(body, half_space, ask).relation();
}

SignedDistance signed_distance(const Posed<MeshShape>& body, const Posed<HalfSpace>& half_space, const Ask& ask) {
    return Asked(body, half_space, ask).signed_distance();
}
SignedDistance signed_distance(const Posed<Rounded>& body, const Posed<HalfSpace>& half_space, const Ask& ask) {
    return Asked(body, half_space, ask).signed_distance();
}

double distance(const Posed<MeshShape>& body, const Posed<HalfSpace>& half_space, const Ask& ask) {
    return Asked(body, half_space, ask).distance();
}
double distance(const Posed<Rounded>& body, const Posed<HalfSpace>& half_space, const Ask& ask) {
    return Asked(body, half_space, ask).distance();
}

namespace {

bool is_within(const CoreAndRadius& body, const Posed<HalfSpace>& half_space, double max_distance, const Ask& ask) {
    require_distance(max_distance);
    Asked asked(body, half_space, ask);
    return key_of(max_distance) == infinity_key || asked.is_within(max_distance);
}

}  // namespace

bool within(const Posed<MeshShape>& body, const Posed<HalfSpace>& half_space, double max_distance, const Ask& ask) {
    return is_within(body, half_space, max_distance, ask);
}
bool within(const Posed<Rounded>& body, const Posed<HalfSpace>& half_space, double max_distance, const Ask& ask) {
    return is_within(body, half_space, max_distance, ask);
}

ClosestPoints closest(const Posed<MeshShape>& body, const Posed<HalfSpace>& half_space, const Ask& ask) {
    return Asked(body, half_space, ask).closest();
}
ClosestPoints closest(const Posed<Rounded>& body, const Posed<HalfSpace>& half_space, const Ask& ask) {
    return Asked(body, half_space, ask).closest();
}

std::optional<FirstContact> cast(const Posed<MeshShape>& body, const Vec3& motion, const Posed<HalfSpace>& half_space,
                                 double max_time, const Ask& ask) {
    const double latest = require_time(max_time);
    validate_motion(motion);
    return Asked(body, half_space, ask).cast(motion, latest);
}
std::optional<FirstContact> cast(const Posed<Rounded>& body, const Vec3& motion, const Posed<HalfSpace>& half_space,
                                 double max_time, const Ask& ask) {
    const double latest = require_time(max_time);
    validate_motion(motion);
    return Asked(body, half_space, ask).cast(motion, latest);
}

}  // namespace ecods
