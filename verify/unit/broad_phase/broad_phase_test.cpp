// What the header promises, for every kind.
#include "ecods/broad_phase.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "ecods/error.hpp"
#include "unit/broad_phase/lockstep.hpp"

namespace ecods::test::broad_phase_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class EveryBroadPhase : public ::testing::TestWithParam<BroadPhaseKind> {
  protected:
    std::unique_ptr<BroadPhase> phase = make_broad_phase(GetParam());

    void update() {
        phase->update();
        phase->check_invariants();
    }
};

INSTANTIATE_TEST_SUITE_P(Kinds, EveryBroadPhase, ::testing::ValuesIn(all_kinds),
                         [](const auto& kind) { return std::string(Lockstep::name(*make_broad_phase(kind.param))); });

TEST_P(EveryBroadPhase, IsOfTheKindAskedForAndStartsEmpty) {
    EXPECT_EQ(phase->kind(), GetParam());
    EXPECT_EQ(phase->size(), 0u);
    update();
    EXPECT_TRUE(phase->pairs().empty());
}

TEST_P(EveryBroadPhase, ChangesTakeEffectForBoxesAtOnceAndForPairsAtUpdate) {
    phase->add(0, make_cube(0, 0, 0));
    phase->add(1, make_cube(0.5, 0, 0));
    EXPECT_EQ(phase->size(), 2u);
    EXPECT_TRUE(phase->pairs().empty());
    update();
    EXPECT_EQ(phase->pairs(), (Pairs{{0, 1}}));
    phase->move(1, make_cube(9, 0, 0));
    EXPECT_EQ(phase->box(1), make_cube(9, 0, 0));
    EXPECT_EQ(phase->pairs(), (Pairs{{0, 1}}));
    update();
    EXPECT_TRUE(phase->pairs().empty());
    EXPECT_EQ(phase->ended(), (Pairs{{0, 1}}));
    update();
    EXPECT_TRUE(phase->ended().empty());
}

TEST_P(EveryBroadPhase, NumberUsedAgainBeforeTheUpdateIsAnotherBox) {
    phase->add(4, make_cube(0, 0, 0));
    phase->add(2, make_cube(0.5, 0, 0));
    update();
    phase->remove(4);
    phase->add(4, make_cube(0.25, 0, 0));
    update();
    EXPECT_EQ(phase->pairs(), (Pairs{{2, 4}}));
    EXPECT_EQ(phase->began(), (Pairs{{2, 4}}));
    EXPECT_EQ(phase->ended(), (Pairs{{2, 4}}));
}

TEST_P(EveryBroadPhase, ABoxThatCameAndWentBetweenUpdatesLeavesNothing) {
    phase->add(0, make_cube(0, 0, 0));
    update();
    phase->add(1, make_cube(0, 0, 0));
    phase->move(1, make_cube(0.1, 0, 0));
    phase->remove(1);
    update();
    EXPECT_EQ(phase->size(), 1u);
    EXPECT_TRUE(phase->began().empty());
    EXPECT_TRUE(phase->ended().empty());
    // And once more with a number that was here.
    phase->remove(0);
    phase->add(0, make_cube(0, 0, 0));
    phase->remove(0);
    update();
    EXPECT_EQ(phase->size(), 0u);
    phase->add(0, make_cube(0, 0, 0));
    phase->add(1, make_cube(0, 0, 0));
    update();
    EXPECT_EQ(phase->pairs(), (Pairs{{0, 1}}));
}

TEST_P(EveryBroadPhase, OnlyAnotherBoxIsAMove) {
    phase->add(0, make_cube(0, 0, 0));
    update();
    phase->move(0, make_cube(0, 0, 0));
    update();
    EXPECT_EQ(phase->counts().moved, 1u);
    EXPECT_EQ(phase->counts().updates, 2u);
    phase->move(0, make_cube(7, 0, 0));
    phase->move(0, make_cube(0, 0, 0));
    update();
    EXPECT_EQ(phase->counts().moved, 2u) << "there and back is one";
}

TEST_P(EveryBroadPhase, InfiniteBoxesOverlapWhatTheyReach) {
    phase->add(0, make_box(-infinity, infinity, -infinity, infinity, -infinity, infinity));
    phase->add(1, make_cube(1e308, -1e308, 3));
    phase->add(2, make_box(infinity, infinity, 0, 0, 0, 0));
    phase->add(3, make_box(5, infinity, -1, 1, -1, 1));
    update();
    EXPECT_EQ(phase->pairs(), (Pairs{{0, 1}, {0, 2}, {0, 3}, {2, 3}}));
}

TEST_P(EveryBroadPhase, BothZerosAreOnePlace) {
    phase->add(0, make_box(-1, -0.0, 0, 1, 0, 1));
    phase->add(1, make_box(0.0, 1, 0, 1, 0, 1));
    phase->add(2, make_box(-1, 0.0, 2, 3, 0, 1));
    phase->add(3, make_box(-0.0, 1, 2, 3, 0, 1));
    update();
    EXPECT_EQ(phase->pairs(), (Pairs{{0, 1}, {2, 3}}));
}

TEST_P(EveryBroadPhase, WrongProxiesAreErrorsAndChangeNothing) {
    phase->add(3, make_cube(0, 0, 0));
    EXPECT_THROW(phase->add(3, make_cube(1, 0, 0)), Error);
    EXPECT_THROW(phase->move(2, make_cube(1, 0, 0)), Error);
    EXPECT_THROW(phase->remove(1000000), Error);
    EXPECT_THROW(phase->box(4), Error);
    EXPECT_THROW(phase->add(ProxyIndex{1} << 31, make_cube(1, 0, 0)), Error);
    EXPECT_EQ(phase->size(), 1u);
    EXPECT_EQ(phase->box(3), make_cube(0, 0, 0));
    update();
    phase->remove(3);
    EXPECT_THROW(phase->remove(3), Error);
    EXPECT_THROW(phase->move(3, make_cube(1, 0, 0)), Error);
    update();
}

TEST_P(EveryBroadPhase, ManyMoveAsEachWould) {
    for (ProxyIndex proxy = 0; proxy < 5; ++proxy) phase->add(proxy, make_cube(3 * proxy, 0, 0));
    update();
    const std::vector<ProxyIndex> proxies = {4, 1, 2, 1};
    const std::vector<Aabb> boxes = {phase->box(4), make_cube(90, 0, 0), make_cube(0.5, 0, 0), make_cube(9.5, 0, 0)};
    phase->move(proxies, boxes);
    EXPECT_EQ(phase->box(1), boxes[3]) << "the last one holds";
    EXPECT_EQ(phase->box(2), boxes[2]);
    const std::uint64_t moved = phase->counts().moved;
    update();
    EXPECT_EQ(phase->counts().moved - moved, 2u) << "one got the box that it had, and one was named twice";
    EXPECT_EQ(phase->pairs(), (Pairs{{0, 2}, {1, 3}}));
}

TEST_P(EveryBroadPhase, ManyMoveOrNone) {
    for (ProxyIndex proxy = 0; proxy < 3; ++proxy) phase->add(proxy, make_cube(3 * proxy, 0, 0));
    phase->remove(1);
    update();
    const std::vector<ProxyIndex> proxies = {0, 1};
    const std::vector<Aabb> boxes = {make_cube(7, 0, 0), make_cube(8, 0, 0)};
    EXPECT_THROW(phase->move(proxies, boxes), Error);
    EXPECT_THROW(phase->move(std::span(proxies).first(1), boxes), Error);
    EXPECT_EQ(phase->box(0), make_cube(0, 0, 0));
    phase->move(std::vector<ProxyIndex>(), std::vector<Aabb>());
    const std::uint64_t moved = phase->counts().moved;
    update();
    EXPECT_EQ(phase->counts().moved, moved);
}

}  // namespace
}  // namespace ecods::test::broad_phase_test
