#include "report/headline.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "report/error_panel.hpp"
#include "report/timings.hpp"

namespace ecods::bench {

namespace {

// Workloads half of whose questions are about exact contact.
constexpr std::array contact_workloads = {"stacked bricks", "splined shaft in its hub"};

const Table* find_table(const Page& page, const std::string& title) {
    for (const Section& section : page.sections)
        for (const Table& table : section.tables)
            if (table.title == title) return &table;
    return nullptr;
}

struct Share {
    double wrong = 0;
    double asked = 0;
};

// The geometric mean of ratios, over the workloads that an engine finishes.
struct Mean {
    double logarithms = 0;
    int count = 0;

    void add(double ratio) {
        logarithms += std::log(ratio);
        ++count;
    }
    double value() const { return std::exp(logarithms / count); }
};

// Cells like "17 / 18", false negatives and positives, in the row of adjacent doubles.
void add_gaps(const Page& page, std::map<std::string, Share>& shares) {
    const Table* gaps = find_table(page, gaps_title);
    if (gaps == nullptr) return;
    for (const std::vector<std::string>& row : gaps->rows) {
        if (row.front() != adjacent_doubles) continue;
        for (std::size_t c = 2; c < row.size(); ++c) {
            const std::size_t slash = row[c].find(" / ");
            const auto queries = number_in(row.at(1)), negatives = number_in(row[c]);
            if (slash == std::string::npos || !queries || !negatives) continue;
            Share& share = shares[gaps->header[c]];
            share.wrong += *negatives + number_in(row[c].substr(slash + 3)).value_or(0);
            share.asked += *queries;
        }
    }
}

std::string times_text(double ratio) {
    return ratio >= 10 ? fmt::format("{:.0f}", ratio) : fmt::format("{:.2g}", ratio);
}

// Names the columns of the ratios. The full tables show the rest: other ways to ask ECoDS, and engines on few
// workloads.
std::vector<std::string> rivals(const TimedTable& timed) {
    std::vector<std::string> engines;
    for (const TimedWorkload& workload : timed.workloads) {
        for (const Timing& timing : workload.engines) {
            const auto has = [&](const TimedWorkload& other) { return other.find(timing.engine) != nullptr; };
            const auto count = static_cast<std::size_t>(std::ranges::count_if(timed.workloads, has));
            if (!timing.is_ecods() && 2 * count >= timed.workloads.size() &&
                std::ranges::find(engines, timing.engine) == engines.end())
                engines.push_back(timing.engine);
        }
    }
    return engines;
}

Table ratio_table(const TimedTable& timed, const std::string& title) {
    const std::vector<std::string> engines = rivals(timed);
    Table table;
    table.title = title;
    table.header = {"workload", "ECoDS, " + timed.unit};
    table.header.insert(table.header.end(), engines.begin(), engines.end());
    bool has_wrong = false;
    for (const TimedWorkload& workload : timed.workloads) {
        const Timing* own = workload.first_of_ecods();
        if (own == nullptr) continue;
        std::vector<std::string> row = {workload.name, fmt::format("{:.4g}", own->time)};
        for (const std::string& engine : engines) {
            const Timing* other = workload.find(engine);
            std::string cell = other == nullptr ? "" : times_text(other->time / own->time) + " ×";
            if (other != nullptr && other->wrong.value_or(0) > 0) {
                cell += fmt::format(", {:.0f} wrong", *other->wrong);
                has_wrong = true;
            }
            if (other != nullptr && other->time < own->time) table.loud.insert({table.rows.size(), row.size()});
            row.push_back(cell);
        }
        table.rows.push_back(std::move(row));
    }
    table.notes = {
        fmt::format("Each engine's time over that of ECoDS: above 1 ECoDS is faster, below 1 it is "
                    "slower.{}",
                    has_wrong ? " Wrong: so many answers. ECoDS has none." : "")};
    return table;
}

// Every workload of every timed table on which another engine took less time than ECoDS.
Section losses(const std::vector<TimedTable>& tables) {
    Table table;
    table.title = "Where another engine is faster";
    table.text_columns = 3;
    table.header = {"question", "workload", "engine", "its time", "of ECoDS", "ECoDS takes", "its wrong answers"};
    std::size_t workload_count = 0;
    std::vector<std::pair<double, std::vector<std::string>>> rows;
    for (const TimedTable& timed : tables) {
        for (const TimedWorkload& workload : timed.workloads) {
            const Timing* own = workload.first_of_ecods();
            if (own == nullptr || workload.engines.size() < 2) continue;
            ++workload_count;
            const Timing* best = nullptr;
            for (const Timing& timing : workload.engines)
                if (!timing.is_ecods() && timing.time < (best == nullptr ? own->time : best->time)) best = &timing;
            if (best == nullptr) continue;
            const double ratio = own->time / best->time;
            rows.emplace_back(
                ratio, std::vector<std::string>{timed.title, workload.name, best->engine,
                                                fmt::format("{:.4g} {}", best->time, timed.unit),
                                                fmt::format("{:.4g}", own->time), fmt::format("{:.2f} ×", ratio),
                                                best->wrong ? fmt::format("{:.0f}", *best->wrong) : "not counted"});
        }
    }
    std::ranges::stable_sort(rows, [](const auto& a, const auto& b) { return a.first > b.first; });
    for (auto& [ratio, row] : rows) {
        table.loud.insert({table.rows.size(), 5});
        table.rows.push_back(std::move(row));
    }
    table.notes = {"The fastest of the others beside the first way to ask ECoDS in that table, worst first."};
    Section section{
        "Where ECoDS loses",
        {rows.empty()
             ? fmt::format("On none of the {} timed workloads of this page is another engine faster.", workload_count)
             : fmt::format("On {} of the {} timed workloads of this page another engine is faster.", rows.size(),
                           workload_count)},
        {},
        {}};
    if (!rows.empty()) section.tables.push_back(std::move(table));
    return section;
}

}  // namespace

std::optional<Table> ratio_table(const Table& table, const std::string& title) {
    const auto of_table = timed(table);
    return of_table ? std::optional(ratio_table(*of_table, title)) : std::nullopt;
}

std::optional<Chart> summary_chart(const Page& page) {
    const Table* table = find_table(page, two_meshes_title);
    const auto timed_table = table == nullptr ? std::nullopt : timed(*table);
    if (!timed_table) return std::nullopt;
    std::map<std::string, Share> shares;
    add_gaps(page, shares);
    std::map<std::string, Mean> means;
    for (const TimedWorkload& workload : timed_table->workloads) {
        const double fastest = workload.fastest();
        const bool is_contact = std::ranges::find(contact_workloads, workload.name) != contact_workloads.end();
        for (const Timing& timing : workload.engines) {
            means[timing.engine].add(timing.time / fastest);
            if (!is_contact || !timing.wrong || !timing.asked) continue;
            shares[timing.engine].wrong += *timing.wrong;
            shares[timing.engine].asked += *timing.asked;
        }
    }
    std::vector<ErrorPoint> points;
    double asked = 0;
    for (const Timing& timing : timed_table->workloads.front().engines) {
        const Share share = shares[timing.engine];
        if (share.asked == 0) continue;
        asked = share.asked;
        points.push_back({timing.engine, means[timing.engine].value(), share.wrong / share.asked});
    }
    if (points.empty()) return std::nullopt;
    Panel panel = error_panel("Do two meshes touch?", "times that of the fastest", points);
    panel.y.title = "wrong answers at exact contact";
    panel.x.title = "time over that of the fastest engine";
    const auto [least, greatest] = std::ranges::minmax(points, {}, &ErrorPoint::time);
    panel.x.low = least.time / 2;
    panel.x.high = greatest.time * 4;
    panel.has_names = true;
    panel.is_folded = false;
    return Chart{
        "summary",
        {std::move(panel)},
        fmt::format(
            "Each engine is a point; the better is lower and further left. Across: its time over that "
            "of the fastest, the geometric mean over those of {} workloads that it finishes. Up: the share of wrong "
            "answers to {:.0f} questions about meshes in exact contact, with a small clearance, or an "
            "ulp apart, beside an exact oracle.",
            timed_table->workloads.size(), asked)};
}

std::vector<Section> headline(const Page& page) {
    std::vector<Section> sections;
    Section summary{"In one picture", {}, {}, {}};
    if (auto chart = summary_chart(page)) summary.charts.push_back(std::move(*chart));
    if (!summary.charts.empty()) sections.push_back(std::move(summary));
    Section ratios{"In three tables", {}, {}, {}};
    for (const auto& [title, heading] :
         {std::pair{two_meshes_title, "Two meshes: times as long as ECoDS"},
          std::pair{boxes_title, "Moving boxes, all overlapping pairs: times as long as ECoDS"},
          std::pair{scenes_title, "Many moving meshes, all colliding pairs: times as long as ECoDS"}}) {
        const Table* table = find_table(page, title);
        auto of_table = table == nullptr ? std::nullopt : ratio_table(*table, heading);
        if (of_table) ratios.tables.push_back(std::move(*of_table));
    }
    if (!ratios.tables.empty()) sections.push_back(std::move(ratios));
    const std::vector<TimedTable> tables = timed_tables(page);
    if (!tables.empty()) sections.push_back(losses(tables));
    return sections;
}

}  // namespace ecods::bench
