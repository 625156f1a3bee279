#include "suites/cast_tables.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "harness/statistics.hpp"
#include "process/progress.hpp"
#include "report/error_panel.hpp"
#include "suites/cast_measure.hpp"
#include "suites/comparison.hpp"
#include "suites/timed_rows.hpp"

namespace ecods::bench {

namespace {

using scenes::CastWorkload;

// The oracle asks every pair of triangles whose boxes on the way overlap.
std::size_t judged_count(const CastWorkload& workload, const SuiteOptions& options) {
    if (options.is_quick()) return 1;
    const std::size_t triangles = triangle_count(workload.meshes);
    return triangles <= 2000 ? 4 : triangles <= 20000 ? 1 : 0;
}

struct Measured {
    const CastWorkload& workload;
    CastTruth truth;
    std::vector<CastRun> runs;

    std::span<const double> us_of(const std::string& name) const {
        for (const CastRun& run : runs)
            if (run.maker->name == name) return run.us;
        return {};
    }
    bool is_right() const {
        return truth.wrong_count == 0 && std::ranges::all_of(runs, [&](const CastRun& run) {
                   return !run.maker->is_ecods || (run.failure.empty() && errors_of(run, truth).wrong == 0);
               });
    }
};

void add_rows(Table& table, const Measured& measured) {
    for (const CastRun& run : measured.runs) {
        add_row(table, {measured.workload.name, run.maker->name, run.us, run.failure}, [&] {
            std::vector<std::string> cells = {ratio_text(times_as_fast(run.us, measured.us_of(cast_yardstick))),
                                              share_text(run.us, measured.us_of(own_end_distance))};
            if (run.maker->answer != CastAnswer::time) return cells;
            const CastErrors errors = errors_of(run, measured.truth);
            const std::vector<double>& times = errors.time_errors;
            for (std::string& cell : std::vector<std::string>{
                     fmt::format("{} / {}", measured.truth.contact_count(), run.answers.size()),
                     fmt::format("{}", errors.false_negatives), fmt::format("{}", errors.false_positives),
                     times.empty() ? std::string() : error_text(median(times)),
                     times.empty() ? std::string() : error_text(*std::ranges::max_element(times)),
                     run.maker->is_ecods ? fmt::format("{}", errors.wrong) : std::string(),
                     fmt::format("{}", measured.truth.judged_count)})
                cells.push_back(std::move(cell));
            return cells;
        });
    }
}

Table empty_table(const std::string& title, std::size_t repetition_count) {
    Table table = timed_table(title,
                              {"times FCL", "of a distance", "contacts", "false -", "false +", "median error",
                               "most error", "wrong", "judged"},
                              repetition_count);
    table.notes.push_back(fmt::format(
        "Times FCL: how many times as fast as {}, in the same repetition. Of a distance: time over that "
        "of ECoDS's distance of the two bodies at the end of the motion. Advancement is not asked of meshes of which "
        "it would take minutes.",
        cast_yardstick));
    return table;
}

Table slide_table(std::size_t repetition_count) {
    Table table = empty_table("One mesh is translated: when does it first meet the other?", repetition_count);
    for (const char* note :
         {"False: no contact reported, though the closed bodies meet on the way, and a contact reported where they do "
          "not. Errors: of the time, from 0 to 1, where contact is there and reported. Wrong: answers of ECoDS that "
          "are not the true time, rounded once.",
          "Judged: so many of the first contacts, features included, are the oracle's; the others are those of ECoDS. "
          "Bullet sweeps solid convex hulls: here of bodies whose surface is that of their hull, and which start "
          "apart."})
        table.notes.emplace_back(note);
    return table;
}

Table turn_table(std::size_t repetition_count) {
    Table table = empty_table("One mesh goes from one pose to another", repetition_count);
    for (const char* note :
         {"ECoDS moves each point on a straight line. FCL interpolates: it turns the body about an axis while its "
          "origin goes straight, which for the tenth of a radian here is another motion, by about 1e-3 of the "
          "diameter in the middle. So its times differ by about as much where nothing is wrong; what counts is where "
          "it reports no contact, of bodies that end a twentieth of the diameter within each other.",
          "Judged: as above."})
        table.notes.emplace_back(note);
    return table;
}

Section chart_of(const std::vector<Measured>& all) {
    std::vector<Panel> panels;
    for (const Measured& measured : all) {
        if (!measured.workload.is_translation) continue;
        std::vector<ErrorPoint> points;
        for (const CastRun& run : measured.runs) {
            if (!run.failure.empty() || run.maker->answer != CastAnswer::time) continue;
            const CastErrors errors = errors_of(run, measured.truth);
            points.push_back({run.maker->name, median(run.us),
                              static_cast<double>(errors.false_negatives + errors.false_positives) /
                                  static_cast<double>(run.answers.size())});
        }
        panels.push_back(error_panel(measured.workload.name, "us per motion", points));
    }
    return {"Casts: speed against error",
            {"Each engine is a point for each workload: time per motion across; up the share of motions of which it "
             "says wrongly whether there is contact. The line at 0 is no error at all."},
            {},
            {},
            {error_chart("cast-errors", std::move(panels),
                         "Speed against error of casts. The better engine is lower and further left.")}};
}

}  // namespace

SuiteResult run_two_body_casts(const SuiteOptions& options) {
    std::vector<CastMaker> makers = cast_engines();
    options.keep_wanted(makers);
    SuiteResult result;
    if (makers.empty()) return result;
    const std::vector<CastWorkload> workloads =
        scenes::cast_workloads(options.is_quick() ? scenes::WorkloadSize::tiny : scenes::WorkloadSize::full);
    Table slides = slide_table(options.repetition_count), turns = turn_table(options.repetition_count);
    std::vector<Measured> all;
    {
        process::Progress progress("casts", workloads.size());
        for (const CastWorkload& workload : workloads) {
            CastTruth truth = find_contacts(workload, judged_count(workload, options));
            auto runs = measure_casts(workload, makers, options.repetition_count);
            all.push_back({workload, std::move(truth), std::move(runs)});
            result.is_right &= all.back().is_right();
            add_rows(workload.is_translation ? slides : turns, all.back());
            progress.step();
        }
    }
    print(slides);
    print(turns);
    if (options.has_pictures) result.sections.push_back(chart_of(all));
    result.sections.push_back(
        {"Casts of two meshes",
         {},
         {slides, turns, use_table<CastMaker>("How each engine is asked for casts", makers, poses_are_timed)},
         {}});
    return result;
}

}  // namespace ecods::bench
