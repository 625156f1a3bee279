// Proofs of the closest features of convex solids and of their meeting, and the exact search, from any vertices.
#include <algorithm>
#include <memory>
#include <optional>

#include "ecods/error.hpp"
#include "oracle/convex.hpp"
#include "oracle/nearest.hpp"
#include "property/guesses/bodies.hpp"
#include "property/guesses/check.hpp"
#include "query/convex/closest_hulls.hpp"

namespace ecods::guesses {
namespace {

using namespace convex;

// The hull of the points and of some more around the first; null where they have none.
std::unique_ptr<const ConvexSolid> some_hull(Random& random, const Mesh& mesh) {
    std::vector<Vec3> points(mesh.vertices().begin(), mesh.vertices().end());
    double size = 0;
    for (const Vec3& p : points) size = std::max(size, (p - points[0]).cwiseAbs().maxCoeff());
    for (std::uint32_t i = random.below(4); i > 0; --i) points.push_back(points[0] + size * random.direction());
    if (!std::isfinite(size)) return nullptr;
    try {
        return std::make_unique<const ConvexSolid>(std::span<const Vec3>(points));
    } catch (const NotSolid&) {
        return nullptr;
    }
}

// Any pairs of vertices, all different; often the ones that a search ends with, with one of them changed.
Simplex some_simplex(Random& random, const PosedHulls& hulls) {
    Simplex simplex;
    const auto any_pair = [&] {
        return std::array{random.below(static_cast<std::uint32_t>(hulls.hull(0).vertex_count())),
                          random.below(static_cast<std::uint32_t>(hulls.hull(1).vertex_count()))};
    };
    if (random.below(2) == 0) {
        simplex = run_gjk(hulls, between_centers(hulls));
        if (random.below(2) == 0) simplex.pairs[random.below(static_cast<std::uint32_t>(simplex.count))] = any_pair();
        if (random.below(4) == 0) simplex.count = std::max(1, simplex.count - 1);
    } else {
        simplex.count = 1 + static_cast<int>(random.below(4));
        for (auto& pair : simplex.pairs) pair = any_pair();
    }
    std::sort(simplex.pairs.begin(), simplex.pairs.begin() + simplex.count);
    simplex.count = static_cast<int>(std::unique(simplex.pairs.begin(), simplex.pairs.begin() + simplex.count) -
                                     simplex.pairs.begin());
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
        const auto& [a, b] = simplex.pairs[i];
        simplex.points[i] = exact::minus(hulls.rounded(1, b), hulls.rounded(0, a));
    }
    return simplex;
}

// What is said of one guess.
struct SaidOfHulls {
    bool is_meeting = false, is_apart = false;
    std::optional<double> proven, searched;  // distances
    std::optional<ClosestPoints> only;       // where the proof says that no other features are as near
};

SaidOfHulls say_of(PosedHulls& hulls, const Simplex& guess) {
    SaidOfHulls said;
    said.is_meeting = prove_meeting(hulls, guess);
    if (const auto closest = prove_closest(hulls, guess)) {
        said.proven = round_distance(hulls, closest->found);
        if (closest->are_only) said.only = name_closest(hulls, *closest);
    }
    const auto closest = find_closest_exactly(hulls, guess);
    said.is_apart = closest.has_value();
    if (closest) said.searched = round_distance(hulls, closest->found);
    return said;
}

bool is_named(const Feature& feature, const oracle::NamedFeature& named) {
    return static_cast<int>(feature.kind) == named.dimension && feature.triangle == named.triangle &&
           feature.corner == named.corner;
}

}  // namespace

void ask_convex(Case& c) {
    const Bodies bodies = some_bodies(c.random, 3);
    const auto a = some_hull(c.random, *bodies.a), b = some_hull(c.random, *bodies.b);
    if (!a || !b) return;
    const Posed<ConvexSolid> posed_a{*a, bodies.pose_a}, posed_b{*b, bodies.pose_b};
    QueryMemory memory;
    try {
        PosedHulls(posed_a, posed_b, memory);
    } catch (const SingularPose&) {
        return;
    }
    const oracle::ConvexPair truth(a->mesh(), bodies.pose_a, b->mesh(), bodies.pose_b);
    const auto closest = truth.closest();
    for_each_set_and_mode([&](const environment::FloatMode& mode, const std::string& where) {
        const SaidOfHulls said = in_mode(mode, [&] {
            PosedHulls hulls(posed_a, posed_b, memory);
            return say_of(hulls, some_simplex(c.random, hulls));
        });
        c.require(!said.is_meeting || !closest, "solids that are apart are said to meet", where);
        c.require(!said.proven || (closest && is_nearest(closest->distance, *said.proven)),
                  "a proof of another distance", where);
        c.require(!said.only || (closest && is_named(said.only->a, closest->a) && is_named(said.only->b, closest->b)),
                  "a proof of features that are not the only ones", where);
        c.require(said.is_apart == closest.has_value(), "the search says apart, or not, and is wrong", where);
        c.require(!said.searched || (closest && is_nearest(closest->distance, *said.searched)),
                  "the search ends at another distance", where);
        c.tally.telling += said.is_meeting + said.proven.has_value() + said.only.has_value() + 1;
    });
}

}  // namespace ecods::guesses
