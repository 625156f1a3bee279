// Bullet's broad phases. Their caches keep pairs that no longer overlap for a while (and Dbvt pairs of fattened boxes),
// so the boxes of each cached pair are tested, as Bullet's dispatcher does before it calls a narrow phase.
#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <btBulletCollisionCommon.h>

#include <algorithm>
#include <cstdint>
#include <memory>

#include "engines/broad_engine.hpp"

namespace ecods::bench {

namespace {

btVector3 to_bullet(const Vec3& v) {
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

class BroadBullet final : public BroadEngine {
  public:
    BroadBullet(const scenes::MovingBoxes& boxes, std::unique_ptr<btBroadphaseInterface> broad_phase)
        : dispatcher_(&configuration_), broad_phase_(std::move(broad_phase)) {
        for (const Aabb& box : boxes.boxes) proxies_.push_back(create(box, proxies_.size()));
    }

    void run_frame(std::span<const scenes::BoxMove> moves) override {
        for (const scenes::BoxMove& move : moves) {
            btBroadphaseProxy*& proxy = proxies_[move.index];
            if (move.is_new) {
                broad_phase_->destroyProxy(proxy, &dispatcher_);
                proxy = create(move.box, move.index);
            } else {
                broad_phase_->setAabb(proxy, to_bullet(move.box.min), to_bullet(move.box.max), &dispatcher_);
            }
        }
        broad_phase_->calculateOverlappingPairs(&dispatcher_);
        pairs_.clear();
        const btBroadphasePairArray& cached = broad_phase_->getOverlappingPairCache()->getOverlappingPairArray();
        for (int i = 0; i < cached.size(); ++i) {
            const btBroadphaseProxy &a = *cached[i].m_pProxy0, &b = *cached[i].m_pProxy1;
            if (!TestAabbAgainstAabb2(a.m_aabbMin, a.m_aabbMax, b.m_aabbMin, b.m_aabbMax)) continue;
            const auto [low, high] = std::minmax({index(a), index(b)});
            pairs_.push_back({low, high});
        }
    }

    std::span<const ProxyPair> pairs() const override { return pairs_; }

  private:
    btBroadphaseProxy* create(const Aabb& box, std::uintptr_t index) {
        btBroadphaseProxy* const proxy = broad_phase_->createProxy(
            to_bullet(box.min), to_bullet(box.max), BOX_SHAPE_PROXYTYPE, reinterpret_cast<void*>(index),
            btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter, &dispatcher_);
        // As a world does for a new object: AxisSweep3 knows a proxy's exact box from this call only.
        broad_phase_->setAabb(proxy, to_bullet(box.min), to_bullet(box.max), &dispatcher_);
        return proxy;
    }

    static ProxyIndex index(const btBroadphaseProxy& proxy) {
        return static_cast<ProxyIndex>(reinterpret_cast<std::uintptr_t>(proxy.m_clientObject));
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    std::unique_ptr<btBroadphaseInterface> broad_phase_;
    std::vector<btBroadphaseProxy*> proxies_;
    std::vector<ProxyPair> pairs_;
};

}  // namespace

std::unique_ptr<BroadEngine> set_up_broad_bullet_dbvt(const scenes::MovingBoxes& boxes) {
    return std::make_unique<BroadBullet>(boxes, std::make_unique<btDbvtBroadphase>());
}

std::unique_ptr<BroadEngine> set_up_broad_bullet_sweep(const scenes::MovingBoxes& boxes) {
    Aabb all = boxes.boxes.front();
    for (const Aabb& box : boxes.boxes) all = merge(all, box);
    for (const std::vector<scenes::BoxMove>& frame : boxes.frames)
        for (const scenes::BoxMove& move : frame) all = merge(all, move.box);
    return std::make_unique<BroadBullet>(
        boxes, std::make_unique<btAxisSweep3>(to_bullet(all.min), to_bullet(all.max),
                                              static_cast<unsigned short>(boxes.boxes.size() + 2)));
}

}  // namespace ecods::bench
