// Bullet's broad phases. Their caches keep pairs that no longer overlap for a while (and Dbvt pairs of fattened boxes),
// so the boxes of each cached pair are tested, as Bullet's dispatcher does before it calls a narrow phase.
#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <btBulletCollisionCommon.h>

#include <algorithm>
#include <cstdint>
#include <memory>

#include "engines/broad_engine.hpp"
#include "engines/bullet_mesh.hpp"

namespace ecods::bench {

namespace {

class BroadBullet final : public BroadEngine {
  public:
    using MakeBroadPhase = std::unique_ptr<btBroadphaseInterface> (*)(const scenes::MovingBoxes& boxes);

    BroadBullet(const scenes::MovingBoxes& boxes, MakeBroadPhase make)
        : dispatcher_(&configuration_), broad_phase_(make(boxes)) {
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

    std::vector<ProxyPair> pairs() const override { return pairs_; }

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

std::unique_ptr<btBroadphaseInterface> make_dbvt(const scenes::MovingBoxes& /*boxes*/) {
    return std::make_unique<btDbvtBroadphase>();
}

std::unique_ptr<btBroadphaseInterface> make_sweep(const scenes::MovingBoxes& boxes) {
    Aabb all = boxes.boxes.front();
    for (const Aabb& box : boxes.boxes) all = merge(all, box);
    for (const std::vector<scenes::BoxMove>& frame : boxes.frames)
        for (const scenes::BoxMove& move : frame) all = merge(all, move.box);
    return std::make_unique<btAxisSweep3>(to_bullet(all.min), to_bullet(all.max),
                                          static_cast<unsigned short>(boxes.boxes.size() + 2));
}

}  // namespace

std::vector<BroadMaker> bullet_broad() {
    return {{.name = "Bullet Dbvt",
             .use =
                 "btDbvtBroadphase: setAabb(), calculateOverlappingPairs(), then its pairs, whose boxes are tested as "
                 "its dispatcher does; float",
             .set_up = makes<BroadBullet>(make_dbvt)}};
}

std::vector<BroadMaker> more_bullet_broad() {
    return {{.name = "Bullet AxisSweep3",
             .use = "btAxisSweep3, the same as Dbvt; 16 bits, then float",
             .traits = {.count_max = 1000},
             .set_up = makes<BroadBullet>(make_sweep)}};
}

}  // namespace ecods::bench
