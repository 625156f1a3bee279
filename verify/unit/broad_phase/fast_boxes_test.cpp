// Boxes that leave any margin soon are not looked up one by one: counts prove it.
#include <gtest/gtest.h>

#include <vector>

#include "unit/broad_phase/lockstep.hpp"

namespace ecods::test::fast_boxes_test {
namespace {

// Of boxes that move straight on, each by its own way, by so much of their size at most, three of four of them by a
// share of that: the tests of an update for each.
double tests_of_fast_boxes(double speed, double share_of_slow) {
    constexpr ProxyIndex count = 4000;
    constexpr int updates = 80;
    constexpr double space = 24;
    std::uint64_t state = 1;
    const auto next = [&] {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state >> 40) / 0x1p24;
    };
    const auto speed_of = [&](ProxyIndex proxy) { return proxy % 4 == 0 ? speed : share_of_slow * speed; };
    const auto phase = make_broad_phase(BroadPhaseKind::kept_candidates);
    std::vector<Vec3> at(count), way(count);
    for (ProxyIndex proxy = 0; proxy < count; ++proxy) {
        for (Eigen::Index k = 0; k < 3; ++k)
            at[proxy][k] = space * next(), way[proxy][k] = speed_of(proxy) * (2 * next() - 1);
        phase->add(proxy, make_cube(at[proxy][0], at[proxy][1], at[proxy][2], 2));
    }
    phase->update();
    const BroadPhaseCounts before = phase->counts();
    for (int update = 0; update < updates; ++update) {
        for (ProxyIndex proxy = 0; proxy < count; ++proxy) {
            for (Eigen::Index k = 0; k < 3; ++k) {
                if (at[proxy][k] + way[proxy][k] < 0 || at[proxy][k] + way[proxy][k] > space) way[proxy][k] *= -1;
            }
            at[proxy] += way[proxy];
            phase->move(proxy, make_cube(at[proxy][0], at[proxy][1], at[proxy][2], 2));
        }
        phase->update();
    }
    const BroadPhaseCounts& after = phase->counts();
    return static_cast<double>(after.box_tests - before.box_tests + after.candidates_filtered -
                               before.candidates_filtered) /
           (count * updates);
}

// Their margins end at different times; yet they are not looked up one by one, which takes several times the tests.
TEST(FastBoxes, GetOtherMarginsTogether) {
    EXPECT_LE(tests_of_fast_boxes(0.02, 1), 16);
    EXPECT_LE(tests_of_fast_boxes(0.06, 1), 24);
    EXPECT_LE(tests_of_fast_boxes(0.1, 1), 37);
}

// Some are much faster than others, and leave their margins while those of the others last.
TEST(FastBoxes, ThoseThatEscapeOneByOneEndInOneSearch) {
    EXPECT_LE(tests_of_fast_boxes(0.04, 0.2), 15);
    EXPECT_LE(tests_of_fast_boxes(0.08, 0.1), 18.2);
    EXPECT_LE(tests_of_fast_boxes(0.12, 0.05), 22);
}

}  // namespace
}  // namespace ecods::test::fast_boxes_test
