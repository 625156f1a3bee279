// All there is, where it is little: intervals on a few positions, and every way to go from one state to another.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "unit/broad_phase/lockstep.hpp"

namespace ecods::test {
namespace {

struct Interval {
    int from, to;
};

std::vector<Interval> all_intervals(int positions) {
    std::vector<Interval> intervals;
    for (int from = 0; from < positions; ++from) {
        for (int to = from; to < positions; ++to) intervals.push_back({from, to});
    }
    return intervals;
}

void set(Lockstep& lockstep, ProxyIndex proxy, int axis, Interval interval) {
    lockstep.set(proxy, make_interval(axis, interval.from, interval.to));
}

class EveryAxis : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Axes, EveryAxis, ::testing::Values(0, 1, 2));

TEST_P(EveryAxis, SingleMovesOfThreeIntervalsOnFourPositions) {
    const int axis = GetParam();
    const auto intervals = all_intervals(4);
    Lockstep lockstep;
    for (const Interval a : intervals) {
        for (const Interval b : intervals) {
            for (const Interval c : intervals) {
                for (ProxyIndex mover = 0; mover < 3; ++mover) {
                    const std::array<Interval, 3> start = {a, b, c};
                    for (const Interval goal : intervals) {
                        for (ProxyIndex i = 0; i < 3; ++i) set(lockstep, i, axis, start[i]);
                        lockstep.model.update();
                        for (const auto& engine : lockstep.engines) engine->update();
                        set(lockstep, mover, axis, goal);
                        ASSERT_TRUE(lockstep.update())
                            << "proxy " << mover << " from [" << start[mover].from << ", " << start[mover].to
                            << "] to [" << goal.from << ", " << goal.to << "]";
                    }
                }
            }
        }
    }
}

TEST_P(EveryAxis, JointMovesOfThreeIntervalsOnThreePositions) {
    const int axis = GetParam();
    const auto intervals = all_intervals(3);
    const auto count = intervals.size();
    Lockstep lockstep;
    for (std::size_t start = 0; start < count * count * count; ++start) {
        for (std::size_t goal = 0; goal < count * count * count; ++goal) {
            for (const std::size_t state : {start, goal}) {
                set(lockstep, 0, axis, intervals[state % count]);
                set(lockstep, 1, axis, intervals[state / count % count]);
                set(lockstep, 2, axis, intervals[state / count / count]);
                ASSERT_TRUE(lockstep.update(Lockstep::Checks::answers)) << start << " to " << goal;
            }
        }
    }
}

// Each call is an update, or adds, removes or moves one of two boxes that meet a third one half of the time.
TEST(Exhaustive, EverySequenceOfSevenCallsOnTwoNumbers) {
    constexpr int calls = 5;
    int sequences = 1;
    for (int i = 0; i < 7; ++i) sequences *= calls;
    for (int sequence = 0; sequence < sequences; ++sequence) {
        Lockstep lockstep;
        lockstep.add(2, make_cube(0, 0, 0));
        int rest = sequence;
        for (int i = 0; i < 7; ++i, rest /= calls) {
            const int call = rest % calls;
            const ProxyIndex proxy = static_cast<ProxyIndex>(call / 2);
            if (call == 4) {
                ASSERT_TRUE(lockstep.update()) << sequence;
            } else if (!lockstep.model.has(proxy)) {
                lockstep.add(proxy, make_cube(call % 2, 0, 0, 0.5));
            } else if (call % 2 == 0) {
                lockstep.remove(proxy);
            } else {
                const double x = lockstep.model.box(proxy).min[0] < 0 ? 3 : 0;
                lockstep.move(proxy, make_cube(x, 0, 0, 0.5));
            }
        }
        ASSERT_TRUE(lockstep.update()) << sequence;
    }
}

}  // namespace
}  // namespace ecods::test
