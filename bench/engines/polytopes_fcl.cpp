// FCL's manager as its documentation advises for many moving objects, with distances of Convex shapes.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>

#include "engines/fcl_bodies.hpp"
#include "engines/polytopes_engine.hpp"

namespace ecods::bench {

namespace {

class PolytopesFcl final : public PolytopesEngine {
  public:
    explicit PolytopesFcl(const Polytopes::Workload& workload) : limit_(workload.limit) {
        for (std::size_t i = 0; i < workload.meshes.size(); ++i)
            objects_.add(to_fcl_convex(*workload.meshes[i]), to_fcl(workload.poses[i]));
        manager_.registerObjects(objects_.all());
        manager_.setup();
    }

    void run_frame(std::span<const Pose> poses) override {
        for (std::size_t i = 0; i < poses.size(); ++i) move(objects_[i], poses[i]);
        manager_.update(objects_.all());
        found_.clear();
        asked_count_ = 0;
        manager_.distance(this, &PolytopesFcl::ask_pair);
    }

    std::vector<NearPair> pairs() const override { return found_; }
    std::size_t candidate_count() const override { return asked_count_; }

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

    FclObjects objects_;
    fcl::DynamicAABBTreeCollisionManagerd manager_;  // after the objects, to which it refers
    fcl::DistanceRequestd request_;
    std::vector<NearPair> found_;
    std::size_t asked_count_ = 0;
    double limit_;
};

}  // namespace

std::vector<PolytopesMaker> fcl_polytopes() {
    return {{.name = polytopes_yardstick,
             .use = "DynamicAABBTree manager: update() of all, distance() with a callback that asks distance() of two "
                    "Convex, GST_LIBCCD, and sets the manager's bound to the limit; double",
             .set_up = makes<PolytopesFcl>()}};
}

}  // namespace ecods::bench
