#include "broad_phase/scratch/sort_and_sweep.hpp"

#include <gtest/gtest.h>

#include "broad_phase/changes/pair_list.hpp"
#include "scenes/random.hpp"
#include "unit/broad_phase/lockstep.hpp"

namespace ecods::test {
namespace {

// The finder with what it is used with, beside the model.
class Swept {
  public:
    void add(ProxyIndex proxy, const Aabb& box) {
        model.add(proxy, box);
        table_.add(proxy, box);
    }
    void move(ProxyIndex proxy, const Aabb& box) {
        model.move(proxy, box);
        table_.move(proxy, box);
    }
    void remove(ProxyIndex proxy) {
        model.remove(proxy);
        table_.remove(proxy);
    }

    void update() {
        model.update();
        pairs_.begin_update();
        events_.clear();
        const ProxyChanges& changes = table_.collect();
        if (!changes.empty()) {
            finder_.update(
                {.table = table_, .changes = changes, .keeper = pairs_, .events = events_, .counts = counts_});
        }
        table_.settle();
        pairs_.end_update();
        EXPECT_EQ(pairs_.sorted(), model.pairs);
        EXPECT_EQ(events_.began, model.began);
        EXPECT_EQ(events_.ended, model.ended);
        EXPECT_NO_THROW(finder_.validate(table_));
    }

    Model model;

  private:
    ProxyTable table_;
    PairEvents events_;
    PairList pairs_{events_};
    SortAndSweep finder_;
    BroadPhaseCounts counts_;
};

TEST(SortAndSweep, BoxesComeMoveAndGo) {
    scenes::Random random(11);
    Swept swept;
    const auto draw = [&] {
        return make_cube(random.below(12), random.below(12), random.below(12), 1 + random.below(2));
    };
    for (int frame = 0; frame < 60; ++frame) {
        for (ProxyIndex proxy = 0; proxy < 150; ++proxy) {
            const std::uint32_t what = random.below(10);
            if (!swept.model.has(proxy)) {
                if (what < 5) swept.add(proxy, draw());
            } else if (what < 2) {
                swept.remove(proxy);
                if (what == 0) swept.add(proxy, draw());
            } else if (what < 6) {
                swept.move(proxy, draw());
            }
        }
        swept.update();
        if (::testing::Test::HasFailure()) return;
    }
    for (ProxyIndex proxy = 0; proxy < 150; ++proxy) {
        if (swept.model.has(proxy)) swept.remove(proxy);
    }
    swept.update();
    swept.update();
}

}  // namespace
}  // namespace ecods::test
