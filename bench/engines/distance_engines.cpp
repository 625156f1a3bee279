#include "engines/distance_engine.hpp"

namespace ecods::bench {

std::vector<DistanceMaker> distance_engines() {
    std::vector<DistanceMaker> makers = {
        {.name = own_distance,
         .use = "distance(), one QueryMemory; rounded once",
         .is_ecods = true,
         .set_up = set_up_distance_ecods},
        {.name = "ECoDS, witness",
         .use = "distance() with one PairWitness for all of a path; rounded once",
         .is_ecods = true,
         .is_for_paths = true,
         .set_up = set_up_distance_ecods_witness},
        {.name = "ECoDS bounds",
         .use = "distance_bounds(), relative 1e-6; an interval that contains the distance",
         .is_ecods = true,
         .answer = DistanceAnswer::bounds,
         .set_up = set_up_distance_ecods_bounds},
        {.name = "ECoDS closest",
         .use = "closest(); distance and points rounded once, features by the rule",
         .is_ecods = true,
         .set_up = set_up_distance_ecods_closest},
        {.name = distance_yardstick,
         .use = "BVHModel<OBBRSS>, distance() without points; double",
         .set_up = set_up_distance_fcl_obbrss},
        {.name = "FCL RSS", .use = "BVHModel<RSS>, the rest the same; double", .set_up = set_up_distance_fcl_rss},
    };
    constexpr struct {
        double factor;
        const char* name;
    } tolerances[] = {
        {0.5, "ECoDS within 0.5"}, {0.99, "ECoDS within 0.99"}, {1.01, "ECoDS within 1.01"}, {2, "ECoDS within 2"}};
    for (const auto& [factor, name] : tolerances) {
        makers.push_back({.name = name,
                          .use = "within() of the distance times that; decided for the real number",
                          .is_ecods = true,
                          .answer = DistanceAnswer::within,
                          .factor = factor,
                          .set_up = set_up_distance_ecods_within});
    }
    return makers;
}

}  // namespace ecods::bench
