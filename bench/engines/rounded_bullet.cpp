// Bullet's algorithms for two shapes, as its dispatcher chooses them: one for spheres, and GJK, with a formula for
// capsules. Each pair of shapes keeps its algorithm, as in a world.
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "engines/bullet_mesh.hpp"
#include "engines/rounded_engine.hpp"

namespace ecods::bench {

namespace {

std::unique_ptr<btConvexShape> to_bullet(const RoundBody& body) {
    const auto radius = static_cast<btScalar>(body.radius), size = static_cast<btScalar>(body.size);
    if (body.kind == RoundKind::sphere) return std::make_unique<btSphereShape>(radius);
    if (body.kind == RoundKind::capsule) return std::make_unique<btCapsuleShapeZ>(radius, 2 * size);
    return std::make_unique<btBoxShape>(btVector3(size, size, size));
}

// Keeps the least distance of the points that an algorithm reports.
class LeastPoint final : public btManifoldResult {
  public:
    using btManifoldResult::btManifoldResult;
    void addContactPoint(const btVector3& normal_on_b, const btVector3& point, btScalar depth) override {
        if (depth >= distance) return;
        distance = depth;
        on_b = point;
        on_a = point + normal_on_b * depth;
    }

    btScalar distance = BT_LARGE_FLOAT;
    btVector3 on_a = btVector3(0, 0, 0), on_b = btVector3(0, 0, 0);
};

class RoundBullet final : public Round::Engine {
  public:
    explicit RoundBullet(const RoundWorkload& workload) : question_(workload.question), dispatcher_(&configuration_) {
        for (const RoundBody& body : workload.bodies) shapes_.push_back(to_bullet(body));
    }
    ~RoundBullet() override {
        for (auto& [shapes, pair] : pairs_) {
            pair.algorithm->~btCollisionAlgorithm();
            dispatcher_.freeCollisionAlgorithm(pair.algorithm);
        }
    }
    RoundBullet(const RoundBullet&) = delete;
    RoundBullet& operator=(const RoundBullet&) = delete;

    RoundAnswer ask(const RoundQuery& query, std::size_t /*index*/) override {
        Pair& pair = pair_of(query.a.body_index, query.b.body_index);
        pair.a.setWorldTransform(bench::to_bullet(query.a.pose));
        pair.b.setWorldTransform(bench::to_bullet(query.b.pose));
        const btCollisionObjectWrapper a(nullptr, pair.a.getCollisionShape(), &pair.a, pair.a.getWorldTransform(), -1,
                                         -1);
        const btCollisionObjectWrapper b(nullptr, pair.b.getCollisionShape(), &pair.b, pair.b.getWorldTransform(), -1,
                                         -1);
        LeastPoint found(&a, &b);
        const bool is_bool = question_ == RoundQuestion::intersects;
        found.m_closestPointDistanceThreshold = is_bool ? btScalar(0) : btScalar(1000);
        pair.algorithm->processCollision(&a, &b, dispatch_, &found);
        if (is_bool) return {found.distance <= 0 ? 1.0 : 0.0};
        const auto number = static_cast<double>(found.distance);
        RoundAnswer answer{question_ == RoundQuestion::signed_distance ? number : std::max(number, 0.0)};
        if (question_ != RoundQuestion::closest) return answer;
        for (int k = 0; k < 3; ++k) {
            answer.points[static_cast<std::size_t>(k)] = static_cast<double>(found.on_a[k]);
            answer.points[static_cast<std::size_t>(3 + k)] = static_cast<double>(found.on_b[k]);
        }
        return answer;
    }

  private:
    struct Pair {
        btCollisionObject a, b;
        btCollisionAlgorithm* algorithm = nullptr;
    };

    Pair& pair_of(std::size_t a, std::size_t b) {
        const auto [at, is_new] = pairs_.try_emplace({a, b});
        Pair& pair = at->second;
        if (!is_new) return pair;
        pair.a.setCollisionShape(shapes_[a].get());
        pair.b.setCollisionShape(shapes_[b].get());
        const btCollisionObjectWrapper x(nullptr, shapes_[a].get(), &pair.a, pair.a.getWorldTransform(), -1, -1);
        const btCollisionObjectWrapper y(nullptr, shapes_[b].get(), &pair.b, pair.b.getWorldTransform(), -1, -1);
        pair.algorithm = dispatcher_.findAlgorithm(&x, &y, nullptr, BT_CLOSEST_POINT_ALGORITHMS);
        return pair;
    }

    RoundQuestion question_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDispatcherInfo dispatch_;
    std::vector<std::unique_ptr<btConvexShape>> shapes_;
    std::map<std::pair<std::size_t, std::size_t>, Pair> pairs_;
};

}  // namespace

std::vector<RoundMaker> bullet_round() {
    return {{.name = round_bullet,
             .use = "btSphereShape, btCapsuleShapeZ, btBoxShape with its margin inside; the dispatcher's algorithm for "
                    "closest points, kept for each pair of shapes; single precision",
             .set_up = makes<RoundBullet>()}};
}

}  // namespace ecods::bench
