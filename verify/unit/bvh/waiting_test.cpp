#include "bvh/walks/waiting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "scenes/random.hpp"

namespace ecods::waiting_test {
namespace {

// What comes out is the least of what is in, whatever is put in between.
TEST(Waiting, GivesTheLeastFirst) {
    scenes::Random random(5);
    Waiting<int> waiting;
    std::vector<int> model;
    for (int step = 0; step < 4000; ++step) {
        const bool grows = (step / 500) % 2 == 0;
        if (model.empty() || random.uniform(0, 1) < (grows ? 0.7 : 0.3)) {
            const int item = static_cast<int>(random.uniform(0, 300));
            waiting.push(item);
            model.push_back(item);
            continue;
        }
        const auto least = std::ranges::min_element(model);
        ASSERT_EQ(waiting.front(), *least);
        if (step % 3 == 0) {
            *least = static_cast<int>(random.uniform(0, 300));
            waiting.replace_front(*least);
        } else {
            ASSERT_EQ(waiting.pop(), *least);
            model.erase(least);
        }
        ASSERT_EQ(waiting.is_empty(), model.empty());
    }
}

}  // namespace
}  // namespace ecods::waiting_test
