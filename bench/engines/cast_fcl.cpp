// FCL's continuousCollide() of two meshes. Its solver by polynomials is not asked: it adds the motion to the models'
// vertices, in their own axes, and leaves them there.
#include <fcl/narrowphase/continuous_collision.h>

#include <cmath>
#include <limits>

#include "engines/cast_engine.hpp"
#include "engines/fcl_bodies.hpp"

namespace ecods::bench {

namespace {

template <class Volume>
class CastFcl final : public CastEngine {
  public:
    CastFcl(const scenes::CastWorkload& workload, const fcl::ContinuousCollisionRequestd& request) : request_(request) {
        for (const scenes::NamedMesh& named : workload.meshes) models_.push_back(to_fcl_model<Volume>(named));
        request_.ccd_motion_type = workload.is_translation ? fcl::CCDM_TRANS : fcl::CCDM_LINEAR;
    }

    double ask(const scenes::CastQuery& query) override {
        fcl::ContinuousCollisionResultd result;
        fcl::continuousCollide(models_[query.a.mesh_index].get(), to_fcl(query.a.pose), to_fcl(query.a_end),
                               models_[query.b.mesh_index].get(), to_fcl(query.b.pose), to_fcl(query.b.pose), request_,
                               result);
        return result.is_collide ? result.time_of_contact : std::numeric_limits<double>::quiet_NaN();
    }

  private:
    fcl::ContinuousCollisionRequestd request_;
    std::vector<std::shared_ptr<fcl::BVHModel<Volume>>> models_;
};

fcl::ContinuousCollisionRequestd advancement() {
    fcl::ContinuousCollisionRequestd request;
    request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    return request;
}

}  // namespace

std::unique_ptr<CastEngine> set_up_cast_fcl_obbrss(const scenes::CastWorkload& workload) {
    return std::make_unique<CastFcl<fcl::OBBRSSd>>(workload, advancement());
}

std::unique_ptr<CastEngine> set_up_cast_fcl_rss(const scenes::CastWorkload& workload) {
    return std::make_unique<CastFcl<fcl::RSSd>>(workload, advancement());
}

std::unique_ptr<CastEngine> set_up_cast_fcl_default(const scenes::CastWorkload& workload) {
    return std::make_unique<CastFcl<fcl::OBBRSSd>>(workload, fcl::ContinuousCollisionRequestd());
}

std::unique_ptr<CastEngine> set_up_cast_fcl_samples(const scenes::CastWorkload& workload) {
    return std::make_unique<CastFcl<fcl::OBBRSSd>>(workload, fcl::ContinuousCollisionRequestd(1000, 1e-3));
}

}  // namespace ecods::bench
