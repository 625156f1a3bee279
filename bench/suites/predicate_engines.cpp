#include "suites/predicate_engines.hpp"

#include <array>

#include "exact/point/point.hpp"
#include "exact/point/vertex_cache.hpp"
#include "exact/sign/plain_signs.hpp"
#include "exact/simplex/triangle_pair.hpp"

namespace ecods::bench {
namespace {

// Binds the bodies of each task in turn and has `answer` decide its pairs. What depends on meshes only is made when a
// scene is first seen.
template <class Answer>
void for_each_task(const PredicateScene& scene, TriangleRelations& bodies, Answer&& answer) {
    static thread_local const PredicateScene* prepared_scene = nullptr;
    static thread_local std::vector<exact::MeshExtent> extents;
    if (prepared_scene != &scene) {
        extents.clear();
        for (const PredicateBody& body : scene.bodies) extents.push_back(exact::measure(*body.mesh));
        prepared_scene = &scene;
    }
    for (const PredicateTask& task : scene.tasks) {
        const auto side = [&](std::size_t i) {
            return exact::BodyRef{scene.bodies[i].mesh.get(), &extents[i], &scene.bodies[i].pose};
        };
        bodies.bind(side(task.a), side(task.b));
        answer(task);
    }
}

TriangleRelations& shared_pair() {
    static thread_local TriangleRelations bodies;
    bodies.reset_counts();
    return bodies;
}

}  // namespace

Answers decide_exactly(const PredicateScene& scene, StageCounts* counts) {
    Answers answers;
    answers.reserve(scene.pair_count());
    TriangleRelations& bodies = shared_pair();
    for_each_task(scene, bodies, [&](const PredicateTask& task) {
        for (const TrianglePair pair : task.pairs) {
            answers.push_back(bodies.relation(pair.a, pair.b) != Relation::disjoint);
        }
    });
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
            Points<6> points;
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
