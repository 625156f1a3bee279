// One run: a profile and a seed.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/base/counters.hpp"
#include "fuzz/script/play.hpp"
#include "process/contained.hpp"

namespace ecods::fuzz {

struct RunFailure {
    std::string profile;
    std::uint32_t seed = 0;
    std::string where = {};  // in the run
    std::string check = {};
    std::string expected = {};
    std::string got = {};
    std::string text = {};   // what else there is to be shown
    std::string trace = {};  // files that were written
    std::string picture = {};
};

struct RunReport {
    Counters counters = {};
    std::optional<RunFailure> failure = {};
};

// The profiles that a name stands for: one, or several that take turns by the seed. Empty if there is no such name.
std::vector<std::string> profiles_of(const std::string& name);

// Deterministic; it may crash or hang if the library does.
RunReport run(const std::string& profile, std::uint32_t seed, const PlayOptions& options);

// The options with a folder of the run's own in the folder of certificates.
PlayOptions options_of_run(PlayOptions options, std::string_view profile, std::uint32_t seed);

// Work in a process of its own, in one turn: more processor time than that, or twenty times that time on the clock, is
// a hang.
process::Contained contained(std::function<std::string()> work, unsigned seconds_max);

// The check that failed when work did not return: "hang" or "crash".
std::string check_of(const process::Outcome& outcome);

// Between processes.
RunReport report_of(const std::string& text);  // as text_of() wrote it
std::string text_of(const RunReport& report);

}  // namespace ecods::fuzz
