#include "engines/convex_engine.hpp"

namespace ecods::bench {

using scenes::ConvexQuestion;

std::vector<ConvexMaker> convex_engines(ConvexQuestion question) {
    const bool is_depth = question == ConvexQuestion::depth;
    std::vector<ConvexMaker> makers;
    const auto add = [&](const char* name, const char* distance_use, const char* depth_use, auto set_up,
                         bool is_ecods = false) {
        const char* use = is_depth ? depth_use : distance_use;
        if (use != nullptr) makers.push_back({name, use, is_ecods, set_up});
    };
    add("ECoDS convex", "solid_distance(), one QueryMemory; rounded once",
        "depth(), one QueryMemory; rounded once, direction and features by the rule", set_up_convex_ecods, true);
    add("ECoDS convex, witness", "the same, with a PairWitness for each pair, left by the pass before",
        "the same, with a PairWitness for each pair, left by the pass before", set_up_convex_ecods_witness, true);
    add("ECoDS convex closest", "solid_closest(); distance and points rounded once, features by the rule", nullptr,
        set_up_convex_ecods_closest, true);
    add(convex_distance_yardstick, "Convex, distance() with GST_LIBCCD, without points; double",
        "Convex, collide() with contacts, GST_LIBCCD, its default (MPR); double", set_up_convex_fcl_libccd);
    add("FCL indep", "Convex, distance() with GST_INDEP; double", "Convex, collide() with contacts, GST_INDEP; double",
        set_up_convex_fcl_indep);
    add(convex_depth_yardstick, nullptr, "ccdGJKPenetration, all vertices asked by the support functions; double",
        set_up_convex_ccd_epa);
    add("libccd MPR", nullptr, "ccdMPRPenetration, the same support functions; double", set_up_convex_ccd_mpr);
    add(convex_second_yardstick,
        "btConvexHullShape without margin, btGjkPairDetector with btVoronoiSimplexSolver; single precision",
        "btConvexHullShape without margin, btGjkEpaSolver2::Penetration; single precision", set_up_convex_bullet);
    return makers;
}

}  // namespace ecods::bench
