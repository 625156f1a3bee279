#include "report/timings.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

namespace ecods::bench {

namespace {

// Columns that count wrong answers.
constexpr std::array wrong_columns = {"false -",    "false +",        "said to meet", "said apart",
                                      "off by 1 %", "other triangle", "missing",      "extra"};

bool is_time(const std::string& column) {
    return column.starts_with("us/") || column.starts_with("ns/") || column.starts_with("ms/");
}

// "200 / 400": of so many questions, the answer was yes.
std::optional<double> count_behind_slash(const std::string& cell) {
    const std::size_t slash = cell.find(" / ");
    return slash == std::string::npos ? std::nullopt : number_in(cell.substr(slash + 3));
}

}  // namespace

std::optional<double> number_in(const std::string& cell) {
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    return end == cell.c_str() ? std::nullopt : std::optional(value);
}

const Timing* TimedWorkload::find(const std::string& engine) const {
    const auto found = std::ranges::find(engines, engine, &Timing::engine);
    return found == engines.end() ? nullptr : &*found;
}

const Timing* TimedWorkload::first_of_ecods() const {
    const auto found = std::ranges::find_if(engines, [](const Timing& timing) { return timing.is_ecods(); });
    return found == engines.end() ? nullptr : &*found;
}

double TimedWorkload::fastest() const {
    double best = std::numeric_limits<double>::infinity();
    for (const Timing& timing : engines) best = std::min(best, timing.time);
    return best;
}

std::optional<TimedTable> timed(const Table& table) {
    if (table.text_columns != 2 || table.header.size() < 3 || table.header[1] != "engine" || !is_time(table.header[2]))
        return std::nullopt;
    TimedTable result{table.title, table.header[2], {}};
    for (const std::vector<std::string>& row : table.rows) {
        const std::optional<double> time = number_in(row.at(2));
        if (!time || *time <= 0) continue;
        if (result.workloads.empty() || result.workloads.back().name != row[0])
            result.workloads.push_back({row[0], {}});
        Timing& timing = result.workloads.back().engines.emplace_back();
        timing.engine = row[1];
        timing.time = *time;
        for (std::size_t c = 3; c < row.size(); ++c) {
            if (std::ranges::find(wrong_columns, table.header[c]) != wrong_columns.end()) {
                if (const auto count = number_in(row[c])) timing.wrong = timing.wrong.value_or(0) + *count;
            } else if (table.header[c] == "hits" || table.header[c] == "hit") {
                timing.asked = count_behind_slash(row[c]);
            }
        }
    }
    return result.workloads.empty() ? std::nullopt : std::optional(std::move(result));
}

std::vector<TimedTable> timed_tables(const Page& page) {
    std::vector<TimedTable> tables;
    for (const Section& section : page.sections)
        for (const Table& table : section.tables)
            if (auto one = timed(table)) tables.push_back(std::move(*one));
    return tables;
}

}  // namespace ecods::bench
