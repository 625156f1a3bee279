#include "engines/hit_engine.hpp"

namespace ecods::bench {

std::vector<HitMaker> hit_engines() {
    return {{.name = own_hits,
             .use = "first_hit(), all_hits(), one QueryMemory; exact, parameters rounded once",
             .is_ecods = true,
             .has_lists = true,
             .bodies = HitBodies::one,
             .set_up = set_up_hit_ecods},
            {.name = "ECoDS, witness",
             .use = "first_hit() with one PairWitness for all of a path; the same",
             .is_ecods = true,
             .is_for_paths = true,
             .bodies = HitBodies::one,
             .set_up = set_up_hit_ecods_witness},
            {.name = own_world_hits,
             .use = "World::first_hit(), all_hits(), one QueryMemory; exact, parameters rounded once",
             .is_ecods = true,
             .has_lists = true,
             .bodies = HitBodies::many,
             .set_up = set_up_hit_ecods_world},
            {.name = hit_yardstick,
             .use = "rtcIntersect1(), one mesh of all triangles, flags and build quality as by default; for lists a "
                    "filter that refuses each hit; float",
             .has_lists = true,
             .set_up = set_up_hit_embree},
            {.name = "Embree robust",
             .use = "the same with RTC_SCENE_FLAG_ROBUST; float",
             .has_lists = true,
             .set_up = set_up_hit_embree_robust},
            {.name = "Embree, 16 at once",
             .use = "rtcIntersect16() of consecutive segments: what several questions in one call give, which ECoDS "
                    "does not offer; float",
             .set_up = set_up_hit_embree_packets},
            {.name = "Embree instances",
             .use = "rtcIntersect1(), a scene for each mesh and an instance for each body; float",
             .bodies = HitBodies::many,
             .set_up = set_up_hit_embree_instances},
            {.name = "Bullet",
             .use = "btBvhTriangleMeshShape::performRaycast(), quantized tree; float",
             .has_lists = true,
             .bodies = HitBodies::one,
             .set_up = set_up_hit_bullet},
            {.name = "CGAL Epick",
             .use = "AABB_tree::first_intersection() of the ray, dropped behind the segment's end, and "
                    "all_intersected_primitives() of the segment; predicates exact on rounded vertices, points double",
             .has_lists = true,
             .bodies = HitBodies::one,
             .set_up = set_up_hit_cgal}};
}
}  // namespace ecods::bench
