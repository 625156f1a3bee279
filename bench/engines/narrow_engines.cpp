#include "engines/narrow_engine.hpp"

namespace ecods::bench {

std::vector<NarrowMaker> main_narrow_engines() {
    return {{"ECoDS", "MeshShape, intersects(), one QueryMemory; exact", true, true, false, set_up_narrow_ecods},
            {narrow_yardstick, "BVHModel<OBBRSS>, collide() with one contact and no details; double", false, true,
             false, set_up_narrow_fcl_obbrss},
            {"FCL OBB", "BVHModel<OBB>, the rest the same; double", false, false, false, set_up_narrow_fcl_obb},
            {"ODE trimesh",
             "dGeomTriMeshDataBuildSingle(), dCollide() for one contact, CONTACTS_UNIMPORTANT; poses double, tree and "
             "triangles float",
             false, false, false, set_up_narrow_ode}};
}

std::vector<NarrowMaker> narrow_engines() {
    std::vector<NarrowMaker> makers = main_narrow_engines();
    for (NarrowMaker& more : more_narrow_engines()) makers.push_back(std::move(more));
    return makers;
}

}  // namespace ecods::bench
