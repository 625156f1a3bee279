// FCL's dynamic trees of boxes, and its sweep and prune. Objects are boxes that do not turn, so that FCL's bounds are
// the very boxes given.
#include <fcl/broadphase/broadphase_SaP.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include <cstdint>
#include <memory>

#include "engines/broad_engine.hpp"

namespace ecods::bench {

namespace {

// How the manager learns of moves: all of it is refitted, or the boxes that moved are named and inserted again. The
// first is faster while all move a little, the second when few do, or when some jump.
enum class Update { all, moved };

template <class Manager, Update update>
class BroadFcl final : public BroadEngine {
  public:
    explicit BroadFcl(const scenes::MovingBoxes& boxes) {
        std::vector<fcl::CollisionObjectd*> all;
        for (const Aabb& box : boxes.boxes) {
            auto shape = std::make_shared<fcl::Boxd>(fcl::Vector3d(box.max - box.min));
            auto object = std::make_unique<fcl::CollisionObjectd>(shape);
            object->setUserData(reinterpret_cast<void*>(static_cast<std::uintptr_t>(objects_.size())));
            move(*object, box);
            all.push_back(object.get());
            objects_.push_back(std::move(object));
        }
        manager_.registerObjects(all);
        manager_.setup();
    }

    void run_frame(std::span<const scenes::BoxMove> moves) override {
        moved_.clear();
        for (const scenes::BoxMove& next : moves) {
            fcl::CollisionObjectd* const object = objects_[next.index].get();
            if (next.is_new) manager_.unregisterObject(object);
            move(*object, next.box);
            if (next.is_new) manager_.registerObject(object);
            moved_.push_back(object);
        }
        if (!moved_.empty() && update == Update::all) manager_.update();
        if (!moved_.empty() && update == Update::moved) manager_.update(moved_);
        pairs_.clear();
        manager_.collide(&pairs_, &note_pair);
    }

    std::span<const ProxyPair> pairs() const override { return pairs_; }

  private:
    static void move(fcl::CollisionObjectd& object, const Aabb& box) {
        object.setTranslation((box.min + box.max) / 2);
        object.computeAABB();
    }

    // FCL calls this for every pair of which the boxes overlap. False: go on.
    static bool note_pair(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
        const auto index = [](const fcl::CollisionObjectd* object) {
            return static_cast<ProxyIndex>(reinterpret_cast<std::uintptr_t>(object->getUserData()));
        };
        const ProxyIndex i = index(a), k = index(b);
        static_cast<std::vector<ProxyPair>*>(data)->push_back(i < k ? ProxyPair{i, k} : ProxyPair{k, i});
        return false;
    }

    std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
    Manager manager_;  // after the objects, to which it refers
    std::vector<fcl::CollisionObjectd*> moved_;
    std::vector<ProxyPair> pairs_;
};

}  // namespace

std::unique_ptr<BroadEngine> set_up_broad_fcl_tree(const scenes::MovingBoxes& boxes) {
    return std::make_unique<BroadFcl<fcl::DynamicAABBTreeCollisionManagerd, Update::all>>(boxes);
}

std::unique_ptr<BroadEngine> set_up_broad_fcl_tree_moved(const scenes::MovingBoxes& boxes) {
    return std::make_unique<BroadFcl<fcl::DynamicAABBTreeCollisionManagerd, Update::moved>>(boxes);
}

std::unique_ptr<BroadEngine> set_up_broad_fcl_array(const scenes::MovingBoxes& boxes) {
    return std::make_unique<BroadFcl<fcl::DynamicAABBTreeCollisionManager_Arrayd, Update::all>>(boxes);
}

std::unique_ptr<BroadEngine> set_up_broad_fcl_sweep(const scenes::MovingBoxes& boxes) {
    return std::make_unique<BroadFcl<fcl::SaPCollisionManagerd, Update::all>>(boxes);
}

}  // namespace ecods::bench
