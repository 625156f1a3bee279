#include "suites/narrow_measure.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <iterator>
#include <utility>

#include "ecods/intersection.hpp"
#include "harness/stopwatch.hpp"
#include "harness/turns.hpp"
#include "oracle/oracle.hpp"
#include "process/contained.hpp"

namespace ecods::bench {

namespace {

constexpr std::chrono::seconds turn_limit{120};

// A turn: all queries once, untimed, then in timed passes. Values: microseconds a pass, whether work was counted, box
// tests, triangle tests, then the answers.
constexpr std::size_t head_size = 4;

process::Contained::Run start_queries(const NarrowMaker& maker, const scenes::MeshPairs& workload) {
    std::shared_ptr<NarrowEngine> engine = maker.set_up(workload.meshes);
    return [engine, &workload, is_first = true]() mutable {
        std::vector<double> values(head_size + workload.queries.size());
        const auto ask_all = [&] {
            for (std::size_t i = 0; i < workload.queries.size(); ++i)
                values[head_size + i] = engine->query(workload.queries[i]) ? 1 : 0;
        };
        ask_all();
        if (!is_first) values[0] = microseconds_a_pass(ask_all);
        if (!std::exchange(is_first, false)) return values;
        for (const scenes::MeshQuery& query : workload.queries) {
            const std::optional<NarrowWork> work = engine->work(query);
            if (!work) break;
            values[1] = 1;
            values[2] += static_cast<double>(work->box_tests);
            values[3] += static_cast<double>(work->triangle_tests);
        }
        return values;
    };
}

// A turn: all lists. Values: microseconds, pairs, false negatives, false positives.
process::Contained::Run start_lists(const NarrowMaker& maker, const scenes::MeshPairs& workload, const Lists& truth) {
    std::shared_ptr<NarrowEngine> engine = maker.set_up(workload.meshes);
    return [engine, &workload, &truth]() {
        std::vector<double> values(4);
        std::vector<TrianglePair> list, difference;
        const auto count_difference = [&](const auto& from, const auto& what) {
            difference.clear();
            std::set_difference(from.begin(), from.end(), what.begin(), what.end(), std::back_inserter(difference));
            return static_cast<double>(difference.size());
        };
        for (std::size_t i = 0; i < workload.queries.size(); ++i) {
            const Stopwatch watch;
            engine->list(workload.queries[i], list);
            values[0] += watch.nanoseconds() / 1000;
            std::sort(list.begin(), list.end());
            values[1] += static_cast<double>(list.size());
            values[2] += count_difference(truth[i], list);
            values[3] += count_difference(list, truth[i]);
        }
        return values;
    };
}

std::deque<MeshShape> shapes_of(const scenes::MeshPairs& workload) {
    std::deque<MeshShape> shapes;
    for (const scenes::NamedMesh& named : workload.meshes) shapes.emplace_back(named.mesh);
    return shapes;
}

oracle::OracleMesh for_oracle(const scenes::MeshPairs& workload, const scenes::MeshAt& at) {
    return {workload.meshes[at.mesh_index].mesh, at.pose};
}

template <class Run>
std::vector<Run> name_runs(std::span<const NarrowMaker> makers) {
    std::vector<Run> runs(makers.size());
    for (std::size_t i = 0; i < makers.size(); ++i) {
        runs[i].name = makers[i].name;
        runs[i].is_ecods = makers[i].is_ecods;
    }
    return runs;
}

template <class Start>
std::vector<process::Contained> contain(std::span<const NarrowMaker> makers, const Start& start) {
    std::vector<process::Contained> children;
    children.reserve(makers.size());
    for (const NarrowMaker& maker : makers) children.emplace_back([&maker, start] { return start(maker); }, turn_limit);
    return children;
}

}  // namespace

std::vector<NarrowRun> measure_narrow(const scenes::MeshPairs& workload, std::span<const NarrowMaker> makers,
                                      std::size_t repetition_count) {
    const auto start = [&workload](const NarrowMaker& maker) { return start_queries(maker, workload); };
    std::vector<process::Contained> children = contain(makers, start);
    std::vector<NarrowRun> runs = name_runs<NarrowRun>(makers);
    for (std::size_t repetition = 0; repetition <= repetition_count; ++repetition) {
        for (std::size_t i = 0; i < makers.size(); ++i) {
            if (makers[i].is_slow && repetition > 1) continue;
            const process::Outcome outcome = children[i].run();
            NarrowRun& run = runs[i];
            run.failure = outcome.failure;
            if (!outcome.is_right()) continue;
            if (repetition > 0) {
                run.us.push_back(outcome.values[0] / static_cast<double>(workload.queries.size()));
                continue;
            }
            run.has_work = outcome.values[1] != 0;
            run.work = {static_cast<std::uint64_t>(outcome.values[2]), static_cast<std::uint64_t>(outcome.values[3])};
            for (std::size_t k = head_size; k < outcome.values.size(); ++k)
                run.answers.push_back(outcome.values[k] != 0);
        }
    }
    return runs;
}

std::vector<ListRun> measure_lists(const scenes::MeshPairs& workload, const Lists& truth,
                                   std::span<const NarrowMaker> makers, std::size_t repetition_count) {
    const auto start = [&](const NarrowMaker& maker) { return start_lists(maker, workload, truth); };
    std::vector<process::Contained> children = contain(makers, start);
    std::vector<ListRun> runs = name_runs<ListRun>(makers);
    take_turns(children, repetition_count, [&](std::size_t i, std::size_t repetition, const process::Outcome& outcome) {
        ListRun& run = runs[i];
        run.failure = outcome.failure;
        if (!outcome.is_right()) return;
        if (repetition > 0) run.us.push_back(outcome.values[0] / static_cast<double>(workload.queries.size()));
        run.pair_count = outcome.values[1];
        run.false_negatives = outcome.values[2];
        run.false_positives = outcome.values[3];
    });
    return runs;
}

NarrowTruth find_truth(const scenes::MeshPairs& workload, std::size_t judged_count) {
    const std::deque<MeshShape> shapes = shapes_of(workload);
    QueryMemory memory;
    NarrowTruth truth;
    for (std::size_t i = 0; i < workload.queries.size(); ++i) {
        const auto& [a, b] = workload.queries[i];
        bool answer = intersects({shapes[a.mesh_index], a.pose}, {shapes[b.mesh_index], b.pose}, memory);
        if (is_chosen(i, workload.queries.size(), std::min(judged_count, workload.queries.size()))) {
            ++truth.judged_count;
            const bool exact = oracle::intersects(for_oracle(workload, a), for_oracle(workload, b));
            if (answer != exact) ++truth.wrong_count;
            answer = exact;
        }
        truth.answers.push_back(answer);
    }
    return truth;
}

ListTruth find_lists(const scenes::MeshPairs& workload, std::size_t judged_count) {
    const std::deque<MeshShape> shapes = shapes_of(workload);
    QueryMemory memory;
    ListTruth truth;
    for (std::size_t i = 0; i < workload.queries.size(); ++i) {
        const auto& [a, b] = workload.queries[i];
        truth.lists.push_back(
            intersecting_triangles({shapes[a.mesh_index], a.pose}, {shapes[b.mesh_index], b.pose}, memory));
        if (!is_chosen(i, workload.queries.size(), std::min(judged_count, workload.queries.size()))) continue;
        ++truth.judged_count;
        auto exact = oracle::intersecting_triangles(for_oracle(workload, a), for_oracle(workload, b));
        if (exact != truth.lists.back()) ++truth.wrong_count;
        truth.lists.back() = std::move(exact);
    }
    return truth;
}

}  // namespace ecods::bench
