// Bullet's ray casts against a mesh.
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

#include "engines/bullet_mesh.hpp"
#include "engines/hit_engine.hpp"

namespace ecods::bench {

namespace {

struct Nearest final : btTriangleRaycastCallback {
    using btTriangleRaycastCallback::btTriangleRaycastCallback;
    HitAnswer answer;

    btScalar reportHit(const btVector3& /*normal*/, btScalar fraction, int /*part*/, int triangle) override {
        answer = {fraction, static_cast<double>(triangle)};
        return fraction;
    }
};

struct Noting final : btTriangleRaycastCallback {
    Noting(const btVector3& from, const btVector3& to, std::vector<std::uint32_t>& list)
        : btTriangleRaycastCallback(from, to), triangles(list) {}
    std::vector<std::uint32_t>& triangles;

    btScalar reportHit(const btVector3& /*normal*/, btScalar /*fraction*/, int /*part*/, int triangle) override {
        triangles.push_back(static_cast<std::uint32_t>(triangle));
        return 1;
    }
};

class HitBullet final : public FirstHits::Engine, public HitLists {
  public:
    explicit HitBullet(const scenes::SegmentWorkload& workload) : HitBullet(posed_triangles(workload)) {}

    HitAnswer ask(const Segment& segment, std::size_t /*index*/) override {
        const btVector3 from = to_bullet(segment.a), to = to_bullet(segment.b);
        Nearest nearest(from, to);
        shape_.performRaycast(&nearest, from, to);
        return nearest.answer;
    }

    void list(const Segment& segment, std::vector<std::uint32_t>& triangles) override {
        triangles.clear();
        const btVector3 from = to_bullet(segment.a), to = to_bullet(segment.b);
        Noting noting(from, to, triangles);
        shape_.performRaycast(&noting, from, to);
    }

  private:
    explicit HitBullet(const scenes::PosedTriangles& all)
        : arrays_(all.vertices, all.triangles), shape_(arrays_.get(), true) {}

    BulletArrays arrays_;
    btBvhTriangleMeshShape shape_;
};

}  // namespace

std::vector<HitMaker> bullet_hits() {
    return {{.name = "Bullet",
             .use = "btBvhTriangleMeshShape::performRaycast(), quantized tree; float",
             .has_lists = true,
             .traits = {.bodies = HitBodies::one},
             .set_up = makes<HitBullet>()}};
}

}  // namespace ecods::bench
