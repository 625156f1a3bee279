#include "suites/timed_rows.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "harness/statistics.hpp"

namespace ecods::bench {

Table timed_table(const std::string& title, const std::vector<std::string>& columns, std::size_t repetition_count,
                  const std::vector<std::string>& notes) {
    Table table{
        .title = title,
        .header = {"workload", "engine", "us/query", "spread %"},
        .text_columns = 2,
        .notes = {fmt::format("Processor time: {}; first one pass over the queries untimed, then 20 ms of them; "
                              "each engine pinned in a process of its own. Spread: quartile distance.",
                              medians_of(repetition_count))}};
    table.header.insert(table.header.end(), columns.begin(), columns.end());
    table.notes.insert(table.notes.end(), notes.begin(), notes.end());
    return table;
}

void add_row(Table& table, const TimedRow& row, const std::function<std::vector<std::string>()>& cells) {
    std::vector<std::string> all = {row.workload, row.engine};
    if (row.failure.empty()) {
        const double us = median({row.us.begin(), row.us.end()});
        all.push_back(us < 1 ? fmt::format("{:.3f}", us) : fmt::format("{:.2f}", us));
        all.push_back(row.us.size() < 2 ? std::string()
                                        : fmt::format("{:.0f}", spread_in_percent({row.us.begin(), row.us.end()})));
        for (std::string& cell : cells()) all.push_back(std::move(cell));
    } else {
        all.push_back(row.failure);
    }
    all.resize(table.header.size());
    table.rows.push_back(std::move(all));
}

std::string ratio_text(double ratio) {
    return ratio == 0 ? "" : fmt::format("{:.2f}", ratio);
}

std::string share_text(std::span<const double> us, std::span<const double> of) {
    const double faster = times_as_fast(us, of);
    return ratio_text(faster == 0 ? 0 : 1 / faster);
}

std::string error_text(double error) {
    return error == 0 ? "0" : fmt::format("{:.0e}", error);
}

std::size_t triangle_count(std::span<const scenes::NamedMesh> meshes) {
    std::size_t count = 0;
    for (const scenes::NamedMesh& named : meshes) count = std::max(count, named.mesh->triangles().size());
    return count;
}

}  // namespace ecods::bench
