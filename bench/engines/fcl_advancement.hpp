// FCL's conservative advancement of two meshes, whose tolerance is fixed at 1e-5.
#pragma once

#include <fcl/narrowphase/continuous_collision.h>

namespace ecods::bench {

inline fcl::ContinuousCollisionRequestd advancement() {
    fcl::ContinuousCollisionRequestd request;
    request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    return request;
}

}  // namespace ecods::bench
