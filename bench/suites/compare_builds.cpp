#include "suites/compare_builds.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "harness/statistics.hpp"
#include "process/program.hpp"
#include "process/progress.hpp"

namespace ecods::bench {

namespace {

std::vector<double> times(const std::vector<OwnSample>& samples) {
    std::vector<double> ns;
    for (const OwnSample& sample : samples) ns.push_back(sample.ns);
    return ns;
}

// "": equal.
std::string count_changes(const OwnSample& before, const OwnSample& after) {
    std::set<std::string> names;
    for (const auto& [name, value] : before.counts) names.insert(name);
    for (const auto& [name, value] : after.counts) names.insert(name);
    std::string text;
    for (const std::string& name : names) {
        const auto old_count = before.counts.find(name), new_count = after.counts.find(name);
        // A count that only one build keeps says nothing about work.
        if (old_count == before.counts.end() || new_count == after.counts.end()) continue;
        if (old_count->second == new_count->second) continue;
        text += fmt::format("{}{} {} -> {}", text.empty() ? "" : "; ", name, old_count->second, new_count->second);
    }
    return text;
}

std::string verdict(const std::vector<double>& ratios) {
    const double middle = median(ratios);
    const auto disagreeing = static_cast<std::size_t>(
        std::count_if(ratios.begin(), ratios.end(), [&](double ratio) { return (ratio > 1) != (middle > 1); }));
    // Of six equal coins all fall alike once in 32 throws.
    if (ratios.size() < 6 || disagreeing > ratios.size() / 10 || (middle < 1.02 && middle > 1 / 1.02)) return "";
    return middle > 1 ? "slower" : "faster";
}

class Build {
  public:
    Build(const std::string& program, const std::vector<std::string>& options) : talk_(arguments(program, options)) {
        try {
            names_ = parse_names(talk_.read_line());
        } catch (const std::exception& error) {
            throw std::runtime_error(program + " cannot be compared: " + error.what());
        }
    }

    const std::vector<std::string>& names() const { return names_; }

    bool has(const std::string& name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }

    void run(const std::string& name, std::vector<OwnSample>& samples) {
        const auto found = std::find(names_.begin(), names_.end(), name);
        if (found != names_.end()) samples.push_back(parse_sample(talk_.ask(std::to_string(found - names_.begin()))));
    }

  private:
    static std::vector<std::string> arguments(const std::string& program, const std::vector<std::string>& options) {
        std::vector<std::string> list = {program, "--own"};
        list.insert(list.end(), options.begin(), options.end());
        return list;
    }

    process::Conversation talk_;
    std::vector<std::string> names_;
};

}  // namespace

BuildComparison compare_samples(const std::vector<PairedSamples>& all) {
    BuildComparison result;
    Table& table = result.table;
    table.title = "Two builds: new against old";
    table.header = {"workload", "answers", "counts", "old ns", "new ns", "new/old", "spread %", "time"};
    for (const PairedSamples& pair : all) {
        if (pair.before.empty() || pair.after.empty()) {
            table.rows.push_back(
                {pair.workload, pair.before.empty() ? "only new" : "only old", "", "", "", "", "", ""});
            continue;
        }
        const bool has_same_answers = pair.before.front().answers == pair.after.front().answers;
        const std::string changes = count_changes(pair.before.front(), pair.after.front());
        result.is_same &= has_same_answers && changes.empty();
        const std::vector<double> before = times(pair.before), after = times(pair.after);
        std::vector<double> ratios;
        for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) ratios.push_back(after[i] / before[i]);
        const double ratio = median(ratios);
        if (ratio > result.ratio_max) {
            result.ratio_max = ratio;
            result.slowest = pair.workload;
        }
        table.rows.push_back({pair.workload, has_same_answers ? "equal" : "DIFFERENT",
                              changes.empty() ? "equal" : changes, fmt::format("{:.1f}", median(before)),
                              fmt::format("{:.1f}", median(after)), fmt::format("{:.3f}", ratio),
                              fmt::format("{:.0f}", spread_in_percent(ratios)), verdict(ratios)});
    }
    table.text_columns = 3;
    table.notes = {
        "ns of processor time: for each query, box and frame, or frame. Ratios: medians of those of single "
        "turns, with their quartile distance."};
    return result;
}

BuildComparison compare_builds(const std::string& before, const std::string& after, std::size_t repetition_count,
                               const std::vector<std::string>& options) {
    Build old_build(before, options), new_build(after, options);
    std::vector<PairedSamples> all;
    for (const std::string& name : old_build.names()) all.push_back({name, {}, {}});
    for (const std::string& name : new_build.names())
        if (!old_build.has(name)) all.push_back({name, {}, {}});
    process::Progress progress("two builds", all.size() * repetition_count);
    for (std::size_t repetition = 0; repetition < repetition_count; ++repetition) {
        progress.wipe();
        fmt::print(stderr, "two builds: turn {} of {} ...\n", repetition + 1, repetition_count);
        for (PairedSamples& pair : all) {
            if (repetition % 2 == 0) old_build.run(pair.workload, pair.before);
            new_build.run(pair.workload, pair.after);
            if (repetition % 2 != 0) old_build.run(pair.workload, pair.before);
            progress.step();
        }
    }
    return compare_samples(all);
}

}  // namespace ecods::bench
