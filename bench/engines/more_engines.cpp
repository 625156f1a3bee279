// The main job leaves these engines out: what they need is not built for it.
#include "engines/broad_engine.hpp"
#include "engines/narrow_engine.hpp"

namespace ecods::bench {

std::vector<NarrowMaker> more_narrow_engines() {
    return {{"Bullet GImpact", "btGImpactMeshShape, margin 0, its algorithm from the dispatcher; float", false, false,
             true, set_up_narrow_bullet},
            {"CGAL Rigid",
             "Rigid_triangle_mesh_collision_detection over Epick, get_all_intersections(); predicates exact on "
             "rounded vertices",
             false, false, true, set_up_narrow_cgal}};
}

std::vector<BroadMaker> more_broad_engines() {
    return {{"FCL tree, moved only", "update() of the moved objects, the rest as the first", false, 10000,
             set_up_broad_fcl_tree_moved},
            {"FCL DynamicAABBTree_Array", "as the first", false, 1000, set_up_broad_fcl_array},
            {broad_fcl_sweep,
             "SaPCollisionManager, as the first. NOT TO BE RELIED ON: it loses pairs and reports false ones", false,
             10000, set_up_broad_fcl_sweep, std::chrono::seconds(30)},
            {"Bullet AxisSweep3", "btAxisSweep3, the same as Dbvt; 16 bits, then float", false, 1000,
             set_up_broad_bullet_sweep},
            {"ODE SAP space", "dSweepAndPruneSpace: dGeomSetPosition(), dSpaceCollide(); double", false, 10000,
             set_up_broad_ode},
            {"Embree rtcCollide",
             "user geometry, dynamic scene of low build quality, rebuilt each frame, one thread; float", false,
             std::numeric_limits<std::size_t>::max(), set_up_broad_embree},
            {"CGAL box_self_intersection_d", "closed boxes, from scratch each frame; double", false, 1000,
             set_up_broad_cgal}};
}

}  // namespace ecods::bench
