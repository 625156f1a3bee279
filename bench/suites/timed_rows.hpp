// What the tables of engines on workloads have in common: a row is a workload, an engine, its time and its spread, then
// what the suite judges it by.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "report/table.hpp"
#include "scenes/scene.hpp"

namespace ecods::bench {

// The first column names the workload, the second the engine; then come "us/query" and "spread %", then `columns`. The
// notes are those that say how times were taken, then `notes`.
Table timed_table(const std::string& title, const std::vector<std::string>& columns, std::size_t repetition_count,
                  const std::vector<std::string>& notes);

// `us` has one time for each repetition. Where the engine failed, the reason stands in place of all figures.
struct TimedRow {
    const std::string& workload;
    const std::string& engine;
    std::span<const double> us;
    const std::string& failure;
};

// Adds the row to a table made as above; `cells()` gives what comes behind the spread, and is not called of a failure.
void add_row(Table& table, const TimedRow& row, const std::function<std::vector<std::string>()>& cells);

// A ratio in a table; nothing where there is none, which is 0.
std::string ratio_text(double ratio);

// The time over that of another, in the same repetition: the other way round than times_as_fast().
std::string share_text(std::span<const double> us, std::span<const double> of);

// An absolute error in a table.
std::string error_text(double error);

// What most engines of two meshes are timed with.
constexpr const char* poses_are_timed = "Building trees is outside the times; setting both poses is inside.";

// The engines and how each is used, under that title.
template <class Maker>
Table use_table(const std::string& title, const std::vector<Maker>& makers, const std::string& note) {
    Table table{.title = title, .header = {"engine", "use; precision"}, .text_columns = 2, .notes = {note}};
    for (const Maker& maker : makers) table.rows.push_back({maker.name, maker.use});
    return table;
}

// Of the largest of these meshes.
std::size_t triangle_count(std::span<const scenes::NamedMesh> meshes);

}  // namespace ecods::bench
