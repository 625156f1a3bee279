#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "fuzz/campaign.hpp"
#include "fuzz/pairs/run.hpp"
#include "fuzz/progress.hpp"

namespace ecods::fuzz {
namespace {

nlohmann::json to_json(const PairCounts& counts) {
    nlohmann::json families;
    for (const auto& [family, relations] : counts.relations) {
        families[family] = {{"pairs", relations[0] + relations[1] + relations[2]},
                            {"disjoint", relations[0]},
                            {"touching", relations[1]},
                            {"crossing", relations[2]}};
    }
    const exact::StageCounts& s = counts.stages;
    return {{"pairs", counts.pairs},
            {"families", families},
            {"checks", counts.checks},
            {"stages",
             {{"triangle tests", s.triangle_tests},
              {"filter", s.filter_passes},
              {"filter, bound of the pair", s.semi_static_passes},
              {"plain double is exact", s.local_passes},
              {"integers, one limb", s.one_limb},
              {"integers, two limbs", s.two_limbs},
              {"integers, more limbs", s.many_limbs}}}};
}

}  // namespace

int fuzz_pairs(const CampaignOptions& options) {
    PairCounts counts;
    std::optional<Disagreement> failure;
    Campaign campaign(options);
    {
        Progress progress;
        while (!failure && campaign.goes_on()) {
            try {
                run_pairs(campaign.next_seed(), options.canary, counts);
            } catch (const Disagreement& found) {
                failure = found;
            }
            progress.show(campaign.runs(), counts.pairs, "pairs");
        }
    }
    nlohmann::json summary = to_json(counts);
    summary["profile"] = "pairs";
    summary["seed"] = options.seed;
    summary["runs"] = campaign.runs();
    summary["seconds"] = campaign.seconds();
    summary["disagreements"] = failure ? 1 : 0;
    summary["failure"] = nullptr;
    if (failure) {
        summary["failure"] = {{"seed", failure->seed},   {"pair", failure->pair}, {"family", failure->family},
                              {"path", failure->path},   {"got", failure->got},   {"expected", failure->expected},
                              {"numbers", failure->text}};
        fmt::print(stderr,
                   "ecods_fuzz: seed {}, pair {} ({}): {}: expected {}, got {}\n{}"
                   "to see it again: ecods_fuzz --profile pairs --seed {} --runs 1\n",
                   failure->seed, failure->pair, failure->family, failure->path, failure->expected, failure->got,
                   failure->text, failure->seed);
    }
    fmt::print("{}\n", summary.dump(2));
    return failure ? 1 : 0;
}

}  // namespace ecods::fuzz
