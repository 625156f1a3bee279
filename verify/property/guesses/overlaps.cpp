// Which nodes and triangles may share a point, and which triangles certainly cross; which ones a ray along an axis of
// the world, or a point, may meet.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "bvh/masks/ray_mask.hpp"
#include "bvh/walks/tree_view.hpp"
#include "oracle/hits.hpp"
#include "oracle/oracle.hpp"
#include "property/guesses/soups.hpp"

namespace ecods::guesses {
namespace {

std::array<Vec3, 3> corners_of(const Mesh& mesh, std::uint32_t triangle) {
    const Triangle& t = mesh.triangles()[triangle];
    return {mesh.vertices()[t[0]], mesh.vertices()[t[1]], mesh.vertices()[t[2]]};
}

}  // namespace

void ask_overlap(Case& c) {
    const Trees trees(c.random, c.random.below(8) == 0 ? 30 : 5);
    const Bodies& bodies = trees.bodies;
    std::vector<Relation> truth;
    for (std::uint32_t i = 0; i < trees.count_a; ++i) {
        for (std::uint32_t j = 0; j < trees.count_b; ++j) {
            truth.push_back(oracle::triangle_triangle(bodies.pose_a, corners_of(*bodies.a, i), bodies.pose_b,
                                                      corners_of(*bodies.b, j)));
        }
    }
    const bool are_apart = std::ranges::all_of(truth, [](Relation r) { return r == Relation::apart; });
    for_each_set_and_mode([&](const environment::FloatMode& mode, const std::string& where) {
        const int first = static_cast<int>(c.random.below(root_axis_count + 1)) - 1;
        std::vector<bool> reached, near(truth.size()), crossing(truth.size());
        const int axis = in_mode(mode, [&] {
            SeparatingAxes axes;
            const int separating = axes.bind(trees.posed_a(), trees.posed_b(), trees.d(), first);
            if (separating >= 0) return separating;
            reached = trees.reached([&](const auto& x, const auto& y) {
                if constexpr (both_leaves<std::remove_cvref_t<decltype(x)>, std::remove_cvref_t<decltype(y)>>) {
                    const TrianglePairs pairs = triangle_pairs(axes.sets(), x, y);
                    for (LanePairs lanes(pairs.near); lanes.more(); lanes.next()) {
                        const std::size_t k = trees.number(x.triangle[lanes.i()], y.triangle[lanes.j()]);
                        near[k] = true;
                        crossing[k] = lanes.is_in(pairs.crossing);
                    }
                }
                return overlap_mask(axes.sets(), x, y);
            });
            return separating;
        });
        if (axis >= 0) {
            c.require(are_apart, "roots that share a point are said to be apart", where);
            ++c.tally.telling;
            return;
        }
        for (std::size_t k = 0; k < truth.size(); ++k) {
            c.require(reached[k] || truth[k] == Relation::apart, "a pair that shares a point is dropped by its boxes",
                      where);
            c.require(near[k] || truth[k] == Relation::apart, "a pair that shares a point is dropped", where);
            c.require(!crossing[k] || truth[k] == Relation::crossing, "a pair is said to cross, and does not", where);
            c.tally.telling += !reached[k] + !near[k] + crossing[k];
        }
    });
}

namespace {

std::vector<bool> visited(const TreeRay& ray, const MeshBvh& tree, std::size_t count) {
    std::vector<bool> result(count);
    std::vector<TreeRef> stack;
    walk_triangles(
        tree, stack, [&](const auto& node) { return ray_mask(ray, node); },
        [&](std::uint32_t triangle) {
            result[triangle] = true;
            return true;
        });
    return result;
}

}  // namespace

void ask_axis_ray(Case& c) {
    const Trees trees(c.random, c.random.below(4) == 0 ? 20 : 8);
    const Mesh& mesh = *trees.bodies.a;
    const Pose& pose = trees.bodies.pose_a;
    const oracle::Soup soup = soup_of(mesh, pose);
    // A point of the body, or beside one along an axis, or of the other body.
    Vec3 p = c.random.below(4) == 0 ? some_point(c.random, *trees.bodies.b, trees.bodies.pose_b)
                                    : some_point(c.random, mesh, pose);
    if (!p.allFinite()) return;
    const int axis = static_cast<int>(c.random.below(3));
    if (c.random.below(2) == 0) p[axis] += (pose.R.cwiseAbs().maxCoeff() + std::abs(p[axis])) * c.random.uniform(-1, 1);
    if (!p.allFinite()) return;
    const std::uint32_t axes = 1 + c.random.below(7);
    std::array<std::vector<oracle::ExactHit>, 6> hits;  // up and down each axis
    for (int k = 0; k < 6; ++k) {
        const Vec3 along = (k % 2 == 0 ? 1 : -1) * Vec3::Unit(k / 2);
        hits[static_cast<std::size_t>(k)] =
            oracle::all_hits({p, along, true, std::numeric_limits<double>::infinity()}, soup);
    }
    const auto is_at = [](const oracle::ExactHit& hit) { return hit.enter == 0; };
    for_each_set_and_mode([&](const environment::FloatMode& mode, const std::string& where) {
        TreeRay ray, point;
        std::vector<bool> by_ray, by_point;
        bool ray_may_hit = false, point_may_hit = false;
        in_mode(mode, [&] {
            const RayOrigin origin{p - pose.t, 0};
            ray_may_hit = set_ray(ray, trees.a, pose.R, origin, axes);
            point_may_hit = set_point(point, trees.a, pose.R, origin);
            if (ray_may_hit) by_ray = visited(ray, trees.a, trees.count_a);
            if (point_may_hit) by_point = visited(point, trees.a, trees.count_a);
        });
        const auto at_point = [&](const auto& all) { return std::ranges::any_of(all, is_at); };
        c.require(ray_may_hit || !at_point(hits[0]), "a beginning on the body is said to be outside its box", where);
        c.require(point_may_hit || !at_point(hits[0]), "a point on the body is said to be outside its box", where);
        c.tally.telling += !ray_may_hit + !point_may_hit;
        if (ray_may_hit) {
            for (const oracle::ExactHit& hit : hits[static_cast<std::size_t>(2 * ray.axis + (ray.sign > 0 ? 0 : 1))]) {
                c.require(by_ray[hit.feature.triangle], "a triangle that the ray meets is dropped", where);
            }
            c.tally.telling += std::ranges::count(by_ray, false) > 0;
        }
        if (!point_may_hit) return;
        for (const oracle::ExactHit& hit : hits[0]) {
            c.require(by_point[hit.feature.triangle] || !is_at(hit), "a triangle that holds the point is dropped",
                      where);
        }
        c.tally.telling += std::ranges::count(by_point, false) > 0;
    });
}

}  // namespace ecods::guesses
