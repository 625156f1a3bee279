#include "suites/broad_measure.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>

#include "harness/contained.hpp"
#include "harness/stopwatch.hpp"
#include "oracle/oracle.hpp"

namespace ecods::bench {

namespace {

constexpr std::chrono::seconds turn_limit{300};

std::size_t count_difference(const std::vector<ProxyPair>& from, const std::vector<ProxyPair>& what) {
    std::vector<ProxyPair> difference;
    std::set_difference(from.begin(), from.end(), what.begin(), what.end(), std::back_inserter(difference));
    return difference.size();
}

// Frames that are not timed: trees that are improved little by little, and lists that are kept, are not new any more.
std::size_t warm_up_count(const scenes::MovingBoxes& boxes) {
    return boxes.frames.size() / 3;
}

// Values of a turn: nanoseconds of the timed frames, missed, invented.
Contained::Run start_frames(const BroadMaker& maker, const scenes::MovingBoxes& boxes, const BroadTruth& truth) {
    return [&maker, &boxes, &truth, is_first = true]() mutable -> std::vector<double> {
        std::unique_ptr<BroadEngine> engine = maker.set_up(boxes);
        engine->run_frame({});
        double ns = 0;
        std::size_t missed = 0, invented = 0;
        auto expected = truth.frames.begin();
        for (std::size_t frame = 0; frame < boxes.frames.size(); ++frame) {
            const Stopwatch watch;
            engine->run_frame(boxes.frames[frame]);
            if (frame >= warm_up_count(boxes)) ns += watch.nanoseconds();
            if (!is_first || expected == truth.frames.end() || expected->first != frame) continue;
            std::vector<ProxyPair> pairs(engine->pairs().begin(), engine->pairs().end());
            std::sort(pairs.begin(), pairs.end());
            missed += count_difference(expected->second, pairs);
            invented += count_difference(pairs, expected->second);
            ++expected;
        }
        is_first = false;
        return {ns, static_cast<double>(missed), static_cast<double>(invented)};
    };
}

std::vector<ProxyPair> exact_pairs(std::span<const Aabb> boxes) {
    if (boxes.size() > 10000) return overlapping_pairs_by_cgal(boxes);
    std::vector<ProxyPair> pairs;
    for (const auto& [a, b] : oracle::overlapping_boxes(boxes))
        pairs.push_back({static_cast<ProxyIndex>(a), static_cast<ProxyIndex>(b)});
    return pairs;
}

}  // namespace

BroadTruth find_pairs(const scenes::MovingBoxes& boxes) {
    BroadTruth truth;
    std::vector<Aabb> now = boxes.boxes;
    const std::size_t last = boxes.frames.size() - 1;
    for (std::size_t frame = 0; frame <= last; ++frame) {
        for (const scenes::BoxMove& move : boxes.frames[frame]) now[move.index] = move.box;
        if (frame != 0 && frame != last / 2 && frame != last) continue;
        truth.frames.emplace_back(frame, exact_pairs(now));
        truth.pair_count += static_cast<double>(truth.frames.back().second.size());
    }
    truth.pair_count /= static_cast<double>(truth.frames.size());
    return truth;
}

std::vector<BroadRun> measure_broad(const scenes::MovingBoxes& boxes, const BroadTruth& truth,
                                    std::span<const BroadMaker> makers, std::size_t repetition_count) {
    std::vector<Contained> children;
    children.reserve(makers.size());
    std::vector<BroadRun> runs(makers.size());
    for (std::size_t i = 0; i < makers.size(); ++i) {
        runs[i].name = makers[i].name;
        runs[i].is_ecods = makers[i].is_ecods;
        children.emplace_back([&, i] { return start_frames(makers[i], boxes, truth); }, turn_limit);
    }
    const auto steps = static_cast<double>(boxes.boxes.size() * (boxes.frames.size() - warm_up_count(boxes)));
    for (std::size_t repetition = 0; repetition < repetition_count; ++repetition) {
        for (std::size_t i = 0; i < makers.size(); ++i) {
            const Outcome outcome = children[i].run();
            runs[i].failure = outcome.failure;
            if (!outcome.is_right()) continue;
            runs[i].ns.push_back(outcome.values[0] / steps);
            if (repetition == 0) {
                runs[i].missed = static_cast<std::size_t>(outcome.values[1]);
                runs[i].invented = static_cast<std::size_t>(outcome.values[2]);
            }
        }
    }
    return runs;
}

}  // namespace ecods::bench
