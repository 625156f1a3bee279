// Lower bounds of distances between nodes and between leaves, with any direction for that of the closest points; bounds
// of the distances of triangles in floats; and ranks of nodes that are far away.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/next.hpp"
#include "bvh/axes/distance_axes.hpp"
#include "bvh/axes/far_gap.hpp"
#include "bvh/masks/triangle_bounds.hpp"
#include "oracle/nearest.hpp"
#include "property/guesses/soups.hpp"

namespace ecods::guesses {
namespace {

constexpr float float_infinity = std::numeric_limits<float>::infinity();

Direction some_direction(Random& random) {
    if (random.below(6) == 0) return {};
    Vec3 n = random.direction();
    if (random.below(4) == 0) n = Vec3::Unit(static_cast<int>(random.below(3)));
    n *= (1 - 0x1p-12) * (random.below(3) == 0 ? random.uniform(0, 1) : 1);
    return {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])};
}

// What was said of a pair of triangles.
struct SaidOfPair {
    bool is_reached = false;
    double box = 0, lower = 0, upper = std::numeric_limits<double>::infinity();
};

std::vector<SaidOfPair> say(const Trees& trees, const Direction& n) {
    DistanceAxes axes;
    axes.bind(trees.posed_a(), trees.posed_b(), trees.d());
    std::vector<SaidOfPair> said(trees.pair_count());
    alignas(32) LaneBounds squares;
    trees.reached([&](const auto& x, const auto& y) {
        const std::uint64_t mask = near_mask(axes.sets(), n, float_infinity, x, y, squares);
        if constexpr (both_leaves<std::remove_cvref_t<decltype(x)>, std::remove_cvref_t<decltype(y)>>) {
            LeavesOnAxes leaves;
            put_on_axes(axes.sets()[0], x, y, leaves);
            for (LanePairs lanes(mask); lanes.more(); lanes.next()) {
                const std::size_t i = lanes.i(), j = lanes.j();
                TriangleBatch batch{};
                batch.add(leaves, i, j, {x.triangle[i], y.triangle[j]});
                TriangleSquares bounds;
                bound_triangles(axes.sets()[0], batch, bounds);
                SaidOfPair& of = said[trees.number(x.triangle[i], y.triangle[j])];
                of = {.is_reached = true,
                      .box = axes.distance_below(squares[tree_width * i + j]),
                      .lower = axes.distance_below(bounds.lower[0])};
                // Unbounded axes say nothing, and have no upper bound either.
                const double upper = axes.distance_above(bounds.upper[0]);
                if (!std::isnan(upper)) of.upper = upper;
            }
        }
        return mask;
    });
    return said;
}

// The distances of all triangles of two bodies.
struct Distances {
    std::vector<oracle::ExactRoot> distance;
    std::vector<double> above;  // doubles that are not below them

    explicit Distances(const Trees& trees) {
        const Bodies& bodies = trees.bodies;
        const oracle::MeshDistances all(soup_of(*bodies.a, bodies.pose_a), soup_of(*bodies.b, bodies.pose_b));
        for (std::uint32_t i = 0; i < trees.count_a; ++i) {
            for (std::uint32_t j = 0; j < trees.count_b; ++j) {
                distance.push_back(all.distance(i, j));
                const double d = nearest(distance.back());
                above.push_back(compare(distance.back(), d) <= 0 ? d : next_up(d));
            }
        }
    }
};

}  // namespace

void ask_near(Case& c) {
    const Trees trees(c.random, c.random.below(8) == 0 ? 30 : 6);
    const Distances truth(trees);
    const std::size_t some = c.random.below(static_cast<std::uint32_t>(trees.pair_count()));
    for_each_set_and_mode([&](const environment::FloatMode& mode, const std::string& where) {
        const Direction n = some_direction(c.random);
        for (std::size_t k = 0; const SaidOfPair& said : in_mode(mode, [&] { return say(trees, n); })) {
            const oracle::ExactRoot& d = truth.distance[k++];
            c.require(said.is_reached, "a pair is beyond infinity", where);
            c.require(said.box >= 0 && compare(d, said.box) >= 0, "a box further away than its triangle", where);
            c.require(said.lower >= 0 && compare(d, said.lower) >= 0, "a lower bound above the distance", where);
            c.require(said.upper >= 0 && compare(d, said.upper) <= 0, "an upper bound below the distance", where);
            c.tally.telling += (said.box > 0) + (said.lower > 0) + std::isfinite(said.upper);
        }
        const auto reached = in_mode(mode, [&] {
            DistanceAxes axes;
            axes.bind(trees.posed_a(), trees.posed_b(), trees.d());
            const float limit = axes.square_above(truth.above[some]);
            alignas(32) LaneBounds squares;
            return trees.reached(
                [&](const auto& x, const auto& y) { return near_mask(axes.sets(), n, limit, x, y, squares); });
        });
        c.require(reached[some], "a pair at the limit is dropped", where);
    });
}

void ask_far(Case& c) {
    Trees trees(c.random, c.random.below(4) == 0 ? 14 : 6);
    const double size =
        std::max(trees.bodies.pose_a.R.cwiseAbs().maxCoeff(), trees.bodies.pose_b.R.cwiseAbs().maxCoeff());
    const Vec3 by = size * some_power(c.random, 8, 50) * c.random.direction();
    if ((trees.bodies.pose_b.t + by).allFinite()) trees.bodies.pose_b.t += by;
    const Distances truth(trees);
    const std::size_t some = c.random.below(static_cast<std::uint32_t>(trees.pair_count()));
    for_each_set_and_mode([&](const environment::FloatMode& mode, const std::string& where) {
        std::vector<float> ranks(trees.pair_count(), float_infinity), above(trees.pair_count());
        std::vector<bool> at_limit;
        const bool is_far = in_mode(mode, [&] {
            const Vec3 d = trees.d();
            DistanceAxes axes;
            axes.bind(trees.posed_a(), trees.posed_b(), d);
            FarGap gap;
            gap.bind(axes, trees.posed_a(), trees.posed_b(), d);
            if (!gap.is_far()) return false;
            alignas(32) LaneBounds of_lanes;
            const float all = gap.rank_above(std::numeric_limits<double>::infinity());
            trees.reached([&](const auto& x, const auto& y) {
                const std::uint64_t mask = far_mask(gap, all, x, y, of_lanes);
                if constexpr (both_leaves<std::remove_cvref_t<decltype(x)>, std::remove_cvref_t<decltype(y)>>) {
                    for (LanePairs lanes(mask); lanes.more(); lanes.next()) {
                        ranks[trees.number(x.triangle[lanes.i()], y.triangle[lanes.j()])] =
                            of_lanes[tree_width * lanes.i() + lanes.j()];
                    }
                }
                return mask;
            });
            for (std::size_t k = 0; k < above.size(); ++k) above[k] = gap.rank_above(truth.above[k]);
            at_limit =
                trees.reached([&](const auto& x, const auto& y) { return far_mask(gap, above[some], x, y, of_lanes); });
            return true;
        });
        if (!is_far) return;
        for (std::size_t k = 0; k < above.size(); ++k) {
            c.require(ranks[k] <= above[k], "a rank above that of the distance, or a pair beyond infinity", where);
            c.tally.telling += ranks[k] > 0;
        }
        c.require(at_limit[some], "a pair at the limit is dropped", where);
    });
}

}  // namespace ecods::guesses
