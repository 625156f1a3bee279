// FCL's dynamic trees of boxes, and its sweep and prune. Objects are boxes that do not turn, so that FCL's bounds are
// the very boxes given.
#include <fcl/broadphase/broadphase_SaP.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/geometry/shape/box.h>

#include "engines/broad_engine.hpp"
#include "engines/fcl_bodies.hpp"

namespace ecods::bench {

namespace {

// How the manager learns of moves: all of it is refitted, or the boxes that moved are named and inserted again. The
// first is faster while all move a little, the second when few do, or when some jump.
enum class Update { all, moved };

template <class Manager, Update update>
class BroadFcl final : public BroadEngine {
  public:
    explicit BroadFcl(const scenes::MovingBoxes& boxes) {
        for (const Aabb& box : boxes.boxes) {
            objects_.add(std::make_shared<fcl::Boxd>(fcl::Vector3d(box.max - box.min)), fcl::Transform3d::Identity());
            move(*objects_.all().back(), box);
        }
        manager_.registerObjects(objects_.all());
        manager_.setup();
    }

    void run_frame(std::span<const scenes::BoxMove> moves) override {
        moved_.clear();
        for (const scenes::BoxMove& next : moves) {
            fcl::CollisionObjectd* const object = &objects_[next.index];
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

    std::vector<ProxyPair> pairs() const override { return pairs_; }

  private:
    static void move(fcl::CollisionObjectd& object, const Aabb& box) {
        object.setTranslation((box.min + box.max) / 2);
        object.computeAABB();
    }

    // FCL calls this for every pair of which the boxes overlap. False: go on.
    static bool note_pair(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
        const auto [low, high] = ordered(index_of(*a), index_of(*b));
        static_cast<std::vector<ProxyPair>*>(data)->push_back(
            {static_cast<ProxyIndex>(low), static_cast<ProxyIndex>(high)});
        return false;
    }

    FclObjects objects_;
    Manager manager_;  // after the objects, to which it refers
    std::vector<fcl::CollisionObjectd*> moved_;
    std::vector<ProxyPair> pairs_;
};

using Tree = fcl::DynamicAABBTreeCollisionManagerd;

}  // namespace

std::vector<BroadMaker> fcl_broad() {
    return {{.name = broad_yardstick,
             .use = "update() of all, collide() with a callback that notes each pair; double",
             .set_up = makes<BroadFcl<Tree, Update::all>>()}};
}

std::vector<BroadMaker> more_fcl_broad() {
    return {{.name = "FCL tree, moved only",
             .use = "update() of the moved objects, the rest as the first",
             .traits = {.count_max = 10000},
             .set_up = makes<BroadFcl<Tree, Update::moved>>()},
            {.name = "FCL DynamicAABBTree_Array",
             .use = "as the first",
             .traits = {.count_max = 1000},
             .set_up = makes<BroadFcl<fcl::DynamicAABBTreeCollisionManager_Arrayd, Update::all>>()},
            {.name = broad_fcl_sweep,
             .use = "SaPCollisionManager, as the first. NOT TO BE RELIED ON: it loses pairs and reports false ones",
             .traits = {.count_max = 10000, .limit = std::chrono::seconds(30)},
             .set_up = makes<BroadFcl<fcl::SaPCollisionManagerd, Update::all>>()}};
}

}  // namespace ecods::bench
