// The engines of a full build, in the order in which tables show them.
#include "engines/broad_engine.hpp"
#include "engines/cast_engine.hpp"
#include "engines/convex_engine.hpp"
#include "engines/distance_engine.hpp"
#include "engines/hit_engine.hpp"
#include "engines/narrow_engine.hpp"
#include "engines/polytopes_engine.hpp"
#include "engines/rounded_engine.hpp"
#include "engines/turn_engine.hpp"

namespace ecods::bench {

std::vector<NarrowMaker> narrow_engines() {
    return joined(main_narrow_engines(), bullet_narrow(), cgal_narrow());
}

std::vector<BroadMaker> broad_engines() {
    return joined(main_broad_engines(), more_fcl_broad(), more_bullet_broad(), ode_broad(), embree_broad(),
                  cgal_broad());
}

std::vector<DistanceMaker> distance_engines() {
    return joined(ecods_distance(), fcl_distance(), ecods_within(), cgal_distance());
}

std::vector<CastMaker> cast_engines() {
    return joined(ecods_casts(), fcl_casts(), bullet_casts());
}

std::vector<TurnMaker> turn_engines() {
    return joined(ecods_turns(), fcl_turns());
}

std::vector<HitMaker> hit_engines() {
    return joined(ecods_hits(), embree_hits(), bullet_hits(), cgal_hits());
}

std::vector<ConvexMaker> convex_engines(scenes::ConvexQuestion question) {
    return joined(ecods_convex(question), fcl_convex(question), ccd_convex(question), bullet_convex(question));
}

std::vector<PolytopesMaker> polytopes_engines() {
    return joined(ecods_polytopes(), fcl_polytopes());
}

std::vector<RoundMaker> round_engines() {
    return joined(ecods_round(), fcl_round(), bullet_round());
}

}  // namespace ecods::bench
