#include "suites/hit_measure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

#include "harness/turns.hpp"

namespace ecods::bench {

namespace {

constexpr std::chrono::seconds turn_limit{300};

// A turn: all segments once, untimed, then in timed passes. Values: microseconds a pass, then parameter and triangle of
// each answer.
process::Contained::Run start_first_hits(const HitMaker& maker, const scenes::SegmentWorkload& workload) {
    std::shared_ptr<HitEngine> engine = maker.set_up(workload);
    return [engine, &workload, is_first = true]() mutable {
        std::vector<HitAnswer> answers(workload.segments.size());
        const auto ask_all = [&] { engine->first_hits(workload.segments, answers); };
        ask_all();
        std::vector<double> values = {std::exchange(is_first, false) ? 0 : microseconds_a_pass(ask_all)};
        for (const HitAnswer& answer : answers) {
            values.push_back(answer.parameter);
            values.push_back(answer.triangle);
        }
        return values;
    };
}

std::vector<std::uint32_t> triangles_of(const std::vector<Hit>& hits) {
    std::vector<std::uint32_t> triangles;
    for (const Hit& hit : hits) triangles.push_back(hit.triangle());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

template <class List>
double difference_count(const List& from, const List& what) {
    List difference;
    std::set_difference(from.begin(), from.end(), what.begin(), what.end(), std::back_inserter(difference));
    return static_cast<double>(difference.size());
}

// A turn: all lists. Values: microseconds a pass, hits, false negatives, false positives.
process::Contained::Run start_lists(const HitMaker& maker, const scenes::SegmentWorkload& workload,
                                    const HitTruth& truth) {
    std::shared_ptr<HitEngine> engine = maker.set_up(workload);
    return [engine, &workload, &truth, is_first = true]() mutable {
        std::vector<double> values(4);
        std::vector<std::uint32_t> list;
        for (std::size_t i = 0; i < workload.segments.size(); ++i) {
            engine->all_hits(workload.segments[i], list);
            std::sort(list.begin(), list.end());
            const std::vector<std::uint32_t> expected = triangles_of(truth.lists[i]);
            values[1] += static_cast<double>(list.size());
            values[2] += difference_count(expected, list);
            values[3] += difference_count(list, expected);
        }
        if (!std::exchange(is_first, false)) {
            values[0] = microseconds_a_pass([&] {
                for (const Segment& segment : workload.segments) engine->all_hits(segment, list);
            });
        }
        return values;
    };
}

bool is_asked(const HitMaker& maker, const scenes::SegmentWorkload& workload) {
    const HitBodies bodies = workload.bodies.size() == 1 ? HitBodies::one : HitBodies::many;
    return (workload.is_path || !maker.is_for_paths) && (maker.bodies == HitBodies::any || maker.bodies == bodies);
}

}  // namespace

std::vector<HitRun> measure_hits(const scenes::SegmentWorkload& workload, std::span<const HitMaker> makers,
                                 std::size_t repetition_count) {
    std::vector<HitRun> runs;
    std::vector<process::Contained> children;
    children.reserve(makers.size());
    for (const HitMaker& maker : makers) {
        if (!is_asked(maker, workload)) continue;
        runs.push_back({&maker, {}, {}, {}});
        children.emplace_back([&maker, &workload] { return start_first_hits(maker, workload); }, turn_limit);
    }
    take_turns(children, repetition_count, [&](std::size_t i, std::size_t repetition, const process::Outcome& outcome) {
        HitRun& run = runs[i];
        run.failure = outcome.failure;
        if (!outcome.is_right()) return;
        if (repetition > 0) run.us.push_back(outcome.values[0] / static_cast<double>(workload.segments.size()));
        run.answers.clear();
        for (std::size_t k = 1; k + 1 < outcome.values.size(); k += 2)
            run.answers.push_back({outcome.values[k], static_cast<std::uint32_t>(outcome.values[k + 1])});
    });
    return runs;
}

HitErrors errors_of(const HitRun& run, const HitTruth& truth) {
    HitErrors errors;
    for (std::size_t i = 0; i < run.answers.size(); ++i) {
        const HitAnswer& answer = run.answers[i];
        const std::vector<Hit>& list = truth.lists[i];
        const bool is_reported = !std::isnan(answer.parameter);
        if (list.empty() || !is_reported) {
            errors.false_positives += is_reported;
            errors.false_negatives += !list.empty();
            errors.wrong += is_reported || !list.empty();
            continue;
        }
        const Hit& first = list.front();
        errors.parameter_errors.push_back(std::abs(answer.parameter - first.parameter));
        errors.other_triangles += std::none_of(list.begin(), list.end(), [&](const Hit& hit) {
            return hit.rank == 0 && hit.triangle() == answer.triangle;
        });
        errors.wrong += answer.parameter != first.parameter || answer.triangle != first.triangle();
    }
    return errors;
}

std::vector<HitListRun> measure_hit_lists(const scenes::SegmentWorkload& workload, const HitTruth& truth,
                                          std::span<const HitMaker> makers, std::size_t repetition_count) {
    std::vector<HitListRun> runs;
    std::vector<process::Contained> children;
    children.reserve(makers.size());
    for (const HitMaker& maker : makers) {
        if (!maker.has_lists || !is_asked(maker, workload)) continue;
        runs.push_back({&maker, {}, 0, 0, 0, {}});
        children.emplace_back([&maker, &workload, &truth] { return start_lists(maker, workload, truth); }, turn_limit);
    }
    take_turns(children, repetition_count, [&](std::size_t i, std::size_t repetition, const process::Outcome& outcome) {
        HitListRun& run = runs[i];
        run.failure = outcome.failure;
        if (!outcome.is_right()) return;
        if (repetition > 0) run.us.push_back(outcome.values[0] / static_cast<double>(workload.segments.size()));
        run.hit_count = outcome.values[1];
        run.false_negatives = outcome.values[2];
        run.false_positives = outcome.values[3];
    });
    return runs;
}

}  // namespace ecods::bench
