// Walks of two small trees, and of one against itself, beside walks that call themselves.
#include "bvh/walks/walk_two.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bvh/walks/walk_self.hpp"
#include "unit/bvh/small_trees.hpp"

namespace ecods::walk_two_test {
namespace {

using Triangles = std::pair<std::uint32_t, std::uint32_t>;

// What a walk does, in its order.
struct Trail {
    std::vector<PairNumber> asked;
    std::vector<Triangles> results;

    bool operator==(const Trail&) const = default;
};

enum class Order { of_lanes, reversed };

// The walk of two trees as it is meant: the last pair of children, and all that is below it, comes first.
class Model {
  public:
    Model(const SmallTree& a, const SmallTree& b, const PairsThatMatter& pairs, Order order)
        : a_(a), b_(b), pairs_(pairs), order_(order) {
        visit({a.tree.root, b.tree.root});
    }
    Trail trail;

  private:
    void visit(const NodePair& at) {
        trail.asked.push_back(number_of(at));
        if (at.a.is_leaf() && at.b.is_leaf()) return take(a_.tree.leaves[at.a.index()], b_.tree.leaves[at.b.index()]);
        // A leaf beside a node is its own child.
        const auto of_a = at.a.is_leaf() ? std::vector{at.a} : a_.children_of(at.a);
        const auto of_b = at.b.is_leaf() ? std::vector{at.b} : b_.children_of(at.b);
        std::vector<NodePair> children;
        for (const TreeRef y : of_b) {
            for (const TreeRef x : of_a) {
                if (pairs_.has_any(a_.below(x), b_.below(y))) children.push_back({x, y});
            }
        }
        const bool are_nodes = !at.a.is_leaf() && !at.b.is_leaf();
        if (order_ == Order::of_lanes || !are_nodes) std::ranges::reverse(children);
        for (const NodePair& child : children) visit(child);
    }
    void take(const TreeLeaf& x, const TreeLeaf& y) {
        for (std::size_t j = 0; j < y.count; ++j) {
            for (std::size_t i = 0; i < x.count; ++i) {
                if (pairs_.has(x.triangle[i], y.triangle[j])) trail.results.emplace_back(x.triangle[i], y.triangle[j]);
            }
        }
    }

    const SmallTree &a_, &b_;
    const PairsThatMatter& pairs_;
    Order order_;
};

struct Bound {
    const SmallTree &a, &b;
    const PairsThatMatter& pairs;
    Trail& trail;

    template <class X, class Y>
    std::uint64_t operator()(const X& x, const Y& y) {
        trail.asked.push_back(number_of(NodePair{a.name_of(x), b.name_of(y)}));
        return pairs.lanes_of(a, a.name_of(x), b, b.name_of(y));
    }
};
struct ReversingBound : Bound {
    void order(const BvhNode& x, const BvhNode& y, LanePairs lanes, std::span<NodePair> children) {
        ASSERT_FALSE(children.size() > tree_width * tree_width);
        for (const NodePair& child : children) {
            ASSERT_TRUE(lanes.more());
            ASSERT_EQ(number_of(child), number_of(NodePair{x.child[lanes.i()], y.child[lanes.j()]}));
            lanes.next();
        }
        ASSERT_FALSE(lanes.more()) << "all children, and no pair that waits already";
        std::ranges::reverse(children);
    }
};

// Calls use(a, b, pairs) with pairs of trees, of whose triangles none, all, and some pairs matter.
template <class Use>
void with_pairs_of(const std::vector<SmallTree>& trees, const Use& use) {
    for (const SmallTree& a : trees) {
        for (const SmallTree& b : trees) {
            for (const std::uint32_t one_of : {1u, 3u, 17u, ~0u}) {
                use(a, b, PairsThatMatter(a, b, [&](std::uint32_t i, std::uint32_t j) {
                        return (i * 7 + j * 11 + 5) % one_of == 0;
                    }));
                if (testing::Test::HasFailure()) return;
            }
        }
    }
}

TEST(WalkTwo, VisitsEachPairThatMattersOnceDepthFirst) {
    std::vector<NodePair> stack;
    with_pairs_of(small_trees(5), [&](const SmallTree& a, const SmallTree& b, const PairsThatMatter& pairs) {
        const auto take = [](Trail& trail) {
            return [&trail](std::uint32_t i, std::uint32_t j) {
                trail.results.emplace_back(i, j);
                return true;
            };
        };
        Trail trail, reversed;
        walk_two(a.tree, b.tree, stack, Bound{a, b, pairs, trail}, take(trail));
        ASSERT_EQ(trail, Model(a, b, pairs, Order::of_lanes).trail);
        walk_two(a.tree, b.tree, stack, ReversingBound{{a, b, pairs, reversed}}, take(reversed));
        ASSERT_EQ(reversed, Model(a, b, pairs, Order::reversed).trail);

        std::set<Triangles> expected;
        for (std::uint32_t i = 0; i < a.triangle_count(); ++i) {
            for (std::uint32_t j = 0; j < b.triangle_count(); ++j) {
                if (pairs.has(i, j)) expected.emplace(i, j);
            }
        }
        ASSERT_EQ(std::set(trail.results.begin(), trail.results.end()), expected);
        ASSERT_EQ(trail.results.size(), expected.size()) << "none twice";
        ASSERT_EQ(std::set(trail.asked.begin(), trail.asked.end()).size(), trail.asked.size()) << "no nodes twice";
    });
}

TEST(WalkTwo, EndsWhenTheResultSaysSo) {
    std::vector<NodePair> stack;
    with_pairs_of(small_trees(4), [&](const SmallTree& a, const SmallTree& b, const PairsThatMatter& pairs) {
        const Trail whole = Model(a, b, pairs, Order::of_lanes).trail;
        for (std::size_t end = 1; end <= whole.results.size(); end = 2 * end + 1) {
            Trail trail;
            walk_two(a.tree, b.tree, stack, Bound{a, b, pairs, trail}, [&](std::uint32_t i, std::uint32_t j) {
                trail.results.emplace_back(i, j);
                return trail.results.size() < end;
            });
            ASSERT_TRUE(std::ranges::equal(trail.results, std::span(whole.results).first(end)));
            ASSERT_LE(trail.asked.size(), whole.asked.size());
            ASSERT_TRUE(std::equal(trail.asked.begin(), trail.asked.end(), whole.asked.begin()));
            // The leaves of the last result were asked last.
            const NodePair last{TreeRef::leaf(trail.asked.back().first / 2),
                                TreeRef::leaf(trail.asked.back().second / 2)};
            ASSERT_EQ(number_of(last), trail.asked.back());
            ASSERT_NE(a.below(last.a) >> trail.results.back().first & 1, 0u);
            ASSERT_NE(b.below(last.b) >> trail.results.back().second & 1, 0u);
        }
    });
}

// Leaves may say more of a pair of triangles, which then comes with it.
struct CrossingBound : Bound {
    using Bound::operator();
    TrianglePairs operator()(const TreeLeaf& x, const TreeLeaf& y) {
        TrianglePairs found;
        found.near = Bound::operator()(x, y);
        for (LanePairs lanes(found.near); lanes.more(); lanes.next()) {
            if (crosses(x.triangle[lanes.i()], y.triangle[lanes.j()]))
                found.crossing |= std::uint64_t{1} << (tree_width * lanes.j() + lanes.i());
        }
        return found;
    }
    static bool crosses(std::uint32_t i, std::uint32_t j) { return (i + 2 * j) % 3 == 0; }
};

TEST(WalkTwo, SaysOfEachPairWhatItsLeavesDid) {
    std::vector<NodePair> stack;
    with_pairs_of(small_trees(4), [&](const SmallTree& a, const SmallTree& b, const PairsThatMatter& pairs) {
        Trail trail;
        walk_two(a.tree, b.tree, stack, CrossingBound{{a, b, pairs, trail}},
                 [&](std::uint32_t i, std::uint32_t j, bool crosses) {
                     EXPECT_EQ(crosses, CrossingBound::crosses(i, j));
                     trail.results.emplace_back(i, j);
                     return true;
                 });
        ASSERT_EQ(trail, Model(a, b, pairs, Order::of_lanes).trail);
    });
}

TEST(WalkSelf, VisitsEachPairOfDifferentTrianglesOnce) {
    std::vector<NodePair> stack;
    for (const SmallTree& tree : small_trees(7)) {
        for (const std::uint32_t one_of : {1u, 3u, ~0u}) {
            const PairsThatMatter pairs(tree, tree, [&](std::uint32_t i, std::uint32_t j) {
                return (std::min(i, j) * 7 + std::max(i, j) * 11 + 5) % one_of == 0;
            });
            std::set<Triangles> expected, found;
            for (std::uint32_t j = 0; j < tree.triangle_count(); ++j) {
                for (std::uint32_t i = 0; i < j; ++i) {
                    if (pairs.has(i, j)) expected.emplace(i, j);
                }
            }
            for (std::size_t end = expected.size() + 1; end > 0; end /= 2) {
                Trail trail;
                found.clear();
                walk_self(tree.tree, stack, Bound{tree, tree, pairs, trail}, [&](std::uint32_t i, std::uint32_t j) {
                    EXPECT_TRUE(found.insert(std::minmax(i, j)).second) << "twice";
                    return found.size() < end;
                });
                ASSERT_EQ(found.size(), std::min(end, expected.size()));
                ASSERT_TRUE(std::ranges::includes(expected, found));
                std::set<PairNumber> asked;
                for (const PairNumber& pair : trail.asked) {
                    ASSERT_TRUE(asked.insert(std::minmax(pair.first, pair.second)).second) << "nodes twice";
                }
            }
        }
    }
}

}  // namespace
}  // namespace ecods::walk_two_test
