#include "engines/cast_engine.hpp"

namespace ecods::bench {

std::vector<CastMaker> cast_engines() {
    return {{.name = "ECoDS",
             .use = "cast() of a translation or between poses, one QueryMemory; exact, rounded once",
             .is_ecods = true,
             .set_up = set_up_cast_ecods},
            {.name = own_end_distance,
             .use = "distance() at the end of the motion: what it costs to ask how far that is",
             .is_ecods = true,
             .answer = CastAnswer::distance,
             .set_up = set_up_cast_ecods_distance},
            {.name = cast_yardstick,
             .use = "continuousCollide() by conservative advancement, BVHModel<OBBRSS>, its tolerance for meshes is "
                    "fixed at 1e-5; motions CCDM_TRANS, and CCDM_LINEAR between poses; double",
             .triangle_max = 20'000,
             .set_up = set_up_cast_fcl_obbrss},
            {.name = "FCL advancement RSS",
             .use = "the same, BVHModel<RSS>; double",
             .triangle_max = 1000,
             .set_up = set_up_cast_fcl_rss},
            {.name = "FCL default",
             .use = "continuousCollide() as by default: collide() at 10 times, OBBRSS; double",
             .set_up = set_up_cast_fcl_default},
            {.name = "FCL 1000 samples", .use = "the same at 1000 times; double", .set_up = set_up_cast_fcl_samples},
            {.name = "Bullet convex sweep",
             .use = "btCollisionWorld::objectQuerySingle() of btConvexHullShape, margins 0, which is by "
                    "btContinuousConvexCollision against a hull, or against each triangle near of a "
                    "btBvhTriangleMeshShape; float",
             .is_for_hulls = true,
             .set_up = set_up_cast_bullet}};
}

}  // namespace ecods::bench
