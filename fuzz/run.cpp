#include "fuzz/run.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "fuzz/base/failure.hpp"
#include "fuzz/motion/generate.hpp"
#include "fuzz/motion/profile.hpp"
#include "fuzz/pairs/contacts.hpp"
#include "fuzz/pairs/convex.hpp"
#include "fuzz/pairs/distances.hpp"
#include "fuzz/pairs/run.hpp"
#include "fuzz/pairs/solids.hpp"

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

Counters counters_of(const PairCounts& counts) {
    Counters counters;
    counters["triangle pairs"] = counts.pairs;
    for (const auto& [family, relations] : counts.relations) {
        counters["families: " + family] = relations[0] + relations[1] + relations[2];
        counters["triangle pairs: disjoint"] += relations[0];
        counters["triangle pairs: touching"] += relations[1];
        counters["triangle pairs: crossing"] += relations[2];
    }
    for (const auto& [name, count] : counts.checks) counters["checked: triangle pairs, " + name] = count;
    counters["stages: triangle tests"] = counts.stages.triangle_tests;
    for (const Stage& stage : stages) counters[std::string("stages: ") + stage.name] = counts.stages.*stage.count;
    return counters;
}

RunFailure failure_of(const char* profile, const Disagreement& found) {
    return {.profile = profile,
            .seed = found.seed,
            .where = fmt::format("pair {} ({})", found.pair, found.family),
            .check = found.path,
            .expected = found.expected,
            .got = found.got,
            .text = found.text};
}

Counters counters_of(const DistanceCounts& counts) {
    constexpr const char* kinds[] = {"vertex-vertex", "vertex-edge", "vertex-face", "edge-edge", "intersecting"};
    Counters counters;
    counters["distances"] = counts.distances;
    for (const auto& [family, of_kind] : counts.kinds) {
        for (std::size_t kind = 0; kind < of_kind.size(); ++kind) {
            counters["distance families: " + family] += of_kind[kind];
            counters[std::string("distances: ") + kinds[kind]] += of_kind[kind];
        }
    }
    for (const auto& [name, count] : counts.checks) counters["checked: distances, " + name] = count;
    return counters;
}

// Of families and the kinds of their answers, and of checks.
template <class Counts>
Counters counters_of(const Counts& counts, const std::string& name, std::uint64_t total) {
    Counters counters;
    counters[name] = total;
    for (const auto& [family, kinds] : counts.kinds) {
        for (const auto& [kind, count] : kinds) {
            counters[name + " of families: " + family] += count;
            counters[name + ": " + kind] += count;
        }
    }
    for (const auto& [check, count] : counts.checks) counters["checked: " + name + ", " + check] = count;
    return counters;
}

Counters counters_of(const HitCounts& counts) {
    return counters_of(counts, "hits", counts.lines);
}

Counters counters_of(const CastCounts& counts) {
    return counters_of(counts, "casts", counts.casts);
}

Counters counters_of(const SolidCounts& counts) {
    return counters_of(counts, "solids", counts.solids);
}

Counters counters_of(const ConvexCounts& counts) {
    return counters_of(counts, "convex", counts.convex);
}

// A run of pairs, by a function that counts what it checked and throws what it found.
template <class Counts>
RunReport run_counted(const char* profile, void (*run)(std::uint32_t seed, Lie lie, Counts& counts), std::uint32_t seed,
                      Canary canary) {
    RunReport report;
    Counts counts;
    try {
        run(seed, canary == Canary::answer ? Lie::answer : canary == Canary::recipe ? Lie::recipe : Lie::none, counts);
    } catch (const Disagreement& found) {
        report.failure = failure_of(profile, found);
    }
    report.counters = counters_of(counts);
    return report;
}

}  // namespace

std::vector<std::string> profiles_of(const std::string& name) {
    std::vector<std::string> names;
    const bool is_motion = name == "motion" || name == "all";
    for (const Profile& profile : profiles()) {
        if (is_motion || profile.name == name) names.emplace_back(profile.name);
    }
    for (const char* of_pairs : {pairs_profile, distances_profile, hits_profile, casts_profile, solids_profile,
                                 polycubes_profile, placements_profile, convex_profile}) {
        if (name == "all" || name == of_pairs) names.emplace_back(of_pairs);
    }
    return names;
}

PlayOptions options_of_run(PlayOptions options, std::string_view profile, std::uint32_t seed) {
    options.certificates.folder /= fmt::format("{}-{}.certificates", profile, seed);
    return options;
}

RunReport run(const std::string& profile, std::uint32_t seed, const PlayOptions& options) {
    const Canary canary = options.canary;
    if (profile == pairs_profile) return run_counted(pairs_profile, run_pairs, seed, canary);
    if (profile == distances_profile) return run_counted(distances_profile, run_distances, seed, canary);
    if (profile == hits_profile) return run_counted(hits_profile, run_hits, seed, canary);
    if (profile == casts_profile) return run_counted(casts_profile, run_casts, seed, canary);
    if (profile == solids_profile) return run_counted(solids_profile, run_solids, seed, canary);
    if (profile == polycubes_profile) return run_counted(polycubes_profile, run_polycubes, seed, canary);
    if (profile == placements_profile) return run_counted(placements_profile, run_placements, seed, canary);
    if (profile == convex_profile) return run_counted(convex_profile, run_convex, seed, canary);
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
