#include "fuzz/run.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "fuzz/base/failure.hpp"
#include "fuzz/motion/generate.hpp"
#include "fuzz/motion/profile.hpp"
#include "fuzz/pairs/campaigns.hpp"

namespace ecods::fuzz {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunFailure, profile, seed, where, check, expected, got, text, trace, picture)

namespace {

RunReport run_motion(const Profile& profile, std::uint32_t seed, const PlayOptions& options) {
    RunReport report;
    try {
        play(generate(profile, seed, report.counters), options_of_run(options, profile.name, seed), report.counters);
    } catch (const Failure& failure) {
        report.failure = {.profile = std::string(profile.name),
                          .seed = seed,
                          .where = fmt::format("update {}", failure.update),
                          .check = failure.check,
                          .expected = failure.expected,
                          .got = failure.got};
    } catch (const CheckFailed& failure) {
        report.failure = {.profile = std::string(profile.name),
                          .seed = seed,
                          .where = "its meshes",
                          .check = failure.check,
                          .expected = failure.expected,
                          .got = failure.got};
    }
    return report;
}

Counters counters_of(const CaseCounts& counts, const std::string& noun) {
    Counters counters;
    counters[noun] = counts.cases;
    for (const auto& [family, kinds] : counts.kinds) {
        for (const auto& [kind, count] : kinds) {
            counters[noun + " of families: " + family] += count;
            counters[noun + ": " + kind] += count;
        }
    }
    for (const auto& [check, count] : counts.checks) counters["checked: " + noun + ", " + check] = count;
    for (const auto& [stage, count] : counts.stages) counters["stages: " + stage] = count;
    return counters;
}

RunReport run_cases(const CaseCampaign& campaign, std::uint32_t seed, Canary canary) {
    RunReport report;
    CaseCounts counts;
    try {
        campaign.run(seed,
                     canary == Canary::answer   ? Lie::answer
                     : canary == Canary::recipe ? Lie::recipe
                                                : Lie::none,
                     counts);
    } catch (const Disagreement& found) {
        report.failure = {.profile = campaign.profile,
                          .seed = found.seed,
                          .where = fmt::format("pair {} ({})", found.index, found.family),
                          .check = found.path,
                          .expected = found.expected,
                          .got = found.got,
                          .text = found.text};
    }
    report.counters = counters_of(counts, campaign.noun);
    return report;
}

}  // namespace

std::vector<std::string> profiles_of(const std::string& name) {
    std::vector<std::string> names;
    const bool is_motion = name == "motion" || name == "all";
    for (const Profile& profile : profiles()) {
        if (is_motion || profile.name == name) names.emplace_back(profile.name);
    }
    for (const CaseCampaign& campaign : case_campaigns()) {
        if (name == "all" || name == campaign.profile) names.emplace_back(campaign.profile);
    }
    return names;
}

PlayOptions options_of_run(PlayOptions options, std::string_view profile, std::uint32_t seed) {
    options.certificates.folder /= fmt::format("{}-{}.certificates", profile, seed);
    return options;
}

RunReport run(const std::string& profile, std::uint32_t seed, const PlayOptions& options) {
    for (const CaseCampaign& campaign : case_campaigns()) {
        if (profile == campaign.profile) return run_cases(campaign, seed, options.canary);
    }
    return run_motion(*find_profile(profile), seed, options);
}

process::Contained contained(std::function<std::string()> work, unsigned seconds_max) {
    const std::chrono::seconds seconds(seconds_max);
    return {[work = std::move(work)] { return process::Contained::Run(work); },
            process::Limits{.clock = 20 * seconds, .processor = seconds, .is_pinned = false}};
}

std::string check_of(const process::Outcome& outcome) {
    return outcome.end == process::End::hung ? "hang" : "crash";
}

std::string text_of(const RunReport& report) {
    nlohmann::json json = {{"counters", report.counters}, {"failure", nullptr}};
    if (report.failure) json["failure"] = *report.failure;
    return json.dump();
}

RunReport report_of(const std::string& text) {
    const auto json = nlohmann::json::parse(text);
    RunReport report{json.at("counters").get<Counters>()};
    if (!json.at("failure").is_null()) report.failure = json.at("failure").get<RunFailure>();
    return report;
}

}  // namespace ecods::fuzz
