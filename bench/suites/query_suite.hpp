// A suite of engines on workloads of queries: how each is measured, judged, and shown. What is asked, and which answers
// are wrong, is the question's part.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/query_runs.hpp"
#include "harness/statistics.hpp"
#include "harness/truths.hpp"
#include "process/progress.hpp"
#include "report/error_panel.hpp"
#include "suites/suite.hpp"
#include "suites/timed_rows.hpp"

namespace ecods::bench {

template <class S>
struct Measured;

// The part of a suite that its question has: `S::Question` is what engines are asked, `S::Truth` what is true of a
// query, `S::Errors` what is wrong with the answers of a run.
template <class S>
concept Asked = requires(const typename S::Question::Workload& workload, const SuiteOptions& options,
                         const Measured<S>& measured, std::size_t run) {
    { S::judged_count(workload, options) } -> std::convertible_to<std::size_t>;
    { S::find_truths(workload, std::size_t{}) } -> std::same_as<Truths<typename S::Truth>>;
    // A run that failed has no answers. `wrong` counts those that are not as they must be of ECoDS.
    { S::errors_of(measured.runs[run], workload, measured.truths).wrong } -> std::convertible_to<std::size_t>;
    // The cells behind time and spread in a table, and the height of the run's point on a chart, which may have none.
    { S::cells(measured, run) } -> std::same_as<std::vector<std::string>>;
    { S::error(measured, run) } -> std::same_as<std::optional<double>>;
};

// All engines on one workload.
template <class S>
struct Measured {
    using Q = typename S::Question;

    const typename Q::Workload& workload;
    Truths<typename S::Truth> truths;
    std::vector<Run<Q>> runs;
    std::vector<typename S::Errors> errors = {};  // of each run

    std::span<const double> us_of(const std::string& engine) const {
        for (const Run<Q>& run : runs)
            if (run.maker->name == engine) return run.us;
        return {};
    }
    bool is_right() const {
        bool is_right = truths.wrong_count == 0;
        for (std::size_t i = 0; i < runs.size(); ++i)
            if (runs[i].maker->is_ecods) is_right &= runs[i].failure.empty() && errors[i].wrong == 0;
        return is_right;
    }
    // The cell of wrong answers, which only rows of ECoDS have.
    std::string wrong_text(std::size_t run) const {
        return runs[run].maker->is_ecods ? std::to_string(errors[run].wrong) : std::string();
    }
};

// Asks for the truth and runs the engines that are asked about the workload.
template <Asked S>
Measured<S> measure_one(const typename S::Question::Workload& workload,
                        const std::vector<Maker<typename S::Question>>& makers, const SuiteOptions& options) {
    Measured<S> measured{workload, S::find_truths(workload, S::judged_count(workload, options)),
                         measure(workload, makers, options.repetition_count)};
    for (const auto& run : measured.runs) measured.errors.push_back(S::errors_of(run, workload, measured.truths));
    return measured;
}

// Adds the rows of each workload to the table that it has; `table_of(workload)` is null where it has none.
template <Asked S, class TableOf>
std::vector<Measured<S>> measure_all(const std::vector<typename S::Question::Workload>& workloads,
                                     const std::vector<Maker<typename S::Question>>& makers,
                                     const SuiteOptions& options, const std::string& label, const TableOf& table_of,
                                     SuiteResult& result) {
    std::vector<Measured<S>> all;
    process::Progress progress(label, workloads.size());
    for (const auto& workload : workloads) {
        const Measured<S>& measured = all.emplace_back(measure_one<S>(workload, makers, options));
        result.is_right &= measured.is_right();
        if (Table* const table = table_of(workload)) add_rows(*table, measured);
        progress.step();
    }
    return all;
}

template <Asked S>
void add_rows(Table& table, const Measured<S>& measured) {
    for (std::size_t i = 0; i < measured.runs.size(); ++i) {
        const auto& run = measured.runs[i];
        add_row(table, {measured.workload.name, run.maker->name, run.us, run.failure},
                [&] { return S::cells(measured, i); });
    }
}

// A point for each engine: the medians of its times and the means of its errors on these workloads.
template <Asked S>
Panel panel_of(const std::string& title, const std::string& unit, std::span<const Measured<S>> all,
               ErrorScale scale = ErrorScale::shares) {
    std::vector<ErrorPoint> points;
    for (std::size_t i = 0; i < all.front().runs.size(); ++i) {
        std::vector<double> us;
        double errors = 0;
        for (const Measured<S>& measured : all) {
            if (!measured.runs[i].failure.empty()) continue;
            const std::optional<double> error = S::error(measured, i);
            if (!error) continue;
            us.push_back(median(measured.runs[i].us));
            errors += *error;
        }
        if (!us.empty())
            points.push_back({all.front().runs[i].maker->name, median(us), errors / static_cast<double>(us.size())});
    }
    return error_panel(title, unit, points, scale);
}

// A panel for each workload.
template <Asked S>
std::vector<Panel> panels_of(const std::string& unit, const std::vector<Measured<S>>& all,
                             ErrorScale scale = ErrorScale::shares) {
    std::vector<Panel> panels;
    for (const Measured<S>& measured : all)
        panels.push_back(panel_of<S>(measured.workload.name, unit, std::span(&measured, 1), scale));
    return panels;
}

// The median and the greatest of errors, by `text`; nothing where there are none.
template <class Text>
std::vector<std::string> median_and_most(const std::vector<double>& errors, const Text& text) {
    if (errors.empty()) return {"", ""};
    return {text(median(errors)), text(*std::ranges::max_element(errors))};
}

}  // namespace ecods::bench
