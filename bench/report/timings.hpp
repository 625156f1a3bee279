// The timed tables of a page, read again: who took how long on what, and how often who was wrong. Of the cells that the
// page shows, so that what is concluded from them holds for saved results, too, and says nothing else than they do.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/page.hpp"

namespace ecods::bench {

struct Timing {
    std::string engine;
    double time = 0;              // in the unit of the table
    std::optional<double> wrong;  // answers, if the table counts them
    std::optional<double> asked;  // questions, if the table says how many
    bool is_ecods() const { return engine.starts_with("ECoDS"); }
};

struct TimedWorkload {
    std::string name;
    std::vector<Timing> engines;  // as in the table; those that failed are left out

    const Timing* find(const std::string& engine) const;  // null: none
    const Timing* first_of_ecods() const;
    double fastest() const;  // of all engines
};

struct TimedTable {
    std::string title;
    std::string unit;  // "us/query", for one
    std::vector<TimedWorkload> workloads;
};

// Nothing where the table is not one of engines' times on workloads.
std::optional<TimedTable> timed(const Table& table);

// All of a page, in order.
std::vector<TimedTable> timed_tables(const Page& page);

// The number that a cell begins with.
std::optional<double> number_in(const std::string& cell);

}  // namespace ecods::bench
