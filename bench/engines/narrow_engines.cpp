#include "engines/narrow_engine.hpp"

namespace ecods::bench {

std::vector<NarrowMaker> narrow_engines() {
    return {{"ECoDS", "MeshShape, intersects(), one QueryMemory; exact", true, true, false, set_up_narrow_ecods},
            {narrow_yardstick, "BVHModel<OBBRSS>, collide() with one contact and no details; double", false, true,
             false, set_up_narrow_fcl_obbrss},
            {"FCL OBB", "BVHModel<OBB>, the rest the same; double", false, false, false, set_up_narrow_fcl_obb},
            {"ODE trimesh",
             "dGeomTriMeshDataBuildSingle(), dCollide() for one contact, CONTACTS_UNIMPORTANT; poses double, tree and "
             "triangles float",
             false, false, false, set_up_narrow_ode},
            {"Bullet GImpact", "btGImpactMeshShape, margin 0, its algorithm from the dispatcher; float", false, false,
             true, set_up_narrow_bullet},
            {"CGAL Rigid",
             "Rigid_triangle_mesh_collision_detection over Epick, get_all_intersections(); predicates exact on "
             "rounded vertices",
             false, false, true, set_up_narrow_cgal}};
}

}  // namespace ecods::bench
