// Bullet's sweep of a convex hull, as btCollisionWorld::convexSweepTest asks each object. The hull is solid and Bullet
// moves it by its poses; what it answers for a body that starts apart is comparable where a is the surface of its hull.
#include <limits>
#include <vector>

#include "engines/bullet_mesh.hpp"
#include "engines/cast_engine.hpp"

namespace ecods::bench {

namespace {

class CastBullet final : public Casts::Engine {
  public:
    explicit CastBullet(const scenes::CastWorkload& workload) : hull_(to_bullet_hull(*workload.meshes.back().mesh)) {
        if (workload.meshes.size() == 1) {
            object_.setCollisionShape(hull_.get());
            return;
        }
        const Mesh& mesh = *workload.meshes.front().mesh;
        arrays_ = std::make_unique<BulletArrays>(mesh.vertices(), mesh.triangles());
        triangles_ = std::make_unique<btBvhTriangleMeshShape>(arrays_->get(), true);
        triangles_->setMargin(0);
        object_.setCollisionShape(triangles_.get());
    }

    double ask(const scenes::CastQuery& query, std::size_t /*index*/) override {
        object_.setWorldTransform(to_bullet(query.b.pose));
        const btTransform from = to_bullet(query.a.pose), to = to_bullet(query.a_end);
        btCollisionWorld::ClosestConvexResultCallback closest(from.getOrigin(), to.getOrigin());
        btCollisionWorld::objectQuerySingle(hull_.get(), from, to, &object_, object_.getCollisionShape(),
                                            object_.getWorldTransform(), closest, 0);
        return closest.hasHit() ? closest.m_closestHitFraction : std::numeric_limits<double>::quiet_NaN();
    }

  private:
    std::unique_ptr<btConvexHullShape> hull_;
    std::unique_ptr<BulletArrays> arrays_;
    std::unique_ptr<btBvhTriangleMeshShape> triangles_;
    btCollisionObject object_;
};

}  // namespace

std::vector<CastMaker> bullet_casts() {
    return {{.name = "Bullet convex sweep",
             .use = "btCollisionWorld::objectQuerySingle() of btConvexHullShape, margins 0, which is by "
                    "btContinuousConvexCollision against a hull, or against each triangle near of a "
                    "btBvhTriangleMeshShape; float",
             .traits = {.is_for_hulls = true},
             .set_up = makes<CastBullet>()}};
}

}  // namespace ecods::bench
