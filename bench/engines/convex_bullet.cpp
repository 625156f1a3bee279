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

class ConvexBullet final : public Convex::Engine {
  public:
    explicit ConvexBullet(const scenes::ConvexWorkload& workload) : question_(workload.question) {
        for (const scenes::NamedMesh& named : workload.meshes) hulls_.push_back(to_bullet_hull(*named.mesh));
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
        const auto along = [&](int axis) { return -static_cast<double>(normal[axis]); };
        return {-static_cast<double>(found.distance), {along(0), along(1), along(2)}};
    }

    scenes::ConvexQuestion question_;
    std::vector<std::unique_ptr<btConvexHullShape>> hulls_;
    btVoronoiSimplexSolver simplex_;
};

}  // namespace

std::vector<ConvexMaker> bullet_convex(scenes::ConvexQuestion question) {
    return {{.name = convex_second_yardstick,
             .use = question == scenes::ConvexQuestion::depth
                        ? "btConvexHullShape without margin, btGjkEpaSolver2::Penetration; single precision"
                        : "btConvexHullShape without margin, btGjkPairDetector with btVoronoiSimplexSolver; single "
                          "precision",
             .set_up = makes<ConvexBullet>()}};
}

}  // namespace ecods::bench
