// Casts of two meshes: times and errors of every engine of casts.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engines/cast_engine.hpp"
#include "engines/own_casts.hpp"
#include "judge/cast_truth.hpp"
#include "suites/comparison.hpp"
#include "suites/parts.hpp"
#include "suites/query_suite.hpp"

namespace ecods::bench {

namespace {

using scenes::CastQuery;
using scenes::CastWorkload;

struct CastErrors : Errors {          // no contact reported where there is one, and the other way round
    std::vector<double> time_errors;  // absolute, where there is one and it is reported
    std::size_t wrong = 0;
};

std::optional<oracle::ExactContact> ask_oracle(const CastWorkload& workload, const CastQuery& query) {
    const auto soup = [&](const scenes::MeshAt& at) {
        const Mesh& mesh = *workload.meshes[at.mesh_index].mesh;
        return oracle::Soup{mesh.vertices(), mesh.triangles(), at.pose};
    };
    if (workload.is_translation) return oracle::first_contact(soup(query.a), query.motion, soup(query.b));
    return oracle::first_contact({soup(query.a), query.a_end}, {soup(query.b), query.b.pose});
}

struct CastSuite {
    using Question = Casts;
    using Truth = std::optional<FirstContact>;
    using Errors = CastErrors;

    // The oracle asks every pair of triangles whose boxes on the way overlap.
    static std::size_t judged_count(const CastWorkload& workload, const SuiteOptions& options) {
        if (options.is_quick()) return 1;
        const std::size_t triangles = triangle_count(workload.meshes);
        return triangles <= 2000 ? 4 : triangles <= 20000 ? 1 : 0;
    }

    static Truths<Truth> find_truths(const CastWorkload& workload, std::size_t judged_count) {
        OwnCasts own(workload);
        return bench::find_truths<Truth>(
            workload.queries, judged_count, [&](const CastQuery& query, std::size_t) { return own(query); },
            [&](const CastQuery& query) { return judge::to_first_contact(ask_oracle(workload, query)); },
            [](const Truth& x, const Truth& y) { return judge::is_same(x, y); });
    }

    static CastErrors errors_of(const Run<Casts>& run, const CastWorkload& /*workload*/, const Truths<Truth>& truths) {
        CastErrors errors;
        if (run.maker->traits.answer != CastAnswer::time) return errors;
        for (std::size_t i = 0; i < run.answers.size(); ++i) {
            const bool is_reported = !std::isnan(run.answers[i]);
            const Truth& contact = truths.answers[i];
            errors.false_positives += is_reported && !contact;
            errors.false_negatives += !is_reported && contact;
            errors.wrong += is_reported != contact.has_value() || (contact && run.answers[i] != contact->time);
            if (is_reported && contact) errors.time_errors.push_back(std::abs(run.answers[i] - contact->time));
        }
        return errors;
    }

    static std::vector<std::string> cells(const Measured<CastSuite>& measured, std::size_t i) {
        const Run<Casts>& run = measured.runs[i];
        const CastErrors& errors = measured.errors[i];
        std::vector<std::string> cells = {ratio_text(times_as_fast(run.us, measured.us_of(cast_yardstick))),
                                          share_text(run.us, measured.us_of(own_end_distance))};
        if (run.maker->traits.answer != CastAnswer::time) return cells;
        const auto contact_count = std::ranges::count_if(measured.truths.answers, &Truth::has_value);
        const auto of_times = median_and_most(errors.time_errors, error_text);
        cells.insert(cells.end(),
                     {fmt::format("{} / {}", contact_count, run.answers.size()),
                      fmt::format("{}", errors.false_negatives), fmt::format("{}", errors.false_positives), of_times[0],
                      of_times[1], measured.wrong_text(i), fmt::format("{}", measured.truths.judged_count)});
        return cells;
    }

    static std::optional<double> error(const Measured<CastSuite>& measured, std::size_t i) {
        const Run<Casts>& run = measured.runs[i];
        if (run.maker->traits.answer != CastAnswer::time) return std::nullopt;
        return static_cast<double>(measured.errors[i].count()) / static_cast<double>(run.answers.size());
    }
};

Table cast_table(const std::string& title, std::size_t repetition_count, const std::vector<std::string>& more_notes) {
    std::vector<std::string> notes = {fmt::format(
        "Times FCL: how many times as fast as {}, in the same repetition. Of a distance: time over that of ECoDS's "
        "distance of the two bodies at the end of the motion. Advancement is not asked of meshes of which it would "
        "take "
        "minutes.",
        cast_yardstick)};
    notes.insert(notes.end(), more_notes.begin(), more_notes.end());
    return timed_table(title,
                       {"times FCL", "of a distance", "contacts", "false -", "false +", "median error", "most error",
                        "wrong", "judged"},
                       repetition_count, notes);
}

Table slide_table(std::size_t repetition_count) {
    return cast_table(
        "One mesh is translated: when does it first meet the other?", repetition_count,
        {"False: no contact reported, though the closed bodies meet on the way, and a contact reported where they do "
         "not. Errors: of the time, from 0 to 1, where contact is there and reported. Wrong: answers of ECoDS that "
         "are not the true time, rounded once.",
         "Judged: so many of the first contacts, features included, are the oracle's; the others are those of ECoDS. "
         "Bullet sweeps solid convex hulls: here of bodies whose surface is that of their hull, and which start "
         "apart."});
}

Table turn_table(std::size_t repetition_count) {
    return cast_table(
        "One mesh goes from one pose to another", repetition_count,
        {"ECoDS moves each point on a straight line. FCL interpolates: it turns the body about an axis while its "
         "origin goes straight, which for the tenth of a radian here is another motion, by about 1e-3 of the "
         "diameter in the middle. So its times differ by about as much where nothing is wrong; what counts is where "
         "it reports no contact, of bodies that end a twentieth of the diameter within each other.",
         "Judged: as above."});
}

Section cast_chart(const std::vector<Measured<CastSuite>>& all) {
    std::vector<Measured<CastSuite>> translated;
    std::ranges::copy_if(all, std::back_inserter(translated),
                         [](const auto& measured) { return measured.workload.is_translation; });
    return {"Casts: speed against error",
            {"Each engine is a point for each workload: time per motion across; up the share of motions of which it "
             "says wrongly whether there is contact. The line at 0 is no error at all."},
            {},
            {},
            {error_chart("cast-errors", panels_of("us per motion", translated),
                         "Speed against error of casts. The better engine is lower and further left.")}};
}

}  // namespace

SuiteResult run_two_body_casts(const SuiteOptions& options) {
    const std::vector<CastMaker> makers = options.wanted(cast_engines());
    SuiteResult result;
    if (makers.empty()) return result;
    const std::vector<CastWorkload> workloads = scenes::cast_workloads(options.workload_size());
    Table slides = slide_table(options.repetition_count), turns = turn_table(options.repetition_count);
    const auto all = measure_all<CastSuite>(
        workloads, makers, options, "casts",
        [&](const CastWorkload& workload) { return workload.is_translation ? &slides : &turns; }, result);
    print(slides);
    print(turns);
    if (options.has_pictures) result.sections.push_back(cast_chart(all));
    result.sections.push_back(
        {"Casts of two meshes",
         {},
         {slides, turns, use_table("How each engine is asked for casts", makers, poses_are_timed)},
         {}});
    return result;
}

}  // namespace ecods::bench
