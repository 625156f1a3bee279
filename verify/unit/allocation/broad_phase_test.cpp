// Every call of a BroadPhase, out of memory at any point, in all kinds.
#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "allocation/each_allocation.hpp"
#include "ecods/broad_phase.hpp"
#include "ecods/error.hpp"

namespace ecods::allocation::broad_phase_test {
namespace {

Aabb box_at(double x, double size = 1) {
    return {.min = Vec3(x, 0, 0), .max = Vec3(x + size, 1, 1)};
}

// A broad phase, and the answer to a question.
struct Boxes {
    BroadPhase* operator->() const noexcept { return boxes.get(); }
    BroadPhase& operator*() const noexcept { return *boxes; }
    std::unique_ptr<BroadPhase> boxes;
    std::vector<ProxyIndex> found = {};
};

// With a question there is an index of many boxes, which then follows the changes.
enum class Stage { fresh, running, ebb, asked_before_changes, asked_after_changes };

bool is_asked(Stage stage) {
    return stage == Stage::asked_before_changes || stage == Stage::asked_after_changes;
}

// Boxes in a row, each of which overlaps some; changes wait for an update.
Boxes make_boxes(BroadPhaseKind kind, Stage stage, ProxyIndex count) {
    Boxes boxes{make_broad_phase(kind)};
    for (ProxyIndex i = 0; i < count; ++i) boxes->add(i, box_at(0.3 * i));
    if (stage == Stage::fresh) return boxes;
    boxes->update();
    for (ProxyIndex i = 0; i < count; i += 2) boxes->move(i, box_at(0.3 * i + 0.5));
    boxes->update();
    if (stage == Stage::asked_before_changes) boxes.found = boxes->find(box_at(3));
    if (stage == Stage::running || is_asked(stage)) {
        for (ProxyIndex i = 1; i < count; i += 3) boxes->move(i, box_at(0.3 * i - 1, 1.5));
        boxes->remove(4);
        boxes->remove(7);
        boxes->add(7, box_at(2));
        boxes->move(count - 1, box_at(1.5));  // far from where it was
    } else {
        for (ProxyIndex i = 3; i < count; ++i) boxes->remove(i);
        boxes->add(count, box_at(0.25));
    }
    if (stage == Stage::asked_after_changes) boxes.found = boxes->find(box_at(3));
    return boxes;
}

void go_on(Boxes& boxes) {
    boxes.found = boxes->find(box_at(1.25));
    boxes->update();
    boxes->check_invariants();
    boxes->move(2, box_at(2.25));
    boxes->remove(0);
    boxes->add(100, box_at(0.5));
    boxes->update();
    boxes->check_invariants();
    boxes->move(100, box_at(0.75));
    const auto more = boxes->find(box_at(0.25, 2));
    boxes.found.insert(boxes.found.end(), more.begin(), more.end());
    boxes->update();
    boxes->check_invariants();
}

std::string difference(BroadPhase& expected, BroadPhase& got, bool compares_pairs) {
    if (expected.size() != got.size()) return "the number of boxes";
    for (ProxyIndex i = 0; i < 8; ++i) {
        const auto box_or_none = [&](const BroadPhase& boxes) -> std::optional<Aabb> {
            try {
                return boxes.box(i);
            } catch (const Error&) {
                return {};
            }
        };
        const auto a = box_or_none(expected);
        const auto b = box_or_none(got);
        if (a.has_value() != b.has_value() || (a && !(*a == *b))) return "a box";
    }
    if (!compares_pairs) return "";
    if (expected.pairs() != got.pairs()) {
        return std::to_string(got.pairs().size()) + " pairs in place of " + std::to_string(expected.pairs().size());
    }
    if (expected.began() != got.began()) return "the pairs that began";
    if (expected.ended() != got.ended()) return "the pairs that ended";
    return expected.counts().moved == got.counts().moved ? "" : "the count of boxes that moved";
}

struct Call {
    const char* name;
    void (*make)(Boxes&);
};

const std::array calls = {
    Call{"add", [](Boxes& b) { b->add(90, box_at(1)); }},
    Call{"add far beyond", [](Boxes& b) { b->add(5000, box_at(1)); }},
    Call{"move", [](Boxes& b) { b->move(0, box_at(1)); }},
    Call{"move, many",
         [](Boxes& b) {
             const ProxyIndex proxies[] = {0, 2, 0, 1};
             const Aabb boxes[] = {box_at(1), box_at(0.5), box_at(3), box_at(0.3)};
             b->move(proxies, boxes);
         }},
    Call{"remove", [](Boxes& b) { b->remove(1); }},
    Call{"reserve", [](Boxes& b) { b->reserve(1000); }},
    Call{"pairs", [](Boxes& b) { b->pairs(); }},
    Call{"find, box", [](Boxes& b) { b.found = b->find(box_at(1.25)); }},
    Call{"find, segment",
         [](Boxes& b) {
             b.found = b->find(Segment{Vec3(0, 0.5, 0.5), Vec3(3, 0.25, 1)});
         }},
    Call{"find, ball",
         [](Boxes& b) {
             b.found = b->find(Ball{Vec3(2, 2, 0), 1.5});
         }},
    Call{"update", [](Boxes& b) { b->update(); }},
};

class BroadPhaseOutOfMemory : public testing::TestWithParam<BroadPhaseKind> {};
INSTANTIATE_TEST_SUITE_P(BroadPhases, BroadPhaseOutOfMemory,
                         testing::Values(BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                                         BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic));

TEST_P(BroadPhaseOutOfMemory, EveryCallThenChangesNothing) {
    for (const Call& call : calls) {
        for (const Stage stage :
             {Stage::fresh, Stage::running, Stage::ebb, Stage::asked_before_changes, Stage::asked_after_changes}) {
            Failures failures;
            const bool is_update = std::string_view(call.name) == "update";
            // Few boxes have no index.
            const bool is_large = is_asked(stage) || std::string_view(call.name).starts_with("find");
            fail_each_allocation<Boxes>(
                {.make = [=] { return make_boxes(GetParam(), stage, is_large ? 80 : 32); },
                 .call = call.make,
                 .difference =
                     [](Boxes& a, Boxes& b) {
                         return a.found == b.found ? difference(*a, *b, true) : "what was found";
                     },
                 .go_on = go_on,
                 .after_failure = [=](Boxes& a, Boxes& b) { return difference(*a, *b, !is_update); }},
                failures);
            EXPECT_EQ(failures.defects, 0u) << call.name << ", stage " << static_cast<int>(stage) << ", "
                                            << failures.allocations << " failures; first: " << failures.first;
        }
    }
}

}  // namespace
}  // namespace ecods::allocation::broad_phase_test
