// Two convex solids: how far are they from each other, and how deep in each other? And a thousand that move in a box.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ecods/solid.hpp"
#include "engines/convex_engine.hpp"
#include "oracle/convex.hpp"
#include "suites/comparison.hpp"
#include "suites/parts.hpp"
#include "suites/query_suite.hpp"

namespace ecods::bench {

namespace {

using scenes::ConvexQuestion;
using scenes::ConvexWorkload;
using scenes::MeshQuery;

struct ConvexErrors {
    std::size_t contradicted = 0;    // said to meet where apart, or apart where they meet
    std::size_t off = 0;             // of the rest, by more than a hundredth of the true number
    std::size_t bad_directions = 0;  // of depths: along them, a hundredth more than the true depth does not part them
    double median = 0, most = 0;     // of what is not contradicted: absolute errors
    std::size_t wrong = 0;           // whatever is not the true number, rounded once
};

ConvexAnswer ask_oracle(const ConvexWorkload& workload, const MeshQuery& query) {
    const auto mesh = [&](const scenes::MeshAt& at) -> const Mesh& { return *workload.meshes[at.mesh_index].mesh; };
    const oracle::ConvexPair pair(mesh(query.a), query.a.pose, mesh(query.b), query.b.pose);
    if (workload.question == ConvexQuestion::distance) return {oracle::nearest(pair.distance())};
    const auto depth = pair.depth();
    if (!depth) return {std::numeric_limits<double>::quiet_NaN()};
    const Vec3 normal = depth->normal.nearest();
    return {oracle::nearest(depth->depth), {normal.x(), normal.y(), normal.z()}};
}

// Decided exactly, of the sum that is the pose.
bool parts(const ConvexWorkload& workload, const MeshQuery& query, const Vec3& way) {
    const Solid a(workload.meshes[query.a.mesh_index].mesh), b(workload.meshes[query.b.mesh_index].mesh);
    QueryMemory memory;
    const Pose moved{query.b.pose.R, query.b.pose.t + way};
    if (!moved.t.allFinite()) return false;
    const Relation relation = ecods::relation({a, query.a.pose}, {b, moved}, memory);
    return relation == Relation::apart || relation == Relation::touching;
}

constexpr const char* errors_note =
    "Errors: absolute, of a size of about 1, where what is said is not contradicted by the truth. Wrong: answers of "
    "ECoDS that are not the true number, rounded once. Judged: so many of the true numbers are the oracle's, which "
    "tries every normal in rationals; the others are those of ECoDS.";

struct ConvexSuite {
    using Question = Convex;
    using Truth = ConvexAnswer;
    using Errors = ConvexErrors;

    // The oracle needs up to a tenth of a second for a pair of hulls.
    static std::size_t judged_count(const ConvexWorkload& /*workload*/, const SuiteOptions& options) {
        return options.is_quick() ? 1 : 30;
    }

    static Truths<ConvexAnswer> find_truths(const ConvexWorkload& workload, std::size_t judged_count) {
        const auto own = ecods_convex(workload.question).front().set_up(workload);
        return bench::find_truths<ConvexAnswer>(
            workload.queries, judged_count, [&](const MeshQuery& query, std::size_t i) { return own->ask(query, i); },
            [&](const MeshQuery& query) { return ask_oracle(workload, query); });
    }

    static ConvexErrors errors_of(const Run<Convex>& run, const ConvexWorkload& workload,
                                  const Truths<ConvexAnswer>& truths) {
        const bool is_depth = workload.question == ConvexQuestion::depth;
        ConvexErrors errors;
        std::vector<double> sizes;
        for (std::size_t i = 0; i < run.answers.size(); ++i) {
            const auto& [number, direction] = run.answers[i];
            const double exact = truths.answers[i].number;
            const bool is_said_to_meet = is_depth ? !std::isnan(number) : !(number > 0);
            if (number != exact) ++errors.wrong;
            if (is_said_to_meet != is_depth) {
                ++errors.contradicted;
                continue;
            }
            sizes.push_back(std::abs(number - exact));
            if (!(sizes.back() <= exact / 100)) ++errors.off;
            if (!is_depth) continue;
            const Vec3 along(direction[0], direction[1], direction[2]);
            if (!parts(workload, workload.queries[i], along * (1.01 * exact / along.norm()))) ++errors.bad_directions;
        }
        errors.median = median(sizes);
        if (!sizes.empty()) errors.most = *std::ranges::max_element(sizes);
        return errors;
    }

    static std::vector<std::string> cells(const Measured<ConvexSuite>& measured, std::size_t i) {
        const bool is_depth = measured.workload.question == ConvexQuestion::depth;
        const ConvexErrors& errors = measured.errors[i];
        std::vector<std::string> cells;
        const auto times = [&](const char* yardstick) {
            cells.push_back(ratio_text(times_as_fast(measured.runs[i].us, measured.us_of(yardstick))));
        };
        times(is_depth ? convex_depth_yardstick : convex_distance_yardstick);
        if (is_depth) times(convex_second_yardstick);
        cells.push_back(fmt::format("{}", errors.contradicted));
        cells.push_back(fmt::format("{}", errors.off));
        if (is_depth) cells.push_back(fmt::format("{}", errors.bad_directions));
        cells.insert(cells.end(),
                     {error_text(errors.median), error_text(errors.most), measured.wrong_text(i),
                      fmt::format("{} / {}", measured.truths.judged_count, measured.truths.answers.size())});
        return cells;
    }

    static std::optional<double> error(const Measured<ConvexSuite>& measured, std::size_t i) {
        return static_cast<double>(measured.errors[i].contradicted + measured.errors[i].off) /
               static_cast<double>(measured.truths.answers.size());
    }

    static Table table(ConvexQuestion question, std::size_t repetition_count) {
        if (question == ConvexQuestion::depth)
            return timed_table(
                "Two convex solids that overlap: how deep?",
                {"times libccd", "times Bullet", "said apart", "off by 1 %", "bad way", "median error", "most error",
                 "wrong", "judged"},
                repetition_count,
                {fmt::format("Times libccd, times Bullet: how many times as fast as {} and {}, in the same "
                             "repetition. Bad way: moved along the direction given, by 1.01 of the true "
                             "depth, b still overlaps a.",
                             convex_depth_yardstick, convex_second_yardstick),
                 errors_note});
        return timed_table(
            "Two convex solids that are apart: how far?",
            {"times FCL", "said to meet", "off by 1 %", "median error", "most error", "wrong", "judged"},
            repetition_count,
            {fmt::format("Times FCL: how many times as fast as {}, in the same repetition.", convex_distance_yardstick),
             errors_note});
    }
};

struct Part {
    ConvexQuestion question;
    const char* title;
    const char* picture;
};

void measure_part(const Part& part, std::vector<ConvexWorkload> workloads, const SuiteOptions& options,
                  SuiteResult& result) {
    const std::vector<ConvexMaker> makers = options.wanted(convex_engines(part.question));
    if (makers.empty()) return;
    std::erase_if(workloads, [&](const ConvexWorkload& workload) { return workload.question != part.question; });
    Table table = ConvexSuite::table(part.question, options.repetition_count);
    const auto all = measure_all<ConvexSuite>(
        workloads, makers, options, part.picture, [&](const ConvexWorkload&) { return &table; }, result);
    print(table);
    Section section{part.title, {}, {table, use_table("How each engine is asked", makers, poses_are_timed)}, {}};
    if (options.has_pictures)
        section.charts.push_back(error_chart(
            part.picture, panels_of("us per query", all),
            "Speed against error. Up: the share of pairs that are wrongly said to meet or to be apart, or of which the "
            "number is off by more than a hundredth. The better engine is lower and further left."));
    result.sections.push_back(std::move(section));
}

}  // namespace

SuiteResult run_convex(const SuiteOptions& options) {
    SuiteResult result;
    const std::vector<ConvexWorkload> workloads = scenes::convex_workloads(options.workload_size());
    for (const Part& part : {Part{ConvexQuestion::distance, "Distances of convex solids", "convex-distances"},
                             Part{ConvexQuestion::depth, "Depths of convex solids", "convex-depths"}})
        measure_part(part, workloads, options, result);
    if (const auto frames = convex_frames_table(options, result.is_right)) {
        print(*frames);
        result.sections.push_back({"Convex solids that move in a box", {}, {*frames}, {}});
    }
    return result;
}

}  // namespace ecods::bench
