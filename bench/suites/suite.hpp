// A suite runs scenes, prints its tables, and hands its sections of the report back.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "report/page.hpp"

namespace ecods::bench {

struct SuiteOptions {
    std::size_t frame_count = 200;     // of each room; the assembly runs a third of it and more, up to its full cycle
    std::size_t repetition_count = 3;  // times are medians over these
    bool has_pictures = true;
    std::filesystem::path folder;  // for pictures and what they are made from; exists
};

struct SuiteResult {
    std::vector<Section> sections;
    bool is_right = true;  // every answer of ECoDS was the oracle's, and every count what it must be
};

struct Suite {
    std::string name;
    SuiteResult (*run)(const SuiteOptions& options) = nullptr;
};

SuiteResult run_rooms(const SuiteOptions& options);     // all ships move: ECoDS beside FCL and all pairs
SuiteResult run_hover(const SuiteOptions& options);     // some ships move: what the manager spares
SuiteResult run_assembly(const SuiteOptions& options);  // the two-cylinder engine: which parts touch, which cross

// In the order in which they run.
std::vector<Suite> all_suites();

}  // namespace ecods::bench
