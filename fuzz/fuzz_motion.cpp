#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "fuzz/campaign.hpp"
#include "fuzz/progress.hpp"
#include "fuzz/run.hpp"

namespace ecods::fuzz {

int fuzz_motion(const CampaignOptions& options) {
    const CheckOptions checks{.canary = options.canary};
    Counters counters;
    std::optional<Failure> failure;
    Campaign campaign(options);
    {
        Progress progress;
        while (!failure && campaign.goes_on()) {
            try {
                run(campaign.next_seed(), checks, counters);
            } catch (const Failure& found) {
                failure = found;
            }
            progress.show(campaign.runs(), counters["frames"], "frames");
        }
    }
    nlohmann::json summary = {
        {"seed", options.seed}, {"runs", campaign.runs()}, {"counts", counters}, {"failure", nullptr}};
    if (failure) {
        summary["failure"] = {
            {"seed", failure->seed}, {"frame", failure->frame}, {"check", failure->check}, {"detail", failure->detail}};
        fmt::print(stderr, "ecods_fuzz: seed {}, frame {}: {}: {}\nto see it again: ecods_fuzz --seed {} --runs 1\n",
                   failure->seed, failure->frame, failure->check, failure->detail, failure->seed);
    }
    fmt::print("{}\n", summary.dump(2));
    return failure ? 1 : 0;
}

}  // namespace ecods::fuzz
