#include "ecods/two_body.hpp"

#include <algorithm>

#include "bounds/separating_axes.hpp"
#include "exact/body_pair.hpp"
#include "narrow_phase/mesh_tree.hpp"

namespace ecods {

struct NodePair {
    std::uint32_t a;
    std::uint32_t b;
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

void bind(QueryMemory::State& state, const PosedMesh& a, const PosedMesh& b) {
    const exact::MeshExtent& extent_a = a.shape.tree().extent;
    const exact::MeshExtent& extent_b = b.shape.tree().extent;
    state.pair.bind({&a.shape.mesh(), &extent_a, &a.pose}, {&b.shape.mesh(), &extent_b, &b.pose});
    state.axes = SeparatingAxes(a.pose.R, extent_a.magnitude, b.pose.R, extent_b.magnitude, b.pose.t - a.pose.t);
}

// Calls visit(a, b) for pairs of triangles, among them every pair that shares a point, until it returns false.
template <class Visit>
void visit_near_pairs(QueryMemory::State& state, const PosedMesh& a, const PosedMesh& b, Visit&& visit) {
    ++state.counts.queries;
    bind(state, a, b);
    const TriangleTree& tree_a = a.shape.tree().boxes;
    const TriangleTree& tree_b = b.shape.tree().boxes;
    state.stack.assign(1, NodePair{0, 0});
    while (!state.stack.empty()) {
        const NodePair top = state.stack.back();
        state.stack.pop_back();
        const TreeNode& x = tree_a.nodes[top.a];
        const TreeNode& y = tree_b.nodes[top.b];
        ++state.counts.box_tests;
        if (state.axes.separate(x.center, x.half, y.center, y.half)) continue;
        if (x.is_leaf() && y.is_leaf()) {
            for (std::uint32_t i = 0; i < x.count; ++i) {
                for (std::uint32_t j = 0; j < y.count; ++j) {
                    if (!visit(tree_a.order[x.begin + i], tree_b.order[y.begin + j])) return;
                }
            }
            continue;
        }
        // The larger box first: it is the one that overlaps for lack of detail.
        const bool descend_a = y.is_leaf() || (!x.is_leaf() && x.half.sum() >= y.half.sum());
        if (descend_a) {
            state.stack.push_back({x.begin, top.b});
            state.stack.push_back({x.begin + 1, top.b});
        } else {
            state.stack.push_back({top.a, y.begin});
            state.stack.push_back({top.a, y.begin + 1});
        }
    }
}

// Runs a query, and moves what the exact layer counted to the memory's counts.
template <class Visit>
void run_query(QueryMemory& memory, const PosedMesh& a, const PosedMesh& b, Visit&& visit) {
    QueryMemory::State& state = memory.state();
    state.pair.reset_counts();
    visit_near_pairs(state, a, b, [&](std::uint32_t i, std::uint32_t j) { return visit(i, j, state.pair); });
    add_stages(state.counts, state.pair.counts());
}

}  // namespace

bool intersects(const PosedMesh& a, const PosedMesh& b, QueryMemory& memory) {
    bool found = false;
    run_query(memory, a, b, [&](std::uint32_t i, std::uint32_t j, exact::BodyPair& pair) {
        found = pair.relation(i, j) != Relation::disjoint;
        return !found;
    });
    return found;
}

Relation relation(const PosedMesh& a, const PosedMesh& b, QueryMemory& memory) {
    Relation strongest = Relation::disjoint;
    run_query(memory, a, b, [&](std::uint32_t i, std::uint32_t j, exact::BodyPair& pair) {
        strongest = std::max(strongest, pair.relation(i, j));
        return strongest != Relation::crossing;
    });
    return strongest;
}

std::vector<TrianglePair> touching_triangles(const PosedMesh& a, const PosedMesh& b, QueryMemory& memory) {
    std::vector<TrianglePair> pairs;
    run_query(memory, a, b, [&](std::uint32_t i, std::uint32_t j, exact::BodyPair& pair) {
        if (pair.relation(i, j) != Relation::disjoint) pairs.push_back({i, j});
        return true;
    });
    std::ranges::sort(pairs);
    return pairs;
}

}  // namespace ecods
