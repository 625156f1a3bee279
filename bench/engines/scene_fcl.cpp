// FCL as its documentation advises for many moving objects, and without a manager.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>

#include "engines/fcl_bodies.hpp"
#include "engines/scene_engine.hpp"

namespace ecods::bench {

namespace {

class FclTree final : public SceneEngine {
  public:
    explicit FclTree(const scenes::Scene& scene) : objects_(to_fcl(scene)) {
        manager_.registerObjects(objects_.all());
        manager_.setup();
    }

    void run_frame(std::span<const scenes::Move> moves) override {
        moved_.clear();
        for (const scenes::Move& next : moves) {
            move(objects_[next.body_index], next.pose);
            moved_.push_back(&objects_[next.body_index]);
        }
        if (!moved_.empty()) manager_.update(moved_);
        hits_.clear();
        candidate_count_ = 0;
        manager_.collide(this, &FclTree::test_pair);
    }

    std::vector<IndexPair> pairs() const override { return hits_; }
    std::size_t candidate_count() const override { return candidate_count_; }

  private:
    // FCL calls this for every pair of which the boxes overlap. False: go on.
    static bool test_pair(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
        FclTree& self = *static_cast<FclTree*>(data);
        ++self.candidate_count_;
        if (collide(*a, *b)) self.hits_.push_back(ordered(index_of(*a), index_of(*b)));
        return false;
    }

    FclObjects objects_;
    fcl::DynamicAABBTreeCollisionManagerd manager_;  // after the objects, to which it refers
    std::vector<fcl::CollisionObjectd*> moved_;
    std::vector<IndexPair> hits_;
    std::size_t candidate_count_ = 0;
};

// Every pair of bodies, every frame.
class FclAllPairs final : public SceneEngine {
  public:
    explicit FclAllPairs(const scenes::Scene& scene) : objects_(to_fcl(scene)) {}

    void run_frame(std::span<const scenes::Move> moves) override {
        for (const scenes::Move& next : moves) move(objects_[next.body_index], next.pose);
        hits_.clear();
        for (std::size_t i = 0; i < objects_.size(); ++i) {
            for (std::size_t k = i + 1; k < objects_.size(); ++k) {
                if (collide(objects_[i], objects_[k])) hits_.push_back({i, k});
            }
        }
    }

    std::vector<IndexPair> pairs() const override { return hits_; }
    std::size_t candidate_count() const override { return objects_.size() * (objects_.size() - 1) / 2; }

  private:
    FclObjects objects_;
    std::vector<IndexPair> hits_;
};

}  // namespace

std::vector<SceneMaker> fcl_scenes() {
    return {{.name = scene_yardstick, .set_up = makes<FclTree>()},
            {.name = scene_fcl_all_pairs, .set_up = makes<FclAllPairs>()}};
}

}  // namespace ecods::bench
