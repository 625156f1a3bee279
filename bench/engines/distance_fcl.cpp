// FCL's distance() of two meshes: a tree of OBBRSS, which it recommends, or of RSS, which its distances use of it.
#include <fcl/narrowphase/distance.h>

#include "engines/distance_engine.hpp"
#include "engines/fcl_bodies.hpp"

namespace ecods::bench {

namespace {

template <class Volume>
class DistanceFcl final : public DistanceEngine {
  public:
    explicit DistanceFcl(std::span<const scenes::NamedMesh> meshes) {
        for (const scenes::NamedMesh& named : meshes) models_.push_back(to_fcl_model<Volume>(named));
    }

    double ask(const scenes::MeshQuery& query, double /*d*/) override {
        fcl::DistanceResultd result;
        fcl::distance(models_[query.a.mesh_index].get(), to_fcl(query.a.pose), models_[query.b.mesh_index].get(),
                      to_fcl(query.b.pose), fcl::DistanceRequestd(), result);
        return result.min_distance;
    }

  private:
    std::vector<std::shared_ptr<fcl::BVHModel<Volume>>> models_;
};

}  // namespace

std::unique_ptr<DistanceEngine> set_up_distance_fcl_obbrss(std::span<const scenes::NamedMesh> meshes,
                                                           double /*factor*/) {
    return std::make_unique<DistanceFcl<fcl::OBBRSSd>>(meshes);
}

std::unique_ptr<DistanceEngine> set_up_distance_fcl_rss(std::span<const scenes::NamedMesh> meshes, double /*factor*/) {
    return std::make_unique<DistanceFcl<fcl::RSSd>>(meshes);
}

}  // namespace ecods::bench
