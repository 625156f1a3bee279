#include "suites/distance_measure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include "ecods/distance.hpp"
#include "harness/turns.hpp"
#include "oracle/distance.hpp"

namespace ecods::bench {

namespace {

constexpr std::chrono::seconds turn_limit{300};

// A turn: all queries once, untimed, then in timed passes. Values: microseconds a pass, then the answers.
process::Contained::Run start_queries(const DistanceMaker& maker, const scenes::DistanceWorkload& workload,
                                      const DistanceTruth& truth) {
    std::shared_ptr<DistanceEngine> engine = maker.set_up(workload.pairs.meshes, maker.factor);
    return [engine, &workload, &truth, is_first = true]() mutable {
        const auto& queries = workload.pairs.queries;
        std::vector<double> values(1 + queries.size());
        const auto ask_all = [&] {
            for (std::size_t i = 0; i < queries.size(); ++i)
                values[1 + i] = engine->ask(queries[i], truth.distances[i]);
        };
        ask_all();
        if (std::exchange(is_first, false)) return values;
        values[0] = microseconds_a_pass(ask_all);
        return values;
    };
}

double ask_oracle(const scenes::MeshPairs& pairs, const scenes::MeshQuery& query) {
    const Mesh& a = *pairs.meshes[query.a.mesh_index].mesh;
    const Mesh& b = *pairs.meshes[query.b.mesh_index].mesh;
    const oracle::MeshDistances distances({a.vertices(), a.triangles(), query.a.pose},
                                          {b.vertices(), b.triangles(), query.b.pose});
    return oracle::nearest(distances.distance());
}

double unit_in_the_last_place(double d) {
    return std::nextafter(d, std::numeric_limits<double>::infinity()) - d;
}

bool is_wrong(const DistanceMaker& maker, double answer, double d) {
    switch (maker.answer) {
        case DistanceAnswer::within:
            return (answer != 0) != (maker.factor >= 1);
        case DistanceAnswer::bounds:
            return std::isnan(answer);
        default:
            return answer != d;
    }
}

}  // namespace

DistanceTruth find_distances(const scenes::DistanceWorkload& workload, std::size_t judged_count) {
    const scenes::MeshPairs& pairs = workload.pairs;
    std::deque<MeshShape> shapes;
    for (const scenes::NamedMesh& named : pairs.meshes) shapes.emplace_back(named.mesh);
    QueryMemory memory;
    DistanceTruth truth;
    for (std::size_t i = 0; i < pairs.queries.size(); ++i) {
        const auto& [a, b] = pairs.queries[i];
        double d = distance({shapes[a.mesh_index], a.pose}, {shapes[b.mesh_index], b.pose}, memory);
        if (is_chosen(i, pairs.queries.size(), std::min(judged_count, pairs.queries.size()))) {
            ++truth.judged_count;
            const double exact = ask_oracle(pairs, pairs.queries[i]);
            if (d != exact) ++truth.wrong_count;
            d = exact;
        }
        truth.distances.push_back(d);
    }
    return truth;
}

std::vector<DistanceRun> measure_distances(const scenes::DistanceWorkload& workload, const DistanceTruth& truth,
                                           std::span<const DistanceMaker> makers, std::size_t repetition_count) {
    std::vector<DistanceRun> runs;
    std::vector<process::Contained> children;
    children.reserve(makers.size());
    for (const DistanceMaker& maker : makers) {
        if (maker.is_for_paths && !workload.is_path) continue;
        runs.push_back({&maker, {}, {}, {}});
        children.emplace_back([&maker, &workload, &truth] { return start_queries(maker, workload, truth); },
                              turn_limit);
    }
    const auto query_count = static_cast<double>(workload.pairs.queries.size());
    take_turns(children, repetition_count, [&](std::size_t i, std::size_t repetition, const process::Outcome& outcome) {
        runs[i].failure = outcome.failure;
        if (!outcome.is_right()) return;
        if (repetition > 0) runs[i].us.push_back(outcome.values[0] / query_count);
        runs[i].answers.assign(outcome.values.begin() + 1, outcome.values.end());
    });
    return runs;
}

DistanceErrors errors_of(const DistanceRun& run, const DistanceTruth& truth) {
    DistanceErrors errors;
    for (std::size_t i = 0; i < run.answers.size(); ++i) {
        const double d = truth.distances[i], answer = run.answers[i];
        if (run.maker->is_ecods && is_wrong(*run.maker, answer, d)) ++errors.wrong;
        if (run.maker->answer == DistanceAnswer::within || d == 0) continue;
        if (!(answer > 0)) {
            ++errors.false_zeros;
        } else {
            errors.ulps.push_back(std::abs(answer - d) / unit_in_the_last_place(d));
        }
    }
    return errors;
}

}  // namespace ecods::bench
