#include "query/solid/ray_query.hpp"

#include <tuple>

#include "bvh/walks/tree_view.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/sign/frame_signs.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

using namespace exact;

RayQuery::RayQuery(Frame& frame, std::size_t body, const MeshTree& tree, std::vector<TreeRef>& stack,
                   QueryCounts& counts)
    : frame_(frame),
      body_(body),
      tree_(tree),
      stack_(stack),
      counts_(counts),
      bounds_(determinant_bounds(frame, frame.delta())) {}

// Returns the point relative to the translation of body_, with its error bound.
RayOrigin RayQuery::origin_of(VertexRef point) const {
    const BodyRef& of = frame_.body(point.body);
    const Vec3 d = of.pose->t - frame_.body(body_).pose->t;
    const Vec3& v = of.mesh->vertices()[point.vertex];
    const Point p = pose_point(of.pose->R, v, d);
    return {Vec3(p[0], p[1], p[2]), point_error_bound(of.pose->R, v.cwiseAbs(), d)};
}

// Returns the axes, as bits, on which the triangle's normal is not zero. The triangle must have an area, so at least
// one bit is set.
std::uint32_t RayQuery::axes_across(std::size_t of, const Triangle& triangle) {
    const std::array<VertexRef, 3> corners = corners_and(of, triangle);
    std::uint32_t axes = 0;
    if (!doubles_are_exact()) {
        const Points<3> points = frame_.rounded(corners);
        const PlainNormal normal = plain_normal(points[0], points[1], points[2]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            axes |= (certain_sign(normal[axis], bounds_.orient2d[axis]) != 0) << axis;
        if (axes != 0) return axes;
    }
    return with_signs(frame_, corners, [](auto& signs) {
        std::uint32_t found = 0;
        for (int axis = 0; axis < 3; ++axis) {
            found |= static_cast<std::uint32_t>(signs.orient2d(0, 1, 2, axis) != 0) << axis;
        }
        ECODS_ASSERT(found != 0);
        return found;
    });
}

// Returns the filter's Answer for the ray and the triangle; `open` if a sign is zero. If no sign is zero, all points
// infinitely near to `from` have the same signs, so the Answer holds for all of them.
RayQuery::Answer RayQuery::filter(std::uint32_t triangle, VertexRef from, RayDirection ray) {
    if (doubles_are_exact()) return Answer::open;
    const Triangle& corners = triangle_at(body_, triangle);
    const Point& m = frame_.rounded(from.body, from.vertex);
    const Point p = m;  // a copy: the next call for its body may overwrite m
    const Points<3> x{frame_.rounded(body_, corners[0]), frame_.rounded(body_, corners[1]),
                      frame_.rounded(body_, corners[2])};
    const double bound = bounds_.orient2d[static_cast<std::size_t>(ray.axis)];
    int low = 1, high = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const int s = certain_sign(plain_orient2d(x[i], x[(i + 1) % 3], p, ray.axis), bound);
        low = std::min(low, s);
        high = std::max(high, s);
    }
    if (low < 0 && high > 0) return Answer::misses;
    if (low <= 0 && high >= 0) return Answer::open;
    const int above = certain_sign(plain_orient3d(x[0], x[1], x[2], p), bounds_.orient3d);
    if (above == 0) return Answer::open;
    return above * low * ray.sign < 0 ? Answer::crosses : Answer::misses;
}

template <class Take>
void RayQuery::walk(const TreeRay& ray, Take&& take) {
    const auto bound = [&](const auto& node) {
        ++counts_.box_tests;
        return ray_mask(ray, node);
    };
    walk_triangles(tree_.boxes, stack_, bound, take);
}

bool RayQuery::crosses_odd(const TreeRay& ray, std::size_t of, const Triangle& triangle, std::uint32_t left_out) {
    const RayDirection direction{ray.axis, ray.sign};
    bool is_odd = false;
    walk(ray, [&](std::uint32_t index) {
        if (index == left_out) return true;
        Answer answer = filter(index, {of, triangle[0]}, direction);
        if (answer == Answer::open) {
            const auto [p, q, r] = corners_and(of, triangle);
            const auto points = corners_and(body_, triangle_at(body_, index), p, q, r);
            const bool is_crossed =
                with_signs(frame_, points, [&](auto& signs) { return inner_ray_crosses(signs, direction); });
            answer = is_crossed ? Answer::crosses : Answer::misses;
        }
        is_odd ^= answer == Answer::crosses;
        return true;
    });
    return is_odd;
}

bool RayQuery::is_inside(std::size_t of, const Triangle& triangle) {
    TreeRay ray;
    const Mat3& R = frame_.body(body_).pose->R;
    if (!set_ray(ray, tree_.boxes, R, origin_of({of, triangle[0]}), axes_across(of, triangle))) return false;
    return crosses_odd(ray, of, triangle, no_triangle);
}

bool RayQuery::is_inside_above(std::uint32_t index) {
    TreeRay ray;
    const Triangle& triangle = triangle_at(body_, index);
    const Mat3& R = frame_.body(body_).pose->R;
    const bool may_meet = set_ray(ray, tree_.boxes, R, origin_of({body_, triangle[0]}), axes_across(body_, triangle));
    ECODS_ASSERT(may_meet);
    if (!may_meet) return false;
    const int turn = with_signs(frame_, corners_and(body_, triangle),
                                [&](auto& signs) { return signs.orient2d(0, 1, 2, ray.axis); });
    // If the normal has the ray's direction, the ray is on the side from which the corners turn left; otherwise it is
    // on the other side.
    const bool is_odd = crosses_odd(ray, body_, triangle, index);
    return turn == ray.sign ? is_odd : !is_odd;
}

Side RayQuery::side_beside(VertexRef p, VertexRef q, VertexRef r) {
    TreeRay ray;
    if (!set_ray(ray, tree_.boxes, frame_.body(body_).pose->R, origin_of(p), 7)) return Side::outside;
    const RayDirection direction{ray.axis, ray.sign};
    bool is_on = false, is_inside = false;
    walk(ray, [&](std::uint32_t index) {
        const Answer answer = filter(index, p, direction);
        is_inside ^= answer == Answer::crosses;
        if (answer != Answer::open) return true;
        const auto points = corners_and(body_, triangle_at(body_, index), p, q, r);
        const RayContact contact =
            with_signs(frame_, points, [&](auto& signs) { return moved_ray_contact(signs, direction); });
        is_on = contact == RayContact::begins_on;
        is_inside ^= contact == RayContact::crosses;
        return !is_on;
    });
    return is_on ? Side::on : is_inside ? Side::inside : Side::outside;
}

namespace {

// Stores the feature of the triangle that contains the point in place.on, if there is such a feature and it precedes
// place.on in the order of kinds, triangles and corners.
void note(const PointFeature& feature, std::uint32_t triangle, RayQuery::Place& place) {
    using Kind = PointFeature::Kind;
    if (feature.kind == Kind::none) return;
    const Feature found{feature.kind == Kind::vertex ? Feature::Kind::vertex
                        : feature.kind == Kind::edge ? Feature::Kind::edge
                                                     : Feature::Kind::face,
                        triangle, static_cast<std::uint32_t>(feature.corner)};
    const auto order = [](const Feature& f) { return std::tuple(f.kind, f.triangle, f.corner); };
    if (!place.on || order(found) < order(*place.on)) place.on = found;
}

}  // namespace

RayQuery::Place RayQuery::flat_place_of(VertexRef point, std::span<const std::uint8_t> has_area) {
    Place place{false, {}};
    TreeRay at;
    const BodyRef& body = frame_.body(body_);
    if (!set_point(at, tree_.boxes, body.pose->R, origin_of(point))) return place;
    walk(at, [&](std::uint32_t index) {
        if (!has_area.empty() && has_area[index] == 0) return true;
        const Triangle& x = triangle_at(body_, index);
        note(with_signs(frame_, corners_and(body_, x, point), [](auto& signs) { return feature_at(signs); }), index,
             place);
        return true;
    });
    return place;
}

RayQuery::Place RayQuery::place_of(VertexRef point) {
    Place place{false, {}};
    TreeRay ray;
    const Mat3& R = frame_.body(body_).pose->R;
    if (!set_ray(ray, tree_.boxes, R, origin_of(point), 7)) return place;
    const RayDirection direction{ray.axis, ray.sign};
    walk(ray, [&](std::uint32_t index) {
        const Answer answer = filter(index, point, direction);
        if (answer == Answer::open) {
            with_signs(frame_, corners_and(body_, triangle_at(body_, index), point), [&](auto& signs) {
                if (signs.orient3d(0, 1, 2, 3) != 0) {
                    place.is_inside ^= ray_crosses(signs, direction);
                    return;
                }
                if (signs.normal_axis(0) < 0) return;  // a triangle without area bounds nothing
                note(feature_at(signs), index, place);
            });
        }
        place.is_inside ^= answer == Answer::crosses;
        return true;
    });
    return place;
}

}  // namespace ecods
