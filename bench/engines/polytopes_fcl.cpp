// FCL's manager as its documentation advises for many moving objects, with distances of Convex shapes.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>

#include "engines/fcl_bodies.hpp"
#include "engines/fcl_convex.hpp"
#include "engines/polytopes_engine.hpp"

namespace ecods::bench {

namespace {

class PolytopesFcl final : public PolytopesEngine {
  public:
    PolytopesFcl(std::span<const std::shared_ptr<const Mesh>> meshes, std::span<const Pose> poses) {
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            objects_.push_back(std::make_unique<fcl::CollisionObjectd>(to_fcl_convex(*meshes[i]), to_fcl(poses[i])));
            objects_.back()->setUserData(reinterpret_cast<void*>(static_cast<std::uintptr_t>(i)));
            objects_.back()->computeAABB();
            all_.push_back(objects_.back().get());
        }
        manager_.registerObjects(all_);
        manager_.setup();
    }

    void run_frame(std::span<const Pose> poses, double limit) override {
        for (std::size_t i = 0; i < poses.size(); ++i) move(*objects_[i], poses[i]);
        manager_.update(all_);
        found_.clear();
        asked_count_ = 0;
        limit_ = limit;
        manager_.distance(this, &PolytopesFcl::ask_pair);
    }

    std::vector<NearPair> pairs() const override {
        std::vector<NearPair> pairs = found_;
        std::ranges::sort(pairs, {}, &NearPair::bodies);
        return pairs;
    }
    std::size_t asked_count() const override { return asked_count_; }

  private:
    // FCL calls this for pairs whose boxes are nearer than `bound`. False: go on.
    static bool ask_pair(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data, double& bound) {
        PolytopesFcl& self = *static_cast<PolytopesFcl*>(data);
        bound = self.limit_;
        ++self.asked_count_;
        fcl::DistanceResultd result;
        const double d = fcl::distance(a, b, self.request_, result);
        if (d <= self.limit_) self.found_.push_back({ordered(index_of(*a), index_of(*b)), std::max(d, 0.0)});
        return false;
    }

    std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
    fcl::DynamicAABBTreeCollisionManagerd manager_;  // after the objects, to which it refers
    std::vector<fcl::CollisionObjectd*> all_;
    fcl::DistanceRequestd request_;
    std::vector<NearPair> found_;
    std::size_t asked_count_ = 0;
    double limit_ = 0;
};

}  // namespace

std::unique_ptr<PolytopesEngine> set_up_polytopes_fcl(std::span<const std::shared_ptr<const Mesh>> meshes,
                                                      std::span<const Pose> poses) {
    return std::make_unique<PolytopesFcl>(meshes, poses);
}

}  // namespace ecods::bench
