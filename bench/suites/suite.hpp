// A suite runs scenes, prints its tables, and hands its sections of the report back.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "report/page.hpp"
#include "scenes/narrow_workloads.hpp"

namespace ecods::bench {

struct SuiteOptions {
    std::size_t frame_count = 200;     // of each room; the assembly runs a third of it and more, up to its full cycle
    std::size_t repetition_count = 3;  // times are medians over these
    bool has_pictures = true;
    bool is_long = false;              // largest sizes, too
    bool is_main = false;              // the main job: fewer workloads, the engines of main_suites(), and short tables
    std::vector<std::string> engines;  // see wanted(); all when empty
    std::vector<std::size_t> sizes;    // numbers of boxes or bodies, where a suite has a choice; its own when empty
    std::filesystem::path folder;      // for pictures and what they are made from; exists

    // To see that all of it works: little data, once, no pictures.
    bool is_quick() const { return !has_pictures; }
    scenes::WorkloadSize workload_size() const {
        return is_quick() ? scenes::WorkloadSize::tiny : scenes::WorkloadSize::full;
    }

    // Returns the engines that are asked for: of each text in `engines` those that are named so; if none is, those
    // whose name contains it.
    template <class Maker>
    std::vector<Maker> wanted(std::vector<Maker> makers) const {
        if (engines.empty()) return makers;
        const std::vector<Maker> all = makers;
        std::erase_if(makers, [&](const Maker& maker) {
            return std::none_of(engines.begin(), engines.end(), [&](const std::string& text) {
                const bool is_a_name =
                    std::any_of(all.begin(), all.end(), [&](const Maker& other) { return other.name == text; });
                return is_a_name ? maker.name == text : maker.name.find(text) != std::string::npos;
            });
        });
        return makers;
    }
    bool wants(std::size_t size) const {
        return sizes.empty() || std::find(sizes.begin(), sizes.end(), size) != sizes.end();
    }
};

struct SuiteResult {
    std::vector<Section> sections;
    std::vector<Table> comparisons;  // of engines on scenes, all with the same columns; the page begins with them
    bool is_right = true;            // every answer of ECoDS was the oracle's, and every count what it must be
};

// An engine that --engines may choose.
struct EngineName {
    std::string name;
    bool is_ecods = false;
};

template <class... Maker>
std::vector<EngineName> names_of(const std::vector<Maker>&... makers) {
    std::vector<EngineName> names;
    const auto append = [&names](const auto& list) {
        for (const auto& maker : list) names.push_back({maker.name, maker.is_ecods});
    };
    (append(makers), ...);
    return names;
}

struct Suite {
    std::string name;
    SuiteResult (*run)(const SuiteOptions& options) = nullptr;
    std::vector<EngineName> engines = {};  // of which it runs those that are wanted; none: always all of its own
    bool is_judged = true;                 // whether its engines give answers, which the oracle judges
};

SuiteResult run_rooms(const SuiteOptions& options);         // all ships move: ECoDS beside FCL and all pairs
SuiteResult run_hover(const SuiteOptions& options);         // some ships move: what the manager spares
SuiteResult run_assembly(const SuiteOptions& options);      // the two-cylinder engine: which parts touch, which cross
SuiteResult run_narrow(const SuiteOptions& options);        // two meshes: time and errors of every engine
SuiteResult run_distance(const SuiteOptions& options);      // two meshes: how far; time and errors of every engine
SuiteResult run_casts(const SuiteOptions& options);         // segments, casts and moves: what is in the way, and when
SuiteResult run_turns(const SuiteOptions& options);         // a mesh turns: when it first meets another one
SuiteResult run_certificates(const SuiteOptions& options);  // answers with proofs: time and size
SuiteResult run_solids(const SuiteOptions& options);        // what is inside what: pairs, points and meshes
SuiteResult run_convex(const SuiteOptions& options);        // convex solids: how far, how deep, a thousand that move
SuiteResult run_rounded(const SuiteOptions& options);       // spheres, capsules and boxes: two bodies
SuiteResult run_arm(const SuiteOptions& options);           // an arm among obstacles: the closest pair of each step
SuiteResult run_broad(const SuiteOptions& options);         // boxes only: time of every engine
SuiteResult run_system(const SuiteOptions& options);        // the report's two experiments
SuiteResult run_memory(const SuiteOptions& options);        // bytes for a triangle, a box, a body
SuiteResult run_predicates(const SuiteOptions& options);    // triangle pairs: what exactness costs
SuiteResult run_hard_cases(const SuiteOptions& options);    // reported failures: who is right
SuiteResult run_stability(const SuiteOptions& options);     // hard triangle pairs: who is wrong, and how often

// Returns them in the order in which they run. A build for the main job alone has no others than that.
std::vector<Suite> all_suites();

// Returns the suites of the main job, with its engines.
std::vector<Suite> main_suites();

}  // namespace ecods::bench
