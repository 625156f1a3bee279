// FCL's continuousCollide() of a mesh that turns at a constant speed. Its two rigid motions are the same here: the
// pivot stays, and is the reference point of the one and on the axis of the other.
#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/screw_motion.h>

#include <limits>

#include "engines/fcl_advancement.hpp"
#include "engines/fcl_bodies.hpp"
#include "engines/turn_engine.hpp"

namespace ecods::bench {

namespace {

// The constructor from matrices: the one from transforms leaves the velocities of a reference point unset.
fcl::InterpMotion<double> about_pivot(const scenes::TurnQuery& query) {
    const Vec3 pivot = query.a.pose.R.transpose() * (query.turn.pivot_from - query.a.pose.t);
    return {query.a.pose.R, query.a.pose.t, query.a_end.R, query.a_end.t, pivot};
}

fcl::ScrewMotion<double> along_screw(const scenes::TurnQuery& query) {
    return {bench::to_fcl(query.a.pose), bench::to_fcl(query.a_end)};
}

template <class Motion>
class TurnFcl final : public Turns::Engine {
  public:
    TurnFcl(const scenes::TurnWorkload& workload, const fcl::ContinuousCollisionRequestd& request,
            Motion (*motion_of)(const scenes::TurnQuery&))
        : request_(request), motion_of_(motion_of), models_(to_fcl_models<fcl::OBBRSSd>(workload.meshes)) {}

    double ask(const scenes::TurnQuery& query, std::size_t /*index*/) override {
        const Motion turning = motion_of_(query);
        const fcl::InterpMotion<double> resting(bench::to_fcl(query.b.pose), bench::to_fcl(query.b.pose));
        fcl::ContinuousCollisionResultd result;
        fcl::continuousCollide(models_[query.a.mesh_index].get(), &turning, models_[query.b.mesh_index].get(), &resting,
                               request_, result);
        return result.is_collide ? result.time_of_contact : std::numeric_limits<double>::quiet_NaN();
    }

  private:
    fcl::ContinuousCollisionRequestd request_;
    Motion (*motion_of_)(const scenes::TurnQuery&);
    FclModels<fcl::OBBRSSd> models_;
};

}  // namespace

std::vector<TurnMaker> fcl_turns() {
    using Interp = fcl::InterpMotion<double>;
    using Screw = fcl::ScrewMotion<double>;
    const Turns::Traits slow{.answer = TurnAnswer::share, .triangle_max = 20'000};
    const Turns::Traits quick{.answer = TurnAnswer::share};
    return {{.name = turn_yardstick,
             .use = "continuousCollide() by conservative advancement, BVHModel<OBBRSS>, InterpMotion with the pivot as "
                    "its reference point; its tolerance for meshes is fixed at 1e-5; double",
             .traits = slow,
             .set_up = makes<TurnFcl<Interp>>(advancement(), &about_pivot)},
            {.name = "FCL advancement, screw",
             .use = "the same with ScrewMotion; double",
             .traits = slow,
             .set_up = makes<TurnFcl<Screw>>(advancement(), &along_screw)},
            {.name = "FCL 10 samples",
             .use = "continuousCollide() as by default: collide() at 10 times, InterpMotion; double",
             .traits = quick,
             .set_up = makes<TurnFcl<Interp>>(fcl::ContinuousCollisionRequestd(), &about_pivot)},
            {.name = "FCL 1000 samples",
             .use = "the same at 1000 times; double",
             .traits = quick,
             .set_up = makes<TurnFcl<Interp>>(fcl::ContinuousCollisionRequestd(1000, 1e-3), &about_pivot)}};
}

}  // namespace ecods::bench
