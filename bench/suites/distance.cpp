// Two meshes: how far are they from each other? Microseconds per query, and errors in units in the last place.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engines/distance_engine.hpp"
#include "oracle/distance.hpp"
#include "suites/comparison.hpp"
#include "suites/parts.hpp"
#include "suites/query_suite.hpp"

namespace ecods::bench {

namespace {

using scenes::DistanceWorkload;
using scenes::MeshQuery;

// Errors in units in the last place of the true distances, where bodies are apart. An answer of 0 there is counted by
// itself.
struct DistanceErrors {
    std::vector<double> ulps;
    std::size_t false_zeros = 0;
    std::size_t wrong = 0;
};

bool is_wrong(const Distance::Traits& traits, double answer, double d) {
    switch (traits.answer) {
        case DistanceAnswer::within:
            return (answer != 0) != (traits.factor >= 1);
        case DistanceAnswer::bounds:
            return std::isnan(answer);
        default:
            return answer != d;
    }
}

struct DistanceSuite {
    using Question = Distance;
    using Truth = double;
    using Errors = DistanceErrors;

    // The oracle needs milliseconds for a ship, half a second for a hundred thousand triangles.
    static std::size_t judged_count(const DistanceWorkload& workload, const SuiteOptions& options) {
        const std::size_t triangles = triangle_count(workload.meshes);
        if (options.is_quick()) return 3;
        return triangles <= 2000 ? workload.queries.size() : triangles <= 20000 ? 20 : 4;
    }

    static Truths<double> find_truths(const DistanceWorkload& workload, std::size_t judged_count) {
        const auto own = ecods_distance().front().set_up(workload);
        const auto soup = [&](const scenes::MeshAt& at) {
            const Mesh& mesh = *workload.meshes[at.mesh_index].mesh;
            return oracle::Soup{mesh.vertices(), mesh.triangles(), at.pose};
        };
        return bench::find_truths<double>(
            workload.queries, judged_count, [&](const MeshQuery& query, std::size_t i) { return own->ask(query, i); },
            [&](const MeshQuery& query) {
                return oracle::nearest(oracle::MeshDistances(soup(query.a), soup(query.b)).distance());
            });
    }

    static DistanceErrors errors_of(const Run<Distance>& run, const DistanceWorkload& /*workload*/,
                                    const Truths<double>& truths) {
        DistanceErrors errors;
        for (std::size_t i = 0; i < run.answers.size(); ++i) {
            const double d = truths.answers[i], answer = run.answers[i];
            if (run.maker->is_ecods && is_wrong(run.maker->traits, answer, d)) ++errors.wrong;
            if (run.maker->traits.answer == DistanceAnswer::within || d == 0) continue;
            if (!(answer > 0)) {
                ++errors.false_zeros;
            } else {
                const double ulp = std::nextafter(d, std::numeric_limits<double>::infinity()) - d;
                errors.ulps.push_back(std::abs(answer - d) / ulp);
            }
        }
        return errors;
    }

    static std::vector<std::string> cells(const Measured<DistanceSuite>& measured, std::size_t i) {
        const Run<Distance>& run = measured.runs[i];
        const auto ulps = median_and_most(measured.errors[i].ulps, [](double value) {
            return value < 1e6 ? fmt::format("{:.4g}", value) : fmt::format("{:.1e}", value);
        });
        return {ratio_text(times_as_fast(run.us, measured.us_of(distance_yardstick))),
                share_text(run.us, measured.us_of(own_distance)),
                ulps[0],
                ulps[1],
                fmt::format("{}", measured.errors[i].false_zeros),
                measured.wrong_text(i),
                fmt::format("{} / {}", measured.truths.judged_count, measured.truths.answers.size())};
    }

    // The engines that answer with a number.
    static std::optional<double> error(const Measured<DistanceSuite>& measured, std::size_t i) {
        const std::vector<double>& ulps = measured.errors[i].ulps;
        return ulps.empty() ? std::nullopt : std::optional(median(ulps));
    }

    static Table table(std::size_t repetition_count) {
        return timed_table(
            "Two meshes: how far are they from each other?",
            {"times FCL", "of a distance", "median ulps", "most ulps", "false zeros", "wrong", "judged"},
            repetition_count,
            {fmt::format(
                 "Times FCL: how many times as fast as {}, in the same repetition. Of a distance: time over that of "
                 "ECoDS's distance.",
                 distance_yardstick),
             "Ulps: errors in units in the last place of the true distance, where bodies are apart; 0 where they are "
             "apart "
             "is counted as false zero. Of bounds: the upper end. Wrong: answers of ECoDS that are not the true ones, "
             "rounded once, or do not contain them.",
             "Judged: so many of the true distances are the oracle's; the others are those of ECoDS. Bullet's meshes "
             "and "
             "CGAL's trees answer distances of points alone."});
    }
};

}  // namespace

SuiteResult run_distance(const SuiteOptions& options) {
    const std::vector<DistanceMaker> makers = options.wanted(distance_engines());
    SuiteResult result;
    const std::vector<DistanceWorkload> workloads = scenes::distance_workloads(options.workload_size());
    Table table = DistanceSuite::table(options.repetition_count);
    const auto all = measure_all<DistanceSuite>(
        workloads, makers, options, "distance", [&](const DistanceWorkload&) { return &table; }, result);
    print(table);
    if (options.has_pictures) {
        result.sections.push_back(
            {"Distances: speed against error",
             {"Each engine is a point for each workload: time per query across; up the median of its errors, in units "
              "in the last place of the true distance. The line at 0 is no error at all: rounded once."},
             {},
             {},
             {error_chart("distance-errors", panels_of("us per query", all, ErrorScale::ulps),
                          "Speed against error of distances. The better engine is lower and further left.")}});
    }
    result.sections.push_back({"Distances of two meshes",
                               {},
                               {table, use_table("How each engine is asked for distances", makers, poses_are_timed)},
                               {}});
    const Table clearance = clearance_table(options, result.is_right);
    print(clearance);
    result.sections.push_back({"Pairs within a clearance", {}, {clearance}, {}});
    return result;
}

}  // namespace ecods::bench
