// FCL's distance() of two meshes: a tree of OBBRSS, which it recommends, or of RSS, which its distances use of it.
#include <fcl/narrowphase/distance.h>

#include "engines/distance_engine.hpp"
#include "engines/fcl_bodies.hpp"

namespace ecods::bench {

namespace {

template <class Volume>
class DistanceFcl final : public Distance::Engine {
  public:
    explicit DistanceFcl(const scenes::DistanceWorkload& workload) : models_(to_fcl_models<Volume>(workload.meshes)) {}

    double ask(const scenes::MeshQuery& query, std::size_t /*index*/) override {
        fcl::DistanceResultd result;
        fcl::distance(models_[query.a.mesh_index].get(), to_fcl(query.a.pose), models_[query.b.mesh_index].get(),
                      to_fcl(query.b.pose), fcl::DistanceRequestd(), result);
        return result.min_distance;
    }

  private:
    FclModels<Volume> models_;
};

}  // namespace

std::vector<DistanceMaker> fcl_distance() {
    return {{.name = distance_yardstick,
             .use = "BVHModel<OBBRSS>, distance() without points; double",
             .set_up = makes<DistanceFcl<fcl::OBBRSSd>>()},
            {.name = "FCL RSS",
             .use = "BVHModel<RSS>, the rest the same; double",
             .set_up = makes<DistanceFcl<fcl::RSSd>>()}};
}

}  // namespace ecods::bench
