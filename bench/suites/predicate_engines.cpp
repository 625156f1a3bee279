#include "suites/predicate_engines.hpp"

#include "exact/pose_point.hpp"
#include "exact/triangle_pair.hpp"

namespace ecods::bench {
namespace {

// What depends on the mesh only; the library makes it once, with the tree.
std::vector<exact::MeshExtent> extents(const PredicateScene& scene) {
    std::vector<exact::MeshExtent> result;
    for (const PredicateBody& body : scene.bodies) result.push_back(exact::measure(*body.mesh));
    return result;
}

}  // namespace

Answers decide_exactly(const PredicateScene& scene, exact::StageCounts* counts) {
    Answers answers;
    answers.reserve(scene.pair_count());
    static thread_local const PredicateScene* measured = nullptr;
    static thread_local std::vector<exact::MeshExtent> extent;
    if (measured != &scene) {
        extent = extents(scene);
        measured = &scene;
    }
    static thread_local exact::BodyPair bodies;
    bodies.reset_counts();
    for (const PredicateTask& task : scene.tasks) {
        const PredicateBody &a = scene.bodies[task.a], &b = scene.bodies[task.b];
        bodies.bind({a.mesh.get(), &extent[task.a], &a.pose}, {b.mesh.get(), &extent[task.b], &b.pose});
        for (const TrianglePair pair : task.pairs) {
            answers.push_back(bodies.relation(pair.a, pair.b) != Relation::disjoint);
        }
    }
    if (counts != nullptr) *counts = bodies.counts();
    return answers;
}

Answers decide_plainly(const PredicateScene& scene) {
    using namespace exact;
    Answers answers;
    answers.reserve(scene.pair_count());
    static thread_local VertexCache<Point> caches[2];
    for (const PredicateTask& task : scene.tasks) {
        const PredicateBody* bodies[2] = {&scene.bodies[task.a], &scene.bodies[task.b]};
        const Vec3 offsets[2] = {Vec3::Zero(), bodies[1]->pose.t - bodies[0]->pose.t};
        for (auto& cache : caches) cache.clear();
        for (const TrianglePair pair : task.pairs) {
            SixRounded points;
            for (std::size_t side = 0; side < 2; ++side) {
                const PredicateBody& body = *bodies[side];
                const Triangle& triangle = body.mesh->triangles()[side == 0 ? pair.a : pair.b];
                for (std::size_t i = 0; i < 3; ++i) {
                    points[3 * side + i] = caches[side].get(triangle[i], [&](Point& p) {
                        p = pose_point(body.pose.R, body.mesh->vertices()[triangle[i]], offsets[side]);
                    });
                }
            }
            PlainSigns signs(points);
            answers.push_back(triangle_pair(signs) != Relation::disjoint);
        }
    }
    return answers;
}

}  // namespace ecods::bench
