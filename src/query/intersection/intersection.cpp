#include "ecods/intersection.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "bvh/separating_axes.hpp"
#include "exact/simplex/body_pair.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

struct NodePair {
    TreeRef a;
    TreeRef b;
};

struct QueryMemory::State {
    exact::BodyPair pair;
    SeparatingAxes axes;
    std::vector<NodePair> stack;
    QueryCounts counts;
};

QueryMemory::QueryMemory() : state_(std::make_unique<State>()) {}
QueryMemory::~QueryMemory() = default;
QueryMemory::QueryMemory(QueryMemory&&) noexcept = default;
QueryMemory& QueryMemory::operator=(QueryMemory&&) noexcept = default;

const QueryCounts& QueryMemory::counts() const noexcept {
    return state_->counts;
}
void QueryMemory::reset_counts() noexcept {
    state_->counts = {};
}

QueryCounts& QueryCounts::operator+=(const QueryCounts& other) noexcept {
    queries += other.queries;
    witness_hits += other.witness_hits;
    box_tests += other.box_tests;
    triangle_tests += other.triangle_tests;
    filter_passes += other.filter_passes;
    semi_static_passes += other.semi_static_passes;
    local_passes += other.local_passes;
    one_limb += other.one_limb;
    two_limbs += other.two_limbs;
    many_limbs += other.many_limbs;
    return *this;
}

namespace {

// Takes over what the exact layer counted during one query.
void add_stages(QueryCounts& counts, const exact::StageCounts& stages) {
    counts.triangle_tests += stages.triangle_tests;
    counts.filter_passes += stages.filter_passes;
    counts.semi_static_passes += stages.semi_static_passes;
    counts.local_passes += stages.local_passes;
    counts.one_limb += stages.one_limb;
    counts.two_limbs += stages.two_limbs;
    counts.many_limbs += stages.many_limbs;
}

// The pairs of lanes that overlap_mask returned.
class Lanes {
  public:
    explicit Lanes(std::uint64_t pairs) : pairs_(pairs) {}
    bool more() const noexcept { return pairs_ != 0; }
    void next() noexcept { pairs_ &= pairs_ - 1; }
    std::size_t i() const noexcept { return static_cast<std::size_t>(std::countr_zero(pairs_)) % tree_width; }
    std::size_t j() const noexcept { return static_cast<std::size_t>(std::countr_zero(pairs_)) / tree_width; }

  private:
    std::uint64_t pairs_;
};

// So many pairs of children of two nodes that are near each other mean that the bodies are, too.
constexpr int crowd_min = 4;

// One query: the two bodies, and the memory that it works in.
class Query {
  public:
    Query(const PosedMesh& a, const PosedMesh& b, QueryMemory& memory)
        : a_(a), b_(b), tree_a_(a.shape.tree()), tree_b_(b.shape.tree()), state_(memory.state()) {
        ++state_.counts.queries;
    }
    Query(const Query&) = delete;
    Query& operator=(const Query&) = delete;
    ~Query() {
        if (pair_is_bound_) add_stages(state_.counts, state_.pair.counts());
    }

    Relation relation_of(std::uint32_t i, std::uint32_t j) {
        if (!pair_is_bound_) bind_pair();
        return state_.pair.relation(i, j);
    }

    // The axis that separates the roots, or -1. `first` is tried first.
    int bind_axes(int first = -1) {
        return state_.axes.bind({tree_a_.boxes, a_.pose.R}, {tree_b_.boxes, b_.pose.R}, b_.pose.t - a_.pose.t, first);
    }

    // Calls visit(i, j) for pairs of triangles, among them every pair that shares a point, until it returns false.
    // After bind_axes.
    template <class Visit>
    void visit_near_pairs(Visit&& visit);

  private:
    // Bodies that are deep in each other have a contact nearly everywhere, and the boxes whose middles are closest are
    // nearly always in each other: the pair just pushed for them comes next. Only the order of the search depends on
    // it.
    void bring_closest_to_top(const BvhNode& x, const BvhNode& y, std::uint64_t near) {
        const Projection& p = state_.axes.sets()[0].b;
        std::array<FloatLanes, 3> middle;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t j = 0; j < tree_width; ++j) {
                middle[k][j] =
                    ((p.p[0][k] * y.center[0][j] + p.p[1][k] * y.center[1][j]) + p.p[2][k] * y.center[2][j]) +
                    p.shift[k];
            }
        }
        auto& stack = state_.stack;
        std::size_t at = stack.size() - static_cast<std::size_t>(std::popcount(near)), closest = at;
        float least = std::numeric_limits<float>::infinity();
        for (Lanes lanes(near); lanes.more(); lanes.next(), ++at) {
            float distance = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const float d = x.center[k][lanes.i()] - middle[k][lanes.j()];
                distance += d * d;
            }
            if (distance < least) {
                least = distance;
                closest = at;
            }
        }
        std::swap(stack[closest], stack.back());
    }

    // Only the queries that come to triangles pay for this.
    void bind_pair() {
        state_.pair.reset_counts();
        state_.pair.bind({&a_.shape.mesh(), &tree_a_.extent, &a_.pose}, {&b_.shape.mesh(), &tree_b_.extent, &b_.pose});
        pair_is_bound_ = true;
    }

    PosedMesh a_, b_;
    const MeshShape::Tree& tree_a_;
    const MeshShape::Tree& tree_b_;
    QueryMemory::State& state_;
    bool pair_is_bound_ = false;
};

template <class Visit>
void Query::visit_near_pairs(Visit&& visit) {
    const MeshBvh& a = tree_a_.boxes;
    const MeshBvh& b = tree_b_.boxes;
    const auto& sets = state_.axes.sets();
    auto& stack = state_.stack;
    stack.assign(1, NodePair{a.root, b.root});
    while (!stack.empty()) {
        const NodePair top = stack.back();
        stack.pop_back();
        ++state_.counts.box_tests;
        if (top.a.is_leaf() && top.b.is_leaf()) {
            const TreeLeaf& x = a.leaves[top.a.index()];
            const TreeLeaf& y = b.leaves[top.b.index()];
            for (Lanes lanes(overlap_mask(sets, x, y)); lanes.more(); lanes.next()) {
                if (!visit(x.triangle[lanes.i()], y.triangle[lanes.j()])) return;
            }
        } else if (top.a.is_leaf()) {
            const BvhNode& y = b.nodes[top.b.index()];
            const std::uint64_t near = overlap_mask(sets, a.leaves[top.a.index()], y);
            for (std::size_t j = 0; j < y.count; ++j) {
                if (near >> (tree_width * j) & 0xff) stack.push_back({top.a, y.child[j]});
            }
        } else if (top.b.is_leaf()) {
            const BvhNode& x = a.nodes[top.a.index()];
            const std::uint64_t near = overlap_mask(sets, x, b.leaves[top.b.index()]);
            for (std::size_t i = 0; i < x.count; ++i) {
                if (near >> i & 0x0101010101010101u) stack.push_back({x.child[i], top.b});
            }
        } else {
            const BvhNode& x = a.nodes[top.a.index()];
            const BvhNode& y = b.nodes[top.b.index()];
            const std::uint64_t near = overlap_mask(sets, x, y);
            for (Lanes lanes(near); lanes.more(); lanes.next()) {
                stack.push_back({x.child[lanes.i()], y.child[lanes.j()]});
            }
            if (std::popcount(near) >= crowd_min) bring_closest_to_top(x, y, near);
        }
    }
}

// A witness is a pair of triangles, or no triangle and the number of an axis.
bool holds_triangles(const PairWitness& witness, const PosedMesh& a, const PosedMesh& b) {
    return witness.a < a.shape.mesh().triangles().size() && witness.b < b.shape.mesh().triangles().size();
}
int axis_of(const PairWitness& witness) {
    return witness.a == PairWitness::none && witness.b < root_axis_count ? static_cast<int>(witness.b) : -1;
}
PairWitness witness_of(int axis) {
    return {PairWitness::none, static_cast<std::uint32_t>(axis)};
}

}  // namespace

bool intersects(const PosedMesh& a, const PosedMesh& b, QueryMemory& memory) {
    PairWitness witness;
    return intersects(a, b, memory, witness);
}

bool intersects(const PosedMesh& a, const PosedMesh& b, QueryMemory& memory, PairWitness& witness) {
    Query query(a, b, memory);
    QueryCounts& counts = memory.state().counts;
    if (holds_triangles(witness, a, b) && query.relation_of(witness.a, witness.b) != Relation::disjoint) {
        ++counts.witness_hits;
        return true;
    }
    const int last_axis = axis_of(witness);
    const int axis = query.bind_axes(last_axis);
    if (axis >= 0) {
        if (axis == last_axis) ++counts.witness_hits;
        witness = witness_of(axis);
        return false;
    }
    witness = {};
    bool found = false;
    query.visit_near_pairs([&](std::uint32_t i, std::uint32_t j) {
        found = query.relation_of(i, j) != Relation::disjoint;
        if (found) witness = {i, j};
        return !found;
    });
    return found;
}

Relation relation(const PosedMesh& a, const PosedMesh& b, QueryMemory& memory) {
    Query query(a, b, memory);
    Relation strongest = Relation::disjoint;
    if (query.bind_axes() >= 0) return strongest;
    query.visit_near_pairs([&](std::uint32_t i, std::uint32_t j) {
        strongest = std::max(strongest, query.relation_of(i, j));
        return strongest != Relation::crossing;
    });
    return strongest;
}

std::vector<TrianglePair> intersecting_triangles(const PosedMesh& a, const PosedMesh& b, QueryMemory& memory) {
    std::vector<TrianglePair> pairs;
    Query query(a, b, memory);
    if (query.bind_axes() >= 0) return pairs;
    query.visit_near_pairs([&](std::uint32_t i, std::uint32_t j) {
        if (query.relation_of(i, j) != Relation::disjoint) pairs.push_back({i, j});
        return true;
    });
    std::ranges::sort(pairs);
    return pairs;
}

}  // namespace ecods
