#include "suites/broad_measure.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>

#include "harness/stopwatch.hpp"
#include "harness/touch_pages.hpp"
#include "oracle/oracle.hpp"
#include "process/contained.hpp"

namespace ecods::bench {

namespace {

std::size_t count_difference(const std::vector<ProxyPair>& from, const std::vector<ProxyPair>& what) {
    std::vector<ProxyPair> difference;
    std::set_difference(from.begin(), from.end(), what.begin(), what.end(), std::back_inserter(difference));
    return difference.size();
}

std::vector<ProxyPair> exact_pairs(std::span<const Aabb> boxes) {
    if (boxes.size() > 10000) return overlapping_pairs_by_cgal(boxes);
    std::vector<ProxyPair> pairs;
    for (const auto& [a, b] : oracle::overlapping_boxes(boxes))
        pairs.push_back({static_cast<ProxyIndex>(a), static_cast<ProxyIndex>(b)});
    return pairs;
}

struct Plan {
    std::size_t frame_count = 0;
    double ns_max = std::numeric_limits<double>::infinity();
};

// A turn over the frames of one workload.
class Turn {
  public:
    Turn(const BroadMaker& maker, const scenes::MovingBoxes& boxes, const Plan& plan)
        : boxes_(boxes), plan_(plan), engine_(maker.set_up(boxes)) {
        engine_->run_frame({});
    }

    // Runs the next frame; false when it was the last.
    bool run_frame() {
        const std::span<const scenes::BoxMove> moves = boxes_.frames[frame_ns_.size()];
        touch_pages(moves);
        const Stopwatch watch;
        engine_->run_frame(moves);
        const double ns = watch.nanoseconds();
        ns_ += ns;
        frame_ns_.push_back(ns);
        return frame_ns_.size() < plan_.frame_count && !ends_early();
    }

    std::size_t frame() const { return frame_ns_.size() - 1; }  // that was run last
    bool ends_early() const {
        return ns_ > plan_.ns_max && frame_ns_.size() >= 3 && frame_ns_.size() < plan_.frame_count;
    }
    Plan same_again() const { return {.frame_count = frame_ns_.size()}; }
    const std::vector<double>& frame_ns() const { return frame_ns_; }

    std::vector<ProxyPair> pairs() const {
        std::vector<ProxyPair> pairs(engine_->pairs().begin(), engine_->pairs().end());
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

  private:
    const scenes::MovingBoxes& boxes_;
    Plan plan_;
    std::unique_ptr<BroadEngine> engine_;
    std::vector<double> frame_ns_;
    double ns_ = 0;
};

// Some frames first, untimed (harness/stopwatch.hpp says why).
void warm_up(const BroadMaker& maker, const scenes::MovingBoxes& boxes) {
    const std::unique_ptr<BroadEngine> engine = maker.set_up(boxes);
    engine->run_frame({});
    const Stopwatch watch;
    for (const std::vector<scenes::BoxMove>& moves : boxes.frames) {
        if (watch.nanoseconds() > warm_up_ns) break;
        engine->run_frame(moves);
    }
}

std::vector<Aabb> boxes_after(const scenes::MovingBoxes& boxes, std::size_t frame) {
    std::vector<Aabb> now = boxes.boxes;
    for (std::size_t f = 0; f <= frame; ++f)
        for (const scenes::BoxMove& move : boxes.frames[f]) now[move.index] = move.box;
    return now;
}

// Values of a turn: whether it ended early, false negatives, false positives, and the nanoseconds of each frame.
process::Contained::Run start_frames(const BroadMaker& maker, const scenes::MovingBoxes& boxes, const BroadTruth& truth,
                                     double seconds) {
    const Plan first{boxes.frames.size(), seconds * 1e9};
    return [&maker, &boxes, &truth, plan = first, is_first = true]() mutable -> std::vector<double> {
        warm_up(maker, boxes);
        Turn turn(maker, boxes, plan);
        std::size_t false_negatives = 0, false_positives = 0;
        const auto check = [&](const std::vector<ProxyPair>& expected) {
            const std::vector<ProxyPair> pairs = turn.pairs();
            false_negatives += count_difference(expected, pairs);
            false_positives += count_difference(pairs, expected);
        };
        auto expected = truth.frames.begin();
        for (bool goes_on = true; goes_on;) {
            goes_on = turn.run_frame();
            if (!is_first || expected == truth.frames.end()) continue;
            if (expected->first == turn.frame()) {
                check(expected->second);
                ++expected;
            } else if (!goes_on) {
                check(exact_pairs(boxes_after(boxes, turn.frame())));
            }
        }
        is_first = false;
        plan = turn.same_again();
        std::vector<double> values = {turn.ends_early() ? 1.0 : 0.0, static_cast<double>(false_negatives),
                                      static_cast<double>(false_positives)};
        values.insert(values.end(), turn.frame_ns().begin(), turn.frame_ns().end());
        return values;
    };
}

// Adds the times of one repetition.
void add_times(BroadRun& run, std::span<const double> frame_ns, double box_count) {
    double sum = 0;
    run.frame_count = frame_ns.size();
    run.frame_ns.resize(frame_ns.size(), std::numeric_limits<double>::infinity());
    for (std::size_t frame = 0; frame < frame_ns.size(); ++frame) {
        sum += frame_ns[frame];
        run.frame_ns[frame] = std::min(run.frame_ns[frame], frame_ns[frame] / box_count);
    }
    run.ns.push_back(sum / static_cast<double>(frame_ns.size()) / box_count);
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
                                    std::span<const BroadMaker> makers, const BroadEffort& effort) {
    std::vector<process::Contained> children;
    children.reserve(makers.size());
    std::vector<BroadRun> runs(makers.size());
    for (std::size_t i = 0; i < makers.size(); ++i) {
        runs[i].name = makers[i].name;
        runs[i].is_ecods = makers[i].is_ecods;
        const double seconds = makers[i].name == broad_yardstick ? 3 * effort.turn_seconds : effort.turn_seconds;
        children.emplace_back([&, i, seconds] { return start_frames(makers[i], boxes, truth, seconds); },
                              makers[i].limit);
    }
    std::vector<bool> is_done(makers.size(), false);
    for (std::size_t repetition = 0; repetition < effort.repetition_count; ++repetition) {
        for (std::size_t i = 0; i < makers.size(); ++i) {
            if (is_done[i]) continue;
            const process::Outcome outcome = children[i].run();
            runs[i].failure = outcome.failure;
            is_done[i] = !outcome.is_right() || (outcome.values[0] != 0 && makers[i].name != broad_yardstick);
            if (!outcome.is_right()) continue;
            const std::span<const double> values = outcome.values;
            add_times(runs[i], values.subspan(3), static_cast<double>(boxes.boxes.size()));
            if (repetition > 0) continue;
            runs[i].false_negatives = static_cast<std::size_t>(values[1]);
            runs[i].false_positives = static_cast<std::size_t>(values[2]);
        }
    }
    return runs;
}

}  // namespace ecods::bench
