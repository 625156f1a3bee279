// Bullet's GJK and EPA of two convex hulls without margin, each called by itself.
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <limits>
#include <vector>

#include "engines/bullet_mesh.hpp"
#include "engines/convex_engine.hpp"

namespace ecods::bench {

namespace {

class ConvexBullet final : public ConvexEngine {
  public:
    explicit ConvexBullet(const scenes::ConvexWorkload& workload) : question_(workload.question) {
        for (const scenes::NamedMesh& named : workload.pairs.meshes) {
            hulls_.push_back(std::make_unique<btConvexHullShape>());
            for (const Vec3& v : named.mesh->vertices()) hulls_.back()->addPoint(to_bullet(v), false);
            hulls_.back()->recalcLocalAabb();
            hulls_.back()->setMargin(0);
        }
    }

    ConvexAnswer ask(const scenes::MeshQuery& query, std::size_t /*index*/) override {
        const btConvexHullShape &a = *hulls_[query.a.mesh_index], &b = *hulls_[query.b.mesh_index];
        const btTransform at_a = to_bullet(query.a.pose), at_b = to_bullet(query.b.pose);
        return question_ == scenes::ConvexQuestion::depth ? depth(a, at_a, b, at_b) : distance(a, at_a, b, at_b);
    }

  private:
    ConvexAnswer distance(const btConvexHullShape& a, const btTransform& at_a, const btConvexHullShape& b,
                          const btTransform& at_b) {
        btGjkPairDetector detector(&a, &b, &simplex_, nullptr);
        btDiscreteCollisionDetectorInterface::ClosestPointInput input;
        input.m_transformA = at_a;
        input.m_transformB = at_b;
        btPointCollector found;
        detector.getClosestPoints(input, found, nullptr);
        // It says nothing where the origin of the differences is too near to its simplex.
        return {found.m_hasResult ? static_cast<double>(found.m_distance) : 0};
    }

    static ConvexAnswer depth(const btConvexHullShape& a, const btTransform& at_a, const btConvexHullShape& b,
                              const btTransform& at_b) {
        btGjkEpaSolver2::sResults found;
        const btVector3 guess = at_b.getOrigin() - at_a.getOrigin();
        if (!btGjkEpaSolver2::Penetration(&a, at_a, &b, at_b, guess, found))
            return {std::numeric_limits<double>::quiet_NaN()};
        const btVector3 normal = at_a.getBasis() * found.normal;  // it is a's own; a moves along it
        return {
            -static_cast<double>(found.distance),
            -Vec3(static_cast<double>(normal.x()), static_cast<double>(normal.y()), static_cast<double>(normal.z()))};
    }

    scenes::ConvexQuestion question_;
    std::vector<std::unique_ptr<btConvexHullShape>> hulls_;
    btVoronoiSimplexSolver simplex_;
};

}  // namespace

std::unique_ptr<ConvexEngine> set_up_convex_bullet(const scenes::ConvexWorkload& workload) {
    return std::make_unique<ConvexBullet>(workload);
}

}  // namespace ecods::bench
