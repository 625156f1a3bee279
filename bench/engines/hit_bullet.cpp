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
        answer = {fraction, static_cast<std::uint32_t>(triangle)};
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

class HitBullet final : public HitEngine {
  public:
    explicit HitBullet(const scenes::PosedTriangles& all)
        : arrays_(all.vertices, all.triangles), shape_(arrays_.get(), true) {}

    void first_hits(std::span<const Segment> segments, std::span<HitAnswer> answers) override {
        for (std::size_t i = 0; i < segments.size(); ++i) {
            const btVector3 from = to_bullet(segments[i].a), to = to_bullet(segments[i].b);
            Nearest nearest(from, to);
            shape_.performRaycast(&nearest, from, to);
            answers[i] = nearest.answer;
        }
    }

    void all_hits(const Segment& segment, std::vector<std::uint32_t>& triangles) override {
        triangles.clear();
        const btVector3 from = to_bullet(segment.a), to = to_bullet(segment.b);
        Noting noting(from, to, triangles);
        shape_.performRaycast(&noting, from, to);
    }

  private:
    BulletArrays arrays_;
    btBvhTriangleMeshShape shape_;
};

}  // namespace

std::unique_ptr<HitEngine> set_up_hit_bullet(const scenes::SegmentWorkload& workload) {
    return std::make_unique<HitBullet>(posed_triangles(workload));
}

}  // namespace ecods::bench
