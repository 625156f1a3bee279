// Runs from consecutive seeds, each in a process of its own, until enough is done or a check fails.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fuzz/run.hpp"

namespace ecods::fuzz {

struct CampaignOptions {
    std::string profile = "motion";
    std::uint32_t seed = 1;
    std::uint32_t runs = 100;
    double seconds = 0;         // if positive, in place of `runs`
    std::uint32_t jobs = 1;     // processes at once
    unsigned seconds_max = 60;  // of processor time, that a run may take
    std::uint32_t failures_max = 1;
    PlayOptions play = {};
};

struct CampaignReport {
    std::uint32_t runs = 0;
    double seconds = 0;
    std::map<std::string, std::uint32_t> runs_of = {};  // by profile
    Counters counters = {};                             // of runs that did not fail
    std::vector<RunFailure> failures = {};              // ascending by seed
};

// Run i has seed + i, and where a name stands for several profiles, the seed decides which: so that runs are the same
// for any number of jobs, and each can be had alone.
CampaignReport run_campaign(const CampaignOptions& options);

std::string to_json(const CampaignOptions& options, const CampaignReport& report);

}  // namespace ecods::fuzz
