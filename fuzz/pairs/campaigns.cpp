#include "fuzz/pairs/campaigns.hpp"

namespace ecods::fuzz {

std::span<const CaseCampaign> case_campaigns() {
    static constexpr CaseCampaign table[] = {
        {"pairs", "pairs of posed triangles, 1000 a run, each by every path of the exact layer", "triangle pairs",
         run_pairs},
        {"distances", "pairs of posed meshes, 1000 a run, every question about their distances", "distances",
         run_distances},
        {"hits", "segments and rays, 2000 a run, every question about what they hit of a mesh", "hits", run_hits},
        {"casts", "posed meshes on their way, 250 a run, every question about their contact", "casts", run_casts},
        {"turns",
         "posed meshes that turn, 26 a run, every question about their contact; half with a turn of the other, too; "
         "some "
         "by pieces of the time",
         "turns", run_turns},
        {"turn_samples", "posed meshes that turn, 1000 a run, at 64 times each and the doubles beside the first one",
         "turns", run_turn_samples},
        {"ways", "posed meshes along ways made of turns, 104 a run, and in equal shares of the time", "ways", run_ways},
        {"deforming", "meshes that deform beside bodies and each other, 120 a run", "deforming meshes", run_deforming},
        {"solids", "pairs of posed solids, 130 a run, every question about them", "solids", run_solids},
        {"polycubes", "sets of unit cells as posed solids, 1000 pairs a run", "solids", run_polycubes},
        {"placements", "pairs of polycubes in all positions: 19 runs of up to three cells, 105 of up to four", "solids",
         run_placements},
        {"convex", "pairs of posed convex solids, 180 a run, their distances, depths, features and hulls", "convex",
         run_convex},
        {"kinds", "worlds of all kinds of bodies, half spaces among them, 6 a run of 8 frames each", "worlds of kinds",
         run_kinds},
    };
    return table;
}

}  // namespace ecods::fuzz
