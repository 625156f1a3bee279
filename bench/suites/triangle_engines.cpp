#include "suites/triangle_engines.hpp"

#include <array>

#include "ecods/primitives.hpp"
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

using scenes::PosedPair;

using FloatVector = Eigen::Vector3f;
using SixFloats = std::array<FloatVector, 6>;

// exact::PlainSigns in single precision.
class FloatSigns {
  public:
    explicit FloatSigns(const SixFloats& points) : points_(points) {}

    std::array<int, 3> sides(int plane, int points) const {
        const FloatVector n = normal(plane, plane + 1, plane + 2);
        return {side(n, plane, points), side(n, plane, points + 1), side(n, plane, points + 2)};
    }
    int orient3d(int a, int b, int c, int d) const { return side(normal(a, b, c), a, d); }
    int orient2d(int a, int b, int c, int axis) const {
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        const FloatVector ab = at(b) - at(a), ac = at(c) - at(a);
        return sign_of(ab[i] * ac[j] - ab[j] * ac[i]);
    }
    int compare(int a, int b, int axis) const { return sign_of(at(a)[axis] - at(b)[axis]); }
    int normal_axis(int plane) const {
        const FloatVector n = normal(plane, plane + 1, plane + 2);
        return n[0] != 0 ? 0 : n[1] != 0 ? 1 : n[2] != 0 ? 2 : -1;
    }

  private:
    static int sign_of(float x) { return (x > 0) - (x < 0); }
    const FloatVector& at(int point) const { return points_[static_cast<std::size_t>(point)]; }
    FloatVector normal(int a, int b, int c) const { return (at(b) - at(a)).cross(at(c) - at(a)); }
    int side(const FloatVector& n, int a, int p) const { return sign_of(n.dot(at(p) - at(a))); }

    const SixFloats& points_;
};

template <class Answer>
Answers answer_each(std::span<const PosedPair> pairs, Answer&& answer) {
    Answers answers;
    answers.reserve(pairs.size());
    for (const PosedPair& pair : pairs) answers.push_back(answer(pair) != Relation::apart);
    return answers;
}

FloatVector pose_in_float(const Pose& pose, const Vec3& v) {
    return pose.R.cast<float>() * v.cast<float>() + pose.t.cast<float>();
}

}  // namespace

Answers decide_exactly(const PredicateScene& scene, StageCounts* counts) {
    Answers answers;
    answers.reserve(scene.pair_count());
    TriangleRelations& bodies = shared_pair();
    for_each_task(scene, bodies, [&](const PredicateTask& task) {
        for (const TrianglePair pair : task.pairs) {
            answers.push_back(bodies.relation(pair.a, pair.b) != Relation::apart);
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
            answers.push_back(triangle_pair(signs) != Relation::apart);
        }
    }
    return answers;
}

Answers answer_by_ecods(std::span<const PosedPair> pairs) {
    return answer_each(pairs, [](const PosedPair& pair) {
        return triangle_triangle(PosedTriangle{pair.pose_a, pair.a}, PosedTriangle{pair.pose_b, pair.b});
    });
}

Answers answer_in_double(std::span<const PosedPair> pairs) {
    return answer_each(pairs, [](const PosedPair& pair) {
        exact::Points<6> points;
        for (std::size_t i = 0; i < 3; ++i) {
            points[i] = exact::pose_point(pair.pose_a.R, pair.a[i], pair.pose_a.t);
            points[3 + i] = exact::pose_point(pair.pose_b.R, pair.b[i], pair.pose_b.t);
        }
        exact::PlainSigns signs(points);
        return exact::triangle_pair(signs);
    });
}

Answers answer_in_float(std::span<const PosedPair> pairs) {
    return answer_each(pairs, [](const PosedPair& pair) {
        SixFloats points;
        for (std::size_t i = 0; i < 3; ++i) {
            points[i] = pose_in_float(pair.pose_a, pair.a[i]);
            points[3 + i] = pose_in_float(pair.pose_b, pair.b[i]);
        }
        FloatSigns signs(points);
        return exact::triangle_pair(signs);
    });
}

}  // namespace ecods::bench
