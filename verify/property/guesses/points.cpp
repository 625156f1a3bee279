// A point and a mesh: the walk of its tree, bounds of its triangles in floats, and their distances from the point with
// every feature for the closest.
#include <memory>
#include <vector>

#include "base/next.hpp"
#include "bvh/walks/walk_point.hpp"
#include "exact/measure/distance/enclose_distance.hpp"
#include "exact/measure/distance/fixed_distance.hpp"
#include "exact/measure/distance/guess_features.hpp"
#include "oracle/nearest.hpp"
#include "property/guesses/features.hpp"
#include "property/guesses/soups.hpp"

namespace ecods::guesses {
namespace {

using namespace exact;

constexpr Triangle all_equal{0, 0, 0};

// Asks about the point and the first triangle, with every feature of it.
void ask_enclosures(Case& c, const std::shared_ptr<const Mesh>& only, const Pose& at, const Bodies& bodies,
                    const oracle::MeshDistances& truth) {
    const oracle::ExactClosest closest = truth.closest(0, 0);
    const MeshExtent extent = measure(*only), extent_b = measure(*bodies.b);
    IntegerFrame frame;
    frame.bind_pair({only.get(), &extent, &at}, {bodies.b.get(), &extent_b, &bodies.pose_b});
    IntegerPair pair = integer_pair(frame, all_equal, bodies.b->triangles()[0]);
    pair.first_is_point = true;
    for_each_mode([&](const environment::FloatMode& mode) {
        for (const FeaturePair& features : feature_pairs) {
            if (features.vertex_side != 0 || features.a != 0 || features.kind == FeatureKind::edge_edge) continue;
            const Enclosure e = in_mode(mode, [&] { return enclose_distance(pair, features); });
            c.require(e.lower >= 0 && compare(closest.distance, e.lower) >= 0, "a lower end above the distance",
                      mode.name);
            c.require(e.upper >= 0 && compare(closest.distance, e.upper) <= 0, "an upper end below the distance",
                      mode.name);
            c.require(!e.is_certain || are_features(features, closest), "features that are not the closest", mode.name);
            c.tally.telling += (e.lower > 0) + (e.upper <= 0x1p1000) + e.is_certain;
            if (!e.is_certain) continue;
            const auto fixed = in_mode(mode, [&] { return fixed_distance(pair, features); });
            c.require(!fixed || is_nearest(closest.distance, *fixed), "a distance that is not rounded once", mode.name);
        }
    });
}

}  // namespace

void ask_point(Case& c) {
    const Trees trees(c.random, c.random.below(3) == 0 ? 40 : 3);
    const Bodies& bodies = trees.bodies;
    const bool is_own = c.random.below(2) == 0;
    const Vec3 point = is_own ? some_point(c.random, *bodies.b, bodies.pose_b) : bodies.pose_a.t;
    if (!point.allFinite()) return;

    const auto only = Mesh::create({Vec3::Zero()}, {all_equal});
    Pose at;
    at.t = point;
    const oracle::MeshDistances truth(soup_of(*only, at), soup_of(*bodies.b, bodies.pose_b));
    std::vector<oracle::ExactRoot> distances;
    std::size_t least = 0;
    for (std::uint32_t j = 0; j < trees.count_b; ++j) {
        distances.push_back(truth.distance(0, j));
        if (compare(distances[j], distances[least]) < 0) least = j;
    }
    for_each_set_and_mode([&](const environment::FloatMode& mode, const std::string& where) {
        PointAxes axes;
        PointWalk walk;
        in_mode(mode, [&] {
            axes.bind(trees.posed_b(), bodies.pose_b.t - point);
            if (axes.are_useful()) walk_point(trees.b, axes, walk);
        });
        if (!axes.are_useful()) return;
        std::vector<bool> is_found(trees.count_b);
        for (const NearTriangle& near : walk.found) {
            is_found[near.triangle] = true;
            const oracle::ExactRoot& d = distances[near.triangle];
            const double rounded = nearest(d), above = compare(d, rounded) <= 0 ? rounded : next_up(rounded);
            c.require(near.lower >= 0 && near.lower <= axes.square_above(above), "a lower bound above the distance",
                      where);
            c.tally.telling += near.lower > 0;
        }
        for (std::uint32_t j = 0; j < trees.count_b; ++j) {
            c.require(is_found[j] || compare(distances[j], distances[least]) > 0, "a nearest triangle is dropped",
                      where);
            c.tally.telling += !is_found[j];
        }
    });
    ask_enclosures(c, only, at, bodies, truth);
}

}  // namespace ecods::guesses
