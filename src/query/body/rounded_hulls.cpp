// Finds the closest points of two small convex cores. Doubles guess the closest features, and fixed precision finds the
// closest points of these features. The points found are closest points of the cores if no vertex is beyond a feature
// (closest_hulls.hpp).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/arithmetic.hpp"
#include "base/double_key.hpp"
#include "exact/number/power.hpp"
#include "exact/point/segment_ends.hpp"
#include "exact/simplex/common_pose.hpp"
#include "query/body/rounded_segments.hpp"
#include "query/convex/convex_parts.hpp"
#include "query/convex/hull_features.hpp"

namespace ecods {
namespace {

using convex::SmallFeatures;
using convex::SmallHull;
using convex::SmallHulls;
using exact::Point;

// Meaning selects how features are named: as features of the convex set, or as features of its triangles.
enum class Meaning : std::uint8_t { sets, triangles };

Meaning meaning_of(const CoreAndRadius& a, const CoreAndRadius& b) {
    const auto is_set = [](const Posed<MeshShape>& core) {
        return core.what->form() == MeshForm::convex && exact::is_regular(core.pose.R);
    };
    return is_set(a.core) && is_set(b.core) ? Meaning::sets : Meaning::triangles;
}

// NamedFeature chooses the corners and the name of the closest feature of one hull.
class NamedFeature {
  public:
    NamedFeature(const SmallHulls& hulls, std::size_t side, SmallFeatures& features, Meaning meaning)
        : hulls_(hulls), hull_(hulls[side]), side_(side), features_(features), meaning_(meaning) {}

    // Sets `name`, and the corners of a face to those of the triangle that contains the closest point. Returns false if
    // the hull has no such feature, or if the triangles name the feature in another way.
    bool find(Feature& name) {
        return hull_.hull() == nullptr ? find_of_triangle(name) : find_of_solid(*hull_.hull(), name);
    }

  private:
    std::array<std::uint32_t, 3>& corners() const noexcept { return features_.corners[side_]; }
    std::size_t count() const noexcept { return features_.count[side_]; }

    // Sets `name` to the feature of the core's only triangle. An edge is named by the corner at which it begins.
    bool find_of_triangle(Feature& name) const noexcept {
        const auto [i, j, k] = corners();
        name = {static_cast<Feature::Kind>(count() - 1), 0, i};
        if (count() == 2) name.corner = hull_.vertex_count() == 2 ? 0 : j == (i + 1) % 3 ? i : j;
        if (count() == 3) name.corner = 0;
        return true;
    }

    bool find_of_solid(const convex::Hull& hull, Feature& name) {
        const auto& solid = static_cast<const ConvexSolid&>(*hull_.posed().what);
        const convex::FaceTriangles* triangles = nullptr;
        if (meaning_ == Meaning::triangles) {
            triangles = &ConvexSolidAccess::face_triangles(solid);
            if (!triangles->is_plain()) return false;
        }
        if (count() == 1) {
            name = hull.vertex_names[corners()[0]];
            return true;
        }
        if (count() == 2) return find_edge(hull, name);
        const std::uint32_t face = convex::face_of(hull, corners());
        if (face == convex::Hull::no_face) return false;
        name = hull.faces[face].name;
        return triangles == nullptr || hull.faces[face].count == 3 || choose(solid, triangles->of(face), name);
    }

    bool find_edge(const convex::Hull& hull, Feature& name) const noexcept {
        for (const convex::Hull::Neighbor& to : hull.neighbors_of(corners()[0])) {
            if (to.vertex != corners()[1]) continue;
            name = hull.edges[to.edge].name;
            return true;
        }
        return false;
    }

    // Sets `name` to the triangle of a face in which the foot of the other hull's vertex is furthest from the sides, in
    // doubles. Returns false if the foot is in none of the triangles.
    bool choose(const ConvexSolid& solid, std::span<const std::uint32_t> triangles, Feature& name) {
        const auto& vertex_of = ConvexSolidAccess::points(solid).hull_index;
        const Point x = hulls_.rounded(1 - side_, features_.corners[1 - side_][0]);
        double most = 0;
        for (const std::uint32_t i : triangles) {
            const auto& [a, b, c] = solid.mesh().triangles()[i];
            const std::array<std::uint32_t, 3> at{vertex_of[a], vertex_of[b], vertex_of[c]};
            const Point p = hull_.at(at[0]), w = exact::minus(x, p);
            const Point u = exact::minus(hull_.at(at[1]), p), v = exact::minus(hull_.at(at[2]), p);
            const Point n = exact::cross(u, v);
            const double nn = exact::dot(n, n);
            const double s = exact::dot(exact::cross(w, v), n) / nn, t = exact::dot(exact::cross(u, w), n) / nn;
            const double least = std::min(std::min(s, t), 1 - s - t);
            if (!(least > most)) continue;
            most = least;
            corners() = at;
            name.triangle = i;
        }
        return most > 0;
    }

    const SmallHulls& hulls_;
    const SmallHull& hull_;
    std::size_t side_;
    SmallFeatures& features_;
    Meaning meaning_;
};

exact::PosedFeature feature_of(const SmallHull& hull, const std::array<std::uint32_t, 3>& corners,
                               std::size_t count) noexcept {
    exact::PosedFeature result{&hull.posed().pose, {}, count};
    for (std::size_t i = 0; i < count; ++i) result.corners[i] = &hull.vertex(corners[i]);
    return result;
}

// Returns true if all other vertices of both cores are certainly behind the features, along w. In doubles, a coordinate
// of w is off by `errors`, and by one unit for the digits that are cut off.
bool are_closest(const SmallHulls& hulls, const SmallFeatures& features, const exact::IntegerVector& w,
                 const exact::ErrorBounds& errors) noexcept {
    const std::uint64_t most = std::max({errors[0], errors[1], errors[2]});
    const exact::ScaledVector n = exact::scaled(w, most == 0);
    const double error = n.shift >= 0 ? 1.01 * (static_cast<double>(most) * exact::power_of_two(-n.shift)) + 1.01 : 0;
    return hulls.are_others_behind(0, features, n.x, error) && hulls.are_others_behind(1, features, n.x, error);
}

}  // namespace

std::optional<RoundedSegments> RoundedSegments::find_of_hulls(const CoreAndRadius& a, const CoreAndRadius& b,
                                                              convex::SmallHulls& hulls) {
    std::optional<SmallFeatures> features = hulls.guess_closest();
    if (!features) return std::nullopt;
    const Meaning meaning = meaning_of(a, b);
    Names names;
    if (!NamedFeature(hulls, 0, *features, meaning).find(names.a) ||
        !NamedFeature(hulls, 1, *features, meaning).find(names.b)) {
        return std::nullopt;
    }
    const auto found = FixedClosest::of_features({feature_of(hulls[0], features->corners[0], features->count[0]),
                                                  feature_of(hulls[1], features->corners[1], features->count[1])},
                                                 {a.radius, b.radius}, names);
    if (!found || !are_closest(hulls, *features, found->between(), found->errors())) return std::nullopt;
    return RoundedSegments(*found);
}

}  // namespace ecods
