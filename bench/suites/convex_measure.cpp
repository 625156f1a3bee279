#include "suites/convex_measure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "ecods/solid.hpp"
#include "harness/statistics.hpp"
#include "harness/turns.hpp"
#include "oracle/convex.hpp"
#include "process/contained.hpp"

namespace ecods::bench {

namespace {

using scenes::ConvexQuestion;

constexpr std::chrono::seconds turn_limit{300};
constexpr std::size_t numbers_an_answer = 4;

// A turn: all queries once, untimed, then in timed passes. Values: microseconds a pass, then the answers.
process::Contained::Run start_queries(const ConvexMaker& maker, const scenes::ConvexWorkload& workload) {
    std::shared_ptr<ConvexEngine> engine = maker.set_up(workload);
    return [engine, &workload, is_first = true]() mutable {
        const auto& queries = workload.pairs.queries;
        std::vector<ConvexAnswer> answers(queries.size());
        const auto ask_all = [&] {
            for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = engine->ask(queries[i], i);
        };
        ask_all();
        std::vector<double> values = {std::exchange(is_first, false) ? 0 : microseconds_a_pass(ask_all)};
        for (const auto& [number, direction] : answers)
            values.insert(values.end(), {number, direction.x(), direction.y(), direction.z()});
        return values;
    };
}

ConvexAnswer ask_oracle(const scenes::ConvexWorkload& workload, const scenes::MeshQuery& query) {
    const auto mesh = [&](const scenes::MeshAt& at) -> const Mesh& {
        return *workload.pairs.meshes[at.mesh_index].mesh;
    };
    const oracle::ConvexPair pair(mesh(query.a), query.a.pose, mesh(query.b), query.b.pose);
    if (workload.question == ConvexQuestion::distance) return {oracle::nearest(pair.distance())};
    const auto depth = pair.depth();
    if (!depth) return {std::numeric_limits<double>::quiet_NaN()};
    return {oracle::nearest(depth->depth), depth->normal.nearest()};
}

// Decided exactly, of the sum that is the pose.
bool parts(const scenes::ConvexWorkload& workload, const scenes::MeshQuery& query, const Vec3& way) {
    const Solid a(workload.pairs.meshes[query.a.mesh_index].mesh), b(workload.pairs.meshes[query.b.mesh_index].mesh);
    QueryMemory memory;
    const Pose moved{query.b.pose.R, query.b.pose.t + way};
    if (!moved.t.allFinite()) return false;
    const SolidRelation relation = solid_relation({a, query.a.pose}, {b, moved}, memory);
    return relation == SolidRelation::apart || relation == SolidRelation::touching;
}

bool is_said_to_meet(const scenes::ConvexWorkload& workload, double number) {
    return workload.question == ConvexQuestion::depth ? !std::isnan(number) : !(number > 0);
}

}  // namespace

ConvexTruth find_convex_truth(const scenes::ConvexWorkload& workload, std::size_t judged_count) {
    const std::unique_ptr<ConvexEngine> own = set_up_convex_ecods(workload);
    const auto& queries = workload.pairs.queries;
    ConvexTruth truth;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const ConvexAnswer answer = own->ask(queries[i], i);
        double number = answer.number;
        if (is_chosen(i, queries.size(), std::min(judged_count, queries.size()))) {
            ++truth.judged_count;
            const ConvexAnswer exact = ask_oracle(workload, queries[i]);
            if (number != exact.number || answer.direction != exact.direction) ++truth.wrong_count;
            number = exact.number;
        }
        truth.numbers.push_back(number);
    }
    return truth;
}

std::vector<ConvexRun> measure_convex(const scenes::ConvexWorkload& workload, std::span<const ConvexMaker> makers,
                                      std::size_t repetition_count) {
    std::vector<ConvexRun> runs;
    std::vector<process::Contained> children;
    children.reserve(makers.size());
    for (const ConvexMaker& maker : makers) {
        runs.push_back({&maker, {}, {}, {}});
        children.emplace_back([&maker, &workload] { return start_queries(maker, workload); }, turn_limit);
    }
    const std::size_t count = workload.pairs.queries.size();
    take_turns(children, repetition_count, [&](std::size_t i, std::size_t repetition, const process::Outcome& outcome) {
        runs[i].failure = outcome.failure;
        if (!outcome.is_right()) return;
        if (repetition > 0) runs[i].us.push_back(outcome.values[0] / static_cast<double>(count));
        runs[i].answers.clear();
        for (std::size_t k = 1; k < outcome.values.size(); k += numbers_an_answer) {
            const double* values = &outcome.values[k];
            runs[i].answers.push_back({values[0], {values[1], values[2], values[3]}});
        }
    });
    return runs;
}

ConvexErrors errors_of(const ConvexRun& run, const scenes::ConvexWorkload& workload, const ConvexTruth& truth) {
    const bool is_depth = workload.question == ConvexQuestion::depth;
    ConvexErrors errors;
    std::vector<double> sizes;
    for (std::size_t i = 0; i < run.answers.size(); ++i) {
        const double number = run.answers[i].number, exact = truth.numbers[i];
        if (run.maker->is_ecods && number != exact) ++errors.wrong;
        if (is_said_to_meet(workload, number) != is_depth) {
            ++errors.contradicted;
            continue;
        }
        sizes.push_back(std::abs(number - exact));
        if (!(sizes.back() <= exact / 100)) ++errors.off;
        if (!is_depth) continue;
        const Vec3 way = run.answers[i].direction * (1.01 * exact / run.answers[i].direction.norm());
        if (!parts(workload, workload.pairs.queries[i], way)) ++errors.bad_directions;
    }
    errors.median = median(sizes);
    if (!sizes.empty()) errors.most = *std::ranges::max_element(sizes);
    return errors;
}

}  // namespace ecods::bench
