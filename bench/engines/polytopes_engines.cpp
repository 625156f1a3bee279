#include "engines/polytopes_engine.hpp"

namespace ecods::bench {

std::vector<PolytopesMaker> polytopes_engines() {
    return {{own_polytopes, "set_poses() and solid_distances(); rounded once", true, set_up_polytopes_ecods},
            {"ECoDS world of convex, update", "the same with update() in between, which finds collisions, too", true,
             set_up_polytopes_ecods_update},
            {polytopes_yardstick,
             "DynamicAABBTree manager: update() of all, distance() with a callback that asks distance() of two Convex, "
             "GST_LIBCCD, and sets the manager's bound to the limit; double",
             false, set_up_polytopes_fcl}};
}

}  // namespace ecods::bench
