#include "suites/broad_measure.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "harness/frame_runs.hpp"
#include "oracle/oracle.hpp"
#include "process/contained.hpp"

namespace ecods::bench {

namespace {

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
        frame_ns_.push_back(nanoseconds_of_frame(*engine_, std::span(boxes_.frames[frame_ns_.size()])));
        ns_ += frame_ns_.back();
        return frame_ns_.size() < plan_.frame_count && !ends_early();
    }

    std::size_t frame() const { return frame_ns_.size() - 1; }  // that was run last
    bool ends_early() const {
        return ns_ > plan_.ns_max && frame_ns_.size() >= 3 && frame_ns_.size() < plan_.frame_count;
    }
    Plan same_again() const { return {.frame_count = frame_ns_.size()}; }
    const std::vector<double>& frame_ns() const { return frame_ns_; }
    std::vector<ProxyPair> pairs() const { return ascending(engine_->pairs()); }

  private:
    const scenes::MovingBoxes& boxes_;
    Plan plan_;
    std::unique_ptr<BroadEngine> engine_;
    std::vector<double> frame_ns_;
    double ns_ = 0;
};

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
        Errors errors;
        auto expected = truth.frames.begin();
        for (bool goes_on = true; goes_on;) {
            goes_on = turn.run_frame();
            if (!is_first || expected == truth.frames.end()) continue;
            if (expected->first == turn.frame()) {
                errors += compare(turn.pairs(), expected->second);
                ++expected;
            } else if (!goes_on) {
                errors += compare(turn.pairs(), exact_pairs(boxes_after(boxes, turn.frame())));
            }
        }
        is_first = false;
        plan = turn.same_again();
        std::vector<double> values = {turn.ends_early() ? 1.0 : 0.0, static_cast<double>(errors.false_negatives),
                                      static_cast<double>(errors.false_positives)};
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
    const std::size_t last = boxes.frames.size() - 1;
    for (const std::size_t frame : std::set{std::size_t{0}, last / 2, last}) {
        truth.frames.emplace_back(frame, exact_pairs(boxes_after(boxes, frame)));
        truth.pair_count += static_cast<double>(truth.frames.back().second.size());
    }
    truth.pair_count /= static_cast<double>(truth.frames.size());
    return truth;
}

std::vector<BroadRun> measure_broad(const scenes::MovingBoxes& boxes, const BroadTruth& truth,
                                    const std::vector<BroadMaker>& makers, const BroadEffort& effort) {
    std::vector<process::Contained> children;
    children.reserve(makers.size());
    std::vector<BroadRun> runs;
    for (const BroadMaker& maker : makers) {
        runs.push_back({.maker = &maker});
        const double seconds = maker.name == broad_yardstick ? 3 * effort.turn_seconds : effort.turn_seconds;
        children.emplace_back([&, seconds] { return start_frames(maker, boxes, truth, seconds); }, maker.traits.limit);
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
            runs[i].errors = {static_cast<std::size_t>(values[1]), static_cast<std::size_t>(values[2])};
        }
    }
    return runs;
}

}  // namespace ecods::bench
