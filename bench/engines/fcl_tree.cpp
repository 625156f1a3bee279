// FCL as its documentation advises for many moving objects.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>

#include <algorithm>

#include "engines/engine.hpp"
#include "engines/fcl_bodies.hpp"

namespace ecods::bench {

namespace {

class FclTree final : public Engine {
  public:
    explicit FclTree(const scenes::Scene& scene) : objects_(to_fcl(scene)) {
        std::vector<fcl::CollisionObjectd*> all;
        for (const auto& object : objects_) all.push_back(object.get());
        manager_.registerObjects(all);
        manager_.setup();
    }

    void run_frame(std::span<const scenes::Move> moves) override {
        moved_.clear();
        for (const scenes::Move& next : moves) {
            move(*objects_[next.body_index], next.pose);
            moved_.push_back(objects_[next.body_index].get());
        }
        if (!moved_.empty()) manager_.update(moved_);
        hits_.clear();
        candidate_count_ = 0;
        manager_.collide(this, &FclTree::test_pair);
    }

    std::vector<IndexPair> hits() const override {
        std::vector<IndexPair> hits = hits_;
        std::sort(hits.begin(), hits.end());
        return hits;
    }
    std::size_t candidate_count() const override { return candidate_count_; }

  private:
    // FCL calls this for every pair of which the boxes overlap. False: go on.
    static bool test_pair(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
        FclTree& self = *static_cast<FclTree*>(data);
        ++self.candidate_count_;
        if (collide(*a, *b)) self.hits_.push_back(ordered(index_of(*a), index_of(*b)));
        return false;
    }

    std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
    fcl::DynamicAABBTreeCollisionManagerd manager_;  // after the objects, to which it refers
    std::vector<fcl::CollisionObjectd*> moved_;
    std::vector<IndexPair> hits_;
    std::size_t candidate_count_ = 0;
};

}  // namespace

std::unique_ptr<Engine> set_up_fcl_tree(const scenes::Scene& scene) {
    return std::make_unique<FclTree>(scene);
}

}  // namespace ecods::bench
