// The command line of ecods_clash.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "programs/clash/judge.hpp"
#include "scenes/io/named_file.hpp"

namespace ecods::clash {

constexpr int exit_ok = 0;
constexpr int exit_found = 1;
constexpr int exit_failed = 2;

struct Command {
    std::vector<std::filesystem::path> paths;
    scenes::NamedFiles named_files = scenes::NamedFiles::anywhere;
    JudgeOptions judging;
    std::set<Kind> failing_kinds;  // clashes of these make the exit status 1
    bool keeps_going = false;
    bool is_quiet = false;
    bool has_times = false;
    std::string json, csv, html, bcf;  // where to write; empty: not at all, "-": standard output
    std::size_t picture_count = 0;
    std::string date = "1970-01-01T00:00:00Z";  // of the BCF's topics
};

// Parses and checks. The exit status where the program is to end at once (after --help, or an error, which is printed).
std::optional<int> parse(int argc, const char* const* argv, Command& command);

// Those options that may change the report, as ClashReport has them.
std::vector<std::pair<std::string, std::string>> list_options(const Command& command);

}  // namespace ecods::clash
