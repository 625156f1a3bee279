// The walk of two small trees, nearest nodes first, and its queue, beside models that look at all that waits.
#include "bvh/walks/walk_nearest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "scenes/random.hpp"
#include "unit/bvh/small_trees.hpp"

namespace ecods::walk_nearest_test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// The numbers of the pairs of triangles of two trees.
struct Numbers {
    const SmallTree &a, &b;
    std::function<float(std::uint32_t, std::uint32_t)> of;

    float least(TriangleBits x, TriangleBits y) const {
        float result = infinity;
        for (TriangleBits p = x; p != 0; p &= p - 1) {
            for (TriangleBits q = y; q != 0; q &= q - 1) {
                result = std::min(result, of(static_cast<std::uint32_t>(std::countr_zero(p)),
                                             static_cast<std::uint32_t>(std::countr_zero(q))));
            }
        }
        return result;
    }
};

// A search that lowers its limit to the least number that it finds, if it is asked to, and ends after some visits.
struct Search {
    const Numbers& numbers;
    float limit_;
    bool lowers = false;
    std::size_t visits_max = ~std::size_t{0}, takes_max = ~std::size_t{0};
    std::size_t falls_at = ~std::size_t{0};  // at which visit the limit falls to zero
    std::vector<PairNumber> visited = {}, asked = {};
    std::vector<float> squares = {};
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> taken = {};
    std::size_t take_count = 0;

    float limit() const { return limit_; }
    template <class X, class Y>
    std::uint64_t find_near(const X& x, const Y& y, LaneBounds& bounds) {
        const TreeRef p = numbers.a.name_of(x), q = numbers.b.name_of(y);
        asked.push_back(number_of(NodePair{p, q}));
        const std::vector<TriangleBits> of_x = numbers.a.lanes_of(p), of_y = numbers.b.lanes_of(q);
        std::uint64_t lanes = 0;
        bounds.fill(-1);  // what is not among the lanes is not looked at
        for (std::size_t j = 0; j < of_y.size(); ++j) {
            for (std::size_t i = 0; i < of_x.size(); ++i) {
                const float least = numbers.least(of_x[i], of_y[j]);
                if (least > limit_) continue;
                bounds[tree_width * i + j] = least;
                lanes |= std::uint64_t{1} << (tree_width * j + i);
            }
        }
        return lanes;
    }
    bool visits(const NearPair& pair) {
        EXPECT_LE(pair.square, limit_);
        visited.push_back(number_of(pair.nodes));
        squares.push_back(pair.square);
        if (visited.size() == falls_at) limit_ = 0;
        return visited.size() < visits_max;
    }
    bool take(const TreeLeaf& x, const TreeLeaf& y) {
        for (std::size_t i = 0; i < x.count; ++i) {
            for (std::size_t j = 0; j < y.count; ++j) {
                const float number = numbers.of(x.triangle[i], y.triangle[j]);
                if (number > limit_) continue;
                ++taken[{x.triangle[i], y.triangle[j]}];
                if (lowers) limit_ = number;
            }
        }
        return ++take_count < takes_max;
    }
};

// The walk as it is meant, where all numbers that differ are in buckets of their own: the least comes first, of equal
// ones that which began to wait last.
std::vector<PairNumber> visits_of(const Numbers& numbers, float limit) {
    const SmallTree &a = numbers.a, &b = numbers.b;
    std::vector<NearPair> waiting{{0, {a.tree.root, b.tree.root}}};
    std::vector<PairNumber> visited;
    while (!waiting.empty()) {
        auto first = waiting.end() - 1;
        for (auto at = waiting.begin(); at != waiting.end(); ++at) {
            if (at->square < first->square || (at->square == first->square && at > first)) first = at;
        }
        const NodePair at = first->nodes;
        waiting.erase(first);
        visited.push_back(number_of(at));
        if (at.a.is_leaf() && at.b.is_leaf()) continue;
        const auto of_a = at.a.is_leaf() ? std::vector{at.a} : a.children_of(at.a);
        const auto of_b = at.b.is_leaf() ? std::vector{at.b} : b.children_of(at.b);
        for (const TreeRef y : of_b) {
            for (const TreeRef x : of_a) {
                const float square = numbers.least(a.below(x), b.below(y));
                if (square <= limit) waiting.push_back({square, {x, y}});
            }
        }
    }
    return visited;
}

template <class Use>
void with_trees(std::size_t count_max, const Use& use) {
    const std::vector<SmallTree> trees = small_trees(count_max);
    for (const SmallTree& a : trees) {
        for (const SmallTree& b : trees) {
            use(a, b);
            if (testing::Test::HasFailure()) return;
        }
    }
}
float power_of(std::uint32_t i, std::uint32_t j) {
    return std::ldexp(1.0f, -static_cast<int>((i * 5 + j * 3 + 1) % 14));
}

TEST(WalkNearest, VisitsTheNearestFirstAndOfEqualOnesTheLast) {
    NearestQueue queue;
    with_trees(5, [&](const SmallTree& a, const SmallTree& b) {
        const Numbers numbers{a, b, power_of};
        for (const float limit : {1.0f, 0x1p-6f, 0x1p-20f}) {
            Search search{.numbers = numbers, .limit_ = limit};
            walk_nearest(a.tree, b.tree, queue, search);
            const std::vector<PairNumber> expected = visits_of(numbers, limit);
            ASSERT_EQ(search.visited, expected);
            for (std::uint32_t i = 0; i < a.triangle_count(); ++i) {
                for (std::uint32_t j = 0; j < b.triangle_count(); ++j) {
                    ASSERT_EQ((search.taken[{i, j}]), power_of(i, j) <= limit) << i << ", " << j;
                }
            }
            ASSERT_EQ(search.asked.size() + search.take_count, search.visited.size());
        }
    });
}

TEST(WalkNearest, EndsWhenTheSearchSaysSo) {
    NearestQueue queue;
    with_trees(4, [&](const SmallTree& a, const SmallTree& b) {
        const Numbers numbers{a, b, power_of};
        const std::vector<PairNumber> whole = visits_of(numbers, 1);
        for (std::size_t end = 1; end <= whole.size(); end = 2 * end + 1) {
            Search search{.numbers = numbers, .limit_ = 1, .visits_max = end};
            walk_nearest(a.tree, b.tree, queue, search);
            ASSERT_TRUE(std::equal(search.visited.begin(), search.visited.end(), whole.begin(),
                                   whole.begin() + static_cast<std::ptrdiff_t>(end)));
            ASSERT_EQ(search.asked.size() + search.take_count, end - 1) << "the last one is not opened";
        }
        for (std::size_t end = 2; end <= whole.size(); end = 2 * end + 1) {
            Search search{.numbers = numbers, .limit_ = 1, .falls_at = end};
            walk_nearest(a.tree, b.tree, queue, search);
            ASSERT_EQ(search.visited.size(), end);
            ASSERT_EQ(search.asked.size() + search.take_count, end - 1) << "what is beyond the limit is not opened";
        }
        Search search{.numbers = numbers, .limit_ = 1, .takes_max = 1};
        walk_nearest(a.tree, b.tree, queue, search);
        ASSERT_EQ(search.take_count, 1u);
    });
}

// A limit that falls leaves out what is beyond it, and no pair at it.
TEST(WalkNearest, FindsAllThatTieWithTheLeast) {
    scenes::Random random(3);
    NearestQueue queue;
    with_trees(5, [&](const SmallTree& a, const SmallTree& b) {
        std::vector<float> table(std::size_t{a.triangle_count()} * b.triangle_count());
        for (float& number : table) number = static_cast<float>(random.below(40)) / 37 + 0x1p-20f;
        const Numbers numbers{a, b,
                              [&](std::uint32_t i, std::uint32_t j) { return table[i * b.triangle_count() + j]; }};
        for (const float limit : {infinity, 1.0f}) {
            Search search{.numbers = numbers, .limit_ = limit, .lowers = true};
            walk_nearest(a.tree, b.tree, queue, search);
            const float least = std::ranges::min(table);
            ASSERT_EQ(search.limit_, std::min(least, limit));
            for (std::uint32_t i = 0; i < a.triangle_count(); ++i) {
                for (std::uint32_t j = 0; j < b.triangle_count(); ++j) {
                    const int count = search.taken[{i, j}];
                    ASSERT_LE(count, 1);
                    ASSERT_TRUE(numbers.of(i, j) > std::min(least, limit) || count == 1);
                }
            }
            // One bucket is one part in 32, or all numbers where no limit says where they begin.
            float most = 0;
            for (const float square : search.squares) {
                ASSERT_TRUE(limit > 1 || square * (1 + 0x1p-5f) * (1 + 0x1p-20f) >= most) << square << ", " << most;
                most = std::max(most, square);
            }
        }
    });
}

// Whatever is pushed and popped in between, each pair comes out once, if the limit is not below it.
TEST(NearestQueue, GivesTheLeastAndOfEqualOnesTheLast) {
    scenes::Random random(9);
    NearestQueue queue;
    for (int round = 0; round < 20; ++round) {
        std::vector<NearPair> model;
        queue.start(1);
        for (std::uint32_t step = 0; step < 2000; ++step) {
            if (random.below(8) < (step / 400 % 2 == 0 ? 6u : 2u)) {
                const NearPair pair{std::ldexp(1.0f, -static_cast<int>(random.below(31))), {TreeRef::node(step), {}}};
                queue.push(pair);
                model.push_back(pair);
                continue;
            }
            const float limit = std::ldexp(1.0f, -static_cast<int>(random.below(8)));
            auto first = model.end();
            for (auto at = model.begin(); at != model.end(); ++at) {
                if (at->square <= limit && (first == model.end() || at->square <= first->square)) first = at;
            }
            NearPair found;
            ASSERT_EQ(queue.pop(limit, found), first != model.end());
            if (first == model.end()) continue;
            ASSERT_EQ(found.square, first->square);
            ASSERT_EQ(found.nodes.a.index(), first->nodes.a.index());
            model.erase(first);
        }
    }
}

}  // namespace
}  // namespace ecods::walk_nearest_test
