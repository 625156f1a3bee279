#include "query/distance/distance_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/double_key.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

struct DistanceSearch::Memory final : QueryMemoryPart {
    struct Candidate {
        float lower;  // squared, in units
        TrianglePair triangles;
    };

    TriangleDistances pair;
    DistanceAxes axes;
    FarGap far;
    NearestQueue queue;
    alignas(32) LaneSquares squares{};
    LeavesOnAxes leaves{};
    TriangleBatch batch{};
    TriangleSquares bounds{};
    std::vector<Candidate> candidates;  // of which floats know no more
    std::vector<OpenPair> open;
};

namespace {

// So many pairs of nodes that overlap are visited before the bodies are tested for a common point. A walk that goes
// deep mostly meets triangles that share one long before; hundreds of nodes overlap where large bodies nearly touch,
// too, and there the test would be wasted.
constexpr std::uint32_t overlap_max = 1024;

exact::BodyRef body_of(const Posed<MeshShape>& posed, const MeshTree& tree) {
    return {&posed.what->mesh(), &tree.extent, &posed.pose};
}

}  // namespace

DistanceSearch::Memory& DistanceSearch::memory_of(QueryMemory& memory) {
    auto& part = QueryMemoryAccess::state(memory).distance;
    if (!part) part = std::make_unique<Memory>();
    return static_cast<Memory&>(*part);
}

DistanceSearch::DistanceSearch(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory)
    : a_(a),
      b_(b),
      tree_a_(MeshShapeAccess::tree(*a.what)),
      tree_b_(MeshShapeAccess::tree(*b.what)),
      query_memory_(memory),
      memory_(memory_of(memory)),
      counts_(QueryMemoryAccess::state(memory).counts) {
    ++counts_.queries;
    memory_.candidates.clear();
    memory_.open.clear();
    memory_.batch.count = 0;
    memory_.pair.bind(body_of(a_, tree_a_), body_of(b_, tree_b_));
    const PosedTree tree_a{tree_a_.boxes, a_.pose.R}, tree_b{tree_b_.boxes, b_.pose.R};
    const Vec3 d = b_.pose.t - a_.pose.t;
    memory_.axes.bind(tree_a, tree_b, d);
    memory_.far.bind(memory_.axes, tree_a, tree_b, d);
}

DistanceSearch::~DistanceSearch() {
    leave_relations();
}

std::vector<OpenPair>& DistanceSearch::open_pairs() noexcept {
    return memory_.open;
}
TriangleDistances& DistanceSearch::exact_pair() noexcept {
    ++counts_.distances.exact;
    return memory_.pair;
}
const DistanceAxes& DistanceSearch::axes() const noexcept {
    return memory_.axes;
}
const FarGap& DistanceSearch::far_gap() const noexcept {
    return memory_.far;
}
float DistanceSearch::bound_above(double distance) const noexcept {
    return far_gap().is_far() ? far_gap().rank_above(distance) : axes().square_above(distance);
}
const std::array<DistanceSet, 2>& DistanceSearch::sets() const noexcept {
    return memory_.axes.sets();
}

void DistanceSearch::run(const DistanceGoal& goal, const PairWitness& witness) {
    goal_ = goal;
    walk(witness);
    if (!is_decided()) enclose_candidates();
}

bool DistanceSearch::can_refer() const noexcept {
    return memory_.pair.can_refer();
}

double DistanceSearch::find_distance(const PairWitness& witness) {
    refers_ = true;
    walk(witness);
    if (is_zero_) return 0;
    const TrianglePair first{nearest_.a, nearest_.b};
    double least = exact_pair().distance(first.a, first.b);
    refer_to(first, least);
    for (const OpenPair& open : memory_.open) {
        // Rounding is monotone: it takes no number below one that is a double.
        if (key_of(open.interval.lower) < key_of(least)) lower_distance(open.triangles, least);
    }
    drop_candidates();
    for (const Memory::Candidate& candidate : memory_.candidates) {
        if (candidate.lower > limit_) break;
        if (memory_.pair.is_not_nearer(candidate.triangles)) continue;
        if (key_of(enclosure(candidate.triangles).lower) < key_of(least)) lower_distance(candidate.triangles, least);
    }
    memory_.open.clear();
    return least;
}

// Measures a pair of triangles unless it is proven not to be nearer than the one referred to, which is at `least`.
void DistanceSearch::lower_distance(const TrianglePair& triangles, double& least) {
    if (memory_.pair.is_not_nearer(triangles)) return;
    const double distance = exact_pair().distance(triangles.a, triangles.b);
    if (key_of(distance) >= key_of(least)) return;
    least = distance;
    refer_to(triangles, least);
}

void DistanceSearch::refer_to(const TrianglePair& nearest, double distance) {
    nearest_ = {nearest.a, nearest.b};
    memory_.pair.refer_to(nearest);
    limit_ = std::min(limit_, bound_above(distance));
}

template <class X, class Y>
std::uint64_t DistanceSearch::find_near(const X& x, const Y& y, LaneSquares& bounds) noexcept {
    ++counts_.box_tests;
    if (far_gap().is_far()) return far_mask(far_gap(), limit_, x, y, bounds);
    return near_mask(sets(), direction_, limit_, x, y, bounds);
}

void DistanceSearch::walk(const PairWitness& witness) {
    set_limit();
    const bool has_witness =
        witness.a < a_.what->mesh().triangles().size() && witness.b < b_.what->mesh().triangles().size();
    if (has_witness) {
        enclose({witness.a, witness.b});
        memory_.open.clear();  // it comes again
    } else if (!far_gap().is_far() && (goal_.stop_at < 0 || !is_apart(witness))) {
        dive();
    }
    if (is_decided()) return;
    walk_nearest(tree_a_.boxes, tree_b_.boxes, memory_.queue, *this);
    if (!is_decided()) bound_batch();
}

bool DistanceSearch::is_decided() const noexcept {
    return is_zero_ || key_of(upper_) <= key_of(goal_.stop_at);
}

// Straight down to two triangles, for a first upper bound. They come again in the walk.
void DistanceSearch::dive() {
    const MeshBvh &a = tree_a_.boxes, &b = tree_b_.boxes;
    NodePair at{a.root, b.root};
    std::optional<TrianglePair> found;
    while (!found) {
        with_nodes(a, b, at, [&](const auto& x, const auto& y) {
            const LanePair lanes = nearest_lanes(sets()[0], x, y);
            if constexpr (requires { x.child; }) at.a = x.child[lanes.i];
            if constexpr (requires { y.child; }) at.b = y.child[lanes.j];
            if constexpr (requires {
                              x.triangle;
                              y.triangle;
                          }) {
                found = {x.triangle[lanes.i], y.triangle[lanes.j]};
            } else {
                ++counts_.box_tests;
            }
        });
    }
    enclose(*found);
    memory_.open.clear();
}

bool DistanceSearch::visits(const NearPair& pair) {
    if (pair.square > 0 || far_gap().is_far() || ++overlap_count_ != overlap_max) return true;
    leave_relations();
    is_zero_ = intersects(a_, b_, query_memory_);
    --counts_.queries;  // it is a part of this one
    return !is_zero_;
}

bool DistanceSearch::take(const TreeLeaf& x, const TreeLeaf& y) {
    LanePairs pairs(find_near(x, y, memory_.squares));
    if (!pairs.more()) return true;
    if (far_gap().is_far()) return take_far(x, y, pairs);
    put_on_axes(sets()[0], x, y, memory_.leaves);
    for (; pairs.more(); pairs.next()) {
        const std::size_t i = pairs.i(), j = pairs.j();
        memory_.batch.add(memory_.leaves, i, j, {x.triangle[i], y.triangle[j]});
        if (memory_.batch.is_full() && !bound_batch()) return false;
    }
    return true;
}

// Where bodies are far apart, floats know no more of two triangles than of their nodes.
bool DistanceSearch::take_far(const TreeLeaf& x, const TreeLeaf& y, LanePairs pairs) {
    for (; pairs.more(); pairs.next()) {
        const std::size_t i = pairs.i(), j = pairs.j();
        if (memory_.squares[tree_width * i + j] > limit_) continue;
        enclose({x.triangle[i], y.triangle[j]});
        if (is_decided()) return false;
    }
    return true;
}

// Bounds the triangles that were put together. Returns whether the walk goes on.
bool DistanceSearch::bound_batch() {
    TriangleBatch& batch = memory_.batch;
    counts_.distances.triangle_bounds += batch.count;
    bound_triangles(sets()[0], batch, memory_.bounds);
    for (std::size_t lane = 0; lane < batch.count; ++lane) {
        take(lane);
        if (is_decided()) return false;
    }
    batch.count = 0;
    return true;
}

// Where floats know nothing, doubles do: bodies that intersect are noticed at once, and many pairs need not be kept.
void DistanceSearch::take(std::size_t lane) {
    const TrianglePair& triangles = memory_.batch.pairs[lane];
    const float lower = memory_.bounds.lower[lane], upper = memory_.bounds.upper[lane];
    // Even beyond the limit: that there is nothing within it is seen along the gap soonest.
    if (upper < direction_square_ && upper > 0) set_direction(lane);
    if (lower > limit_) return;
    if (!(lower > 0)) return enclose(triangles);
    if (upper * sets()[0].square <= limit_) set_upper(axes().distance_above(upper), triangles);
    memory_.candidates.push_back({lower, triangles});
}

void DistanceSearch::set_direction(std::size_t lane) {
    direction_square_ = memory_.bounds.upper[lane];
    const double factor = (1 - 0x1p-18) / std::sqrt(static_cast<double>(direction_square_));
    for (std::size_t k = 0; k < 3; ++k) {
        direction_[k] = static_cast<float>(static_cast<double>(memory_.bounds.between[k][lane]) * factor);
    }
}

DistanceInterval DistanceSearch::enclosure(const TrianglePair& triangles) {
    ++counts_.distances.enclosures;
    return memory_.pair.enclose(triangles.a, triangles.b);
}

void DistanceSearch::enclose(const TrianglePair& triangles) {
    if (refers_ && memory_.pair.is_not_nearer(triangles)) return;
    const DistanceInterval interval = enclosure(triangles);
    if (key_of(interval.lower) <= 0 && relation(triangles) != Relation::disjoint) {
        is_zero_ = true;
        nearest_ = {triangles.a, triangles.b};
        return;
    }
    if (key_of(interval.lower) > key_of(std::min(goal_.at_most, upper_))) return;
    if (nearest_.a == PairWitness::none) nearest_ = {triangles.a, triangles.b};  // even if it is infinitely far
    // What ties with the nearest pair shares features with it, or is as far across parallel faces: more of the kind
    // come.
    const bool ties = refers_ && !memory_.open.empty();
    set_upper(interval.upper, triangles);
    if (ties) {
        // What is left out from now on may be left out because of this pair, which therefore must not be lost.
        const TrianglePair nearest{nearest_.a, nearest_.b};
        memory_.pair.refer_to(nearest);
        memory_.open.push_back({{}, nearest});
    }
    memory_.open.push_back({interval, triangles});
}

void DistanceSearch::set_upper(double upper, const TrianglePair& triangles) {
    if (!(key_of(upper) < key_of(upper_))) return;
    upper_ = upper;
    nearest_ = {triangles.a, triangles.b};
    set_limit();
}

void DistanceSearch::set_limit() {
    floor_ = upper_;
    if (goal_.absolute > 0 || goal_.relative > 0) {
        floor_ = std::max({upper_ - goal_.absolute, upper_ / (1 + goal_.relative), 0.0});
    }
    limit_ = bound_above(std::min(goal_.at_most, floor_));
}

// Those that are farther than the limit has become; the others are sorted.
void DistanceSearch::drop_candidates() {
    auto& candidates = memory_.candidates;
    std::erase_if(candidates, [&](const Memory::Candidate& c) { return c.lower > limit_; });
    std::ranges::sort(candidates, {}, &Memory::Candidate::lower);
}

// From the nearest on, until those that are left are farther than one that was enclosed.
void DistanceSearch::enclose_candidates() {
    drop_candidates();
    for (const Memory::Candidate& candidate : memory_.candidates) {
        if (candidate.lower > limit_) break;
        enclose(candidate.triangles);
        if (is_decided()) return;
    }
    const std::int64_t key = key_of(std::min(goal_.at_most, upper_));
    std::erase_if(memory_.open, [&](const OpenPair& open) { return key_of(open.interval.lower) > key; });
}

Relation DistanceSearch::relation(const TrianglePair& triangles) {
    TriangleRelations& relations = QueryMemoryAccess::state(query_memory_).pair;
    if (!has_relations_) {
        relations.reset_counts();
        relations.bind(body_of(a_, tree_a_), body_of(b_, tree_b_));
        has_relations_ = true;
    }
    return relations.relation(triangles.a, triangles.b);
}

void DistanceSearch::leave_relations() noexcept {
    if (!has_relations_) return;
    counts_.stages += QueryMemoryAccess::state(query_memory_).pair.counts();
    has_relations_ = false;
}

}  // namespace ecods
