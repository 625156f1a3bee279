#include "engines/sort_and_sweep.hpp"

#include <gtest/gtest.h>

#include "scenes/random.hpp"
#include "unit/broad_phase/lockstep.hpp"

namespace ecods::bench {
namespace {

using test::Model;

// Beside the model.
class Swept {
  public:
    void add(ProxyIndex proxy, const Aabb& box) {
        model.add(proxy, box);
        search_.add(proxy, box);
    }
    void move(ProxyIndex proxy, const Aabb& box) {
        model.move(proxy, box);
        search_.move(proxy, box);
    }
    void remove(ProxyIndex proxy) {
        model.remove(proxy);
        search_.remove(proxy);
    }

    void update() {
        model.update();
        search_.update();
        EXPECT_EQ(search_.pairs(), model.pairs);
        EXPECT_EQ(search_.began(), model.began);
        EXPECT_EQ(search_.ended(), model.ended);
    }

    Model model;

  private:
    SortAndSweep search_;
};

TEST(SortAndSweep, BoxesComeMoveAndGo) {
    scenes::Random random(11);
    Swept swept;
    const auto draw = [&] {
        return test::make_cube(random.below(12), random.below(12), random.below(12), 1 + random.below(2));
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
}  // namespace ecods::bench
