// What a reader should see first: one chart of all engines, three tables of ratios, and where ECoDS loses.
#pragma once

#include <optional>
#include <vector>

#include "report/page.hpp"

namespace ecods::bench {

// Of what the page's tables say; without the parts for which it has no tables.
std::vector<Section> headline(const Page& page);

// Each engine of two meshes as a point: across, how many times slower it is than the fastest (the geometric mean over
// the workloads); up, the share of wrong answers where the two are in exact contact, or an ulp beside it. Nothing
// without these tables, which the suite `narrow` makes.
std::optional<Chart> summary_chart(const Page& page);

// Divides the others' times by that of ECoDS: a row for each workload, a column for each engine that has at least half
// of them. Nothing where the table is not one of engines' times on workloads.
std::optional<Table> ratio_table(const Table& table, const std::string& title);

// Titles and names that the headline looks for.
inline constexpr const char* two_meshes_title = "Two meshes: do they touch?";
inline constexpr const char* gaps_title = "Ships at controlled gaps: false negatives / false positives";
inline constexpr const char* adjacent_doubles = "adjacent doubles";
inline constexpr const char* boxes_title = "Boxes that move: which overlap?";
inline constexpr const char* scenes_title = "All scenes";

}  // namespace ecods::bench
