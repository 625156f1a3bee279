// FCL's continuousCollide() of two meshes. Its solver by polynomials is not asked: it adds the motion to the models'
// vertices, in their own axes, and leaves them there.
#include <cmath>
#include <limits>

#include "engines/cast_engine.hpp"
#include "engines/fcl_advancement.hpp"
#include "engines/fcl_bodies.hpp"

namespace ecods::bench {

namespace {

template <class Volume>
class CastFcl final : public Casts::Engine {
  public:
    CastFcl(const scenes::CastWorkload& workload, const fcl::ContinuousCollisionRequestd& request)
        : request_(request), models_(to_fcl_models<Volume>(workload.meshes)) {
        request_.ccd_motion_type = workload.is_translation ? fcl::CCDM_TRANS : fcl::CCDM_LINEAR;
    }

    double ask(const scenes::CastQuery& query, std::size_t /*index*/) override {
        fcl::ContinuousCollisionResultd result;
        fcl::continuousCollide(models_[query.a.mesh_index].get(), to_fcl(query.a.pose), to_fcl(query.a_end),
                               models_[query.b.mesh_index].get(), to_fcl(query.b.pose), to_fcl(query.b.pose), request_,
                               result);
        return result.is_collide ? result.time_of_contact : std::numeric_limits<double>::quiet_NaN();
    }

  private:
    fcl::ContinuousCollisionRequestd request_;
    FclModels<Volume> models_;
};

}  // namespace

std::vector<CastMaker> fcl_casts() {
    return {{.name = cast_yardstick,
             .use = "continuousCollide() by conservative advancement, BVHModel<OBBRSS>, its tolerance for meshes is "
                    "fixed at 1e-5; motions CCDM_TRANS, and CCDM_LINEAR between poses; double",
             .traits = {.triangle_max = 20'000},
             .set_up = makes<CastFcl<fcl::OBBRSSd>>(advancement())},
            {.name = "FCL advancement RSS",
             .use = "the same, BVHModel<RSS>; double",
             .traits = {.triangle_max = 1000},
             .set_up = makes<CastFcl<fcl::RSSd>>(advancement())},
            {.name = "FCL default",
             .use = "continuousCollide() as by default: collide() at 10 times, OBBRSS; double",
             .set_up = makes<CastFcl<fcl::OBBRSSd>>(fcl::ContinuousCollisionRequestd())},
            {.name = "FCL 1000 samples",
             .use = "the same at 1000 times; double",
             .set_up = makes<CastFcl<fcl::OBBRSSd>>(fcl::ContinuousCollisionRequestd(1000, 1e-3))}};
}

}  // namespace ecods::bench
