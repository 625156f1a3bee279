#include "oracle/convex.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "oracle/convex_facets.hpp"
#include "oracle/float_environment.hpp"
#include "oracle/integer_points.hpp"

namespace ecods::oracle {
namespace {

using Point = Vector<mpz_class>;

// A positive multiple of the vector from the first point to the second.
Point between(const ExactClosest& closest) {
    Point way;
    for (std::size_t k = 0; k < 3; ++k) {
        const ExactFraction &p = closest.point_a.x[k], &q = closest.point_b.x[k];
        way[k] = q.num * p.den - p.num * q.den;
    }
    return way;
}

}  // namespace

struct ConvexPair::Impl {
    std::unique_ptr<const FloatEnvironment> environment = std::make_unique<FloatEnvironment>();
    ConvexBodies bodies;
    std::vector<DifferenceFacet> facets;
    std::vector<const DifferenceFacet*> nearest;  // that tie
    bool is_apart = false;

    Impl(const std::array<const Mesh*, 2>& meshes, const std::array<Pose, 2>& poses)
        : bodies(meshes, poses), facets(difference_facets(bodies)) {
        for (const DifferenceFacet& facet : facets) {
            const int order = nearest.empty() ? -1 : facet.compare(*nearest.front());
            if (order < 0) nearest.clear();
            if (order <= 0) nearest.push_back(&facet);
        }
        is_apart = sgn(nearest.front()->height) < 0 || (normal_of_flat_difference(bodies) && is_parted_by_closest());
        environment.reset();  // the caller's again
    }

    // Returns true if the vector between the closest points of all pairs of features has one body before the other. If
    // the bodies share a point, no vector does; otherwise this one.
    bool is_parted_by_closest() const {
        const Point way = between(closest_features(bodies));
        Point back = way;
        for (mpz_class& x : back) x = -x;
        const auto& [a, b] = bodies.exact;
        const Point &p = a.vertices[furthest(a, way).front()], &q = b.vertices[furthest(b, back).front()];
        return sgn(dot(way, Point(q - p))) > 0;
    }

    // The product of s with a normal, in units of the facets' heights.
    mpq_class along(const Vec3& s, const Point& normal) const {
        mpq_class sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += mpq_class(s[static_cast<int>(k)]) * mpq_class(normal[k]);
        const mpz_class unit = mpz_class(1) << static_cast<unsigned long>(std::abs(bodies.unit));
        return bodies.unit < 0 ? mpq_class(sum * unit) : mpq_class(sum / unit);
    }
};

ConvexPair::ConvexPair(const Mesh& mesh_a, const Pose& pose_a, const Mesh& mesh_b, const Pose& pose_b)
    : impl_(std::make_unique<Impl>(std::array{&mesh_a, &mesh_b}, std::array{pose_a, pose_b})) {}
ConvexPair::~ConvexPair() = default;

bool ConvexPair::share_a_point() const {
    return !impl_->is_apart;
}

ExactRoot ConvexPair::distance() const {
    const auto found = closest();
    return found ? found->distance : ExactRoot{0, 1, impl_->bodies.unit};
}

std::optional<ExactClosest> ConvexPair::closest() const {
    if (share_a_point()) return std::nullopt;
    const FloatEnvironment environment;
    return closest_features(impl_->bodies);
}

std::optional<ExactDepth> ConvexPair::depth() const {
    if (!share_a_point()) return std::nullopt;
    const DifferenceFacet& facet = *impl_->nearest.front();
    Point back = facet.normal;
    for (mpz_class& x : back) x = -x;
    const auto& [a, b] = impl_->bodies.exact;
    ExactDepth depth;
    depth.depth = {facet.height * facet.height, facet.square, impl_->bodies.unit};
    depth.a = impl_->bodies.features[0].name_of(furthest(a, facet.normal));
    depth.b = impl_->bodies.features[1].name_of(furthest(b, back));
    depth.normal.v = facet.normal;
    return depth;
}

std::optional<ExactClosest> ConvexPair::deepest() const {
    if (!share_a_point()) return std::nullopt;
    return deepest_features(impl_->bodies, *impl_->nearest.front());
}

// The difference of the closest points.
std::optional<ExactDirection> ConvexPair::direction() const {
    const auto found = closest();
    return found ? std::optional(ExactDirection{between(*found)}) : std::nullopt;
}

// Faces of both solids may have one normal.
std::size_t ConvexPair::depth_tie_count() const {
    std::set<Point> directions;
    for (const DifferenceFacet* facet : impl_->nearest) {
        Point n = facet->normal;
        const mpz_class divisor = gcd(gcd(n[0], n[1]), n[2]);
        for (mpz_class& x : n) x /= divisor;
        directions.insert(n);
    }
    return directions.size();
}

bool ConvexPair::are_parted_by(const Vec3& s) const {
    return std::ranges::any_of(impl_->facets, [&](const DifferenceFacet& facet) {
        return impl_->along(s, facet.normal) >= mpq_class(facet.height);
    });
}

bool ConvexPair::is_beyond_depth(const Vec3& s) const {
    const DifferenceFacet& facet = *impl_->nearest.front();
    return impl_->along(s, facet.normal) >= mpq_class(facet.height);
}

int ConvexPair::compare_to_depth(const Vec3& s) const {
    const DifferenceFacet& facet = *impl_->nearest.front();
    mpq_class square = 0;
    for (int k = 0; k < 3; ++k) square += mpq_class(s[k]) * mpq_class(s[k]);
    const mpz_class unit = mpz_class(1) << static_cast<unsigned long>(2 * std::abs(impl_->bodies.unit));
    square = impl_->bodies.unit < 0 ? mpq_class(square * unit) : mpq_class(square / unit);
    return cmp(mpq_class(square * facet.square), mpq_class(facet.height * facet.height));
}

int compare_distance(const Vec3& p, const Vec3& q, double d) {
    mpq_class square = 0;
    for (int k = 0; k < 3; ++k) {
        const mpq_class difference = mpq_class(p[k]) - mpq_class(q[k]);
        square += difference * difference;
    }
    return cmp(square, mpq_class(mpq_class(d) * mpq_class(d)));
}

namespace {

// Three of the points span a plane that has none beyond it: outwards along the normal; points in it, ascending.
struct HullPlane {
    Point normal;
    std::vector<std::uint32_t> points;
};

std::optional<HullPlane> hull_plane(const std::vector<Point>& points, const std::array<std::uint32_t, 3>& by) {
    const Point& origin = points[by[0]];
    HullPlane plane{cross(Point(points[by[1]] - origin), Point(points[by[2]] - origin)), {}};
    if (sgn(square_of(plane.normal)) == 0) return std::nullopt;
    int side = 0;
    for (std::uint32_t p = 0; p < points.size(); ++p) {
        const int sign = sgn(dot(plane.normal, Point(points[p] - origin)));
        if (sign * side < 0) return std::nullopt;
        if (sign != 0) side = sign;
        if (sign == 0) plane.points.push_back(p);
    }
    if (side > 0) {
        for (mpz_class& x : plane.normal) x = -x;
    }
    return plane;
}

// Turned so that the first coordinate of the normal that is not zero is positive.
HullPlane turned_up(HullPlane plane) {
    const auto first = std::ranges::find_if(plane.normal, [](const mpz_class& x) { return sgn(x) != 0; });
    if (sgn(*first) < 0) {
        for (mpz_class& x : plane.normal) x = -x;
    }
    return plane;
}

// Whether a point of a plane is a convex combination of others of it: it is on no line that has the rest on one side
// and itself as an end.
std::vector<std::uint32_t> corners_of(const HullPlane& plane, const std::vector<Point>& points) {
    // Each directed side of the polygon: everything is left of it, and it is as long as can be.
    std::map<std::uint32_t, std::uint32_t> next;
    for (const std::uint32_t p : plane.points) {
        for (const std::uint32_t q : plane.points) {
            if (p == q) continue;
            const Point way = points[q] - points[p];
            const bool is_side = std::ranges::all_of(plane.points, [&](std::uint32_t x) {
                const Point to = points[x] - points[p];
                const int turn = sgn(dot(plane.normal, cross(way, to)));
                return turn > 0 || (turn == 0 && sgn(dot(way, to)) >= 0 && square_of(to) <= square_of(way));
            });
            if (is_side) next[p] = q;
        }
    }
    std::vector<std::uint32_t> corners{next.begin()->first};
    while (next[corners.back()] != corners.front()) corners.push_back(next[corners.back()]);
    return corners;
}

}  // namespace

std::optional<HullOfPoints> hull_of(std::span<const Vec3> given) {
    const FloatEnvironment environment;
    // Of equal points the first; each known by its index.
    std::vector<std::uint32_t> index;
    std::vector<Triangle> each;
    for (std::uint32_t i = 0; i < given.size(); ++i) {
        if (std::ranges::none_of(index, [&](std::uint32_t j) { return given[j] == given[i]; })) index.push_back(i);
        each.push_back({i, i, i});
    }
    const Soup soup{given, each, Pose()};
    const CommonIntegers integers({&soup, 1});
    std::vector<Point> points;
    for (const std::uint32_t i : index) points.push_back(integers.points.front()[i]);

    std::set<std::vector<std::uint32_t>> faces;  // from the least corner on
    const auto count = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        for (std::uint32_t j = i + 1; j < count; ++j) {
            for (std::uint32_t k = j + 1; k < count; ++k) {
                const auto plane = hull_plane(points, {i, j, k});
                if (!plane) continue;
                const bool is_flat = plane->points.size() == points.size();
                faces.insert(corners_of(is_flat ? turned_up(*plane) : *plane, points));
            }
        }
    }
    if (points.empty()) return std::nullopt;
    if (faces.empty()) {
        // A segment or a point.
        const auto [low, high] = std::ranges::minmax_element(points);
        const auto from = static_cast<std::uint32_t>(low - points.begin()),
                   to = static_cast<std::uint32_t>(high - points.begin());
        if (from == to) return HullOfPoints{{index[from]}, {{0, 0, 0}}};
        return HullOfPoints{{index[std::min(from, to)], index[std::max(from, to)]}, {{0, 1, 1}}};
    }
    std::set<std::uint32_t> used;
    for (const auto& face : faces) used.insert(face.begin(), face.end());
    HullOfPoints hull;
    std::map<std::uint32_t, std::uint32_t> place;
    for (const std::uint32_t p : used) {
        place[p] = static_cast<std::uint32_t>(hull.points.size());
        hull.points.push_back(index[p]);
    }
    for (const auto& face : faces) {
        for (std::size_t c = 2; c < face.size(); ++c) {
            hull.triangles.push_back({place[face[0]], place[face[c - 1]], place[face[c]]});
        }
    }
    std::ranges::sort(hull.triangles);
    return hull;
}

}  // namespace ecods::oracle
