#include "query/cast/moving_search.hpp"

#include <algorithm>
#include <utility>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "base/outward.hpp"
#include "bvh/axes/motion_axes.hpp"
#include "bvh/walks/waiting.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "query/cast/contact_interval.hpp"
#include "query/cast/moving_pairs.hpp"

namespace ecods {
namespace {

// A pair of nodes or leaves that waits; or of triangles, of which only their boxes' time is known, or also a coarse or
// a fine bound of when they meet.
struct Candidate {
    enum class Kind : std::uint8_t { nodes, triangles, coarse, fine };

    std::int64_t time;  // the key of a time before which the two do not meet
    std::uint32_t order;
    Kind kind;
    NodePair nodes;
    TrianglePair triangles;

    // Earliest first; of those, what came last, so that the walk goes deep.
    friend bool operator<(const Candidate& x, const Candidate& y) noexcept {
        return x.time != y.time ? x.time < y.time : x.order > y.order;
    }
};

// The only box of a node: that of the root.
BvhNode root_of(const MeshBvh& tree) {
    BvhNode node{};
    for (std::size_t k = 0; k < 3; ++k) {
        node.center[k].fill(tree.root_center[k]);
        node.half[k].fill(tree.root_half[k]);
    }
    node.count = 1;
    return node;
}

}  // namespace

struct MovingSearch::Memory final : QueryMemoryPart {
    MovingPairs pairs;
    MotionAxes axes;
    Waiting<Candidate> queue;
    std::uint32_t order = 0;
    alignas(32) LaneTimes times{};

    void push(double time, const NodePair& nodes) {
        queue.push({key_of(time), order++, Candidate::Kind::nodes, nodes, {}});
    }
    void push(double time, Candidate::Kind kind, const TrianglePair& triangles) {
        queue.push({key_of(time), order++, kind, {}, triangles});
    }
};

MovingSearch::Memory& MovingSearch::memory_of(QueryMemory& memory) {
    auto& part = QueryMemoryAccess::state(memory).moving;
    if (!part) part = std::make_unique<Memory>();
    return static_cast<Memory&>(*part);
}

MovingSearch::MovingSearch(const Moving<MeshShape>& a, const Moving<MeshShape>& b, QueryMemory& memory)
    : a_(a),
      b_(b),
      tree_a_(MeshShapeAccess::tree(*a.what)),
      tree_b_(MeshShapeAccess::tree(*b.what)),
      memory_(memory_of(memory)),
      counts_(QueryMemoryAccess::state(memory).counts) {
    ++counts_.queries;
    memory_.queue.clear();
    memory_.order = 0;
    memory_.axes.bind({tree_a_.boxes, a.from.R, a.to.R}, {tree_b_.boxes, b.from.R, b.to.R}, b.from.t - a.from.t,
                      b.to.t - a.to.t);
}

std::optional<float> MovingSearch::first_of_boxes() {
    const BvhNode x = root_of(tree_a_.boxes), y = root_of(tree_b_.boxes);
    if (meeting_mask(memory_.axes.sets(), 1, x, y, memory_.times) == 0) return std::nullopt;
    return memory_.times[0];
}

double MovingSearch::limit() const noexcept {
    return first_ ? first_->time : at_most_;
}

std::optional<FirstContact> MovingSearch::run(double at_most, const PairWitness& witness) {
    at_most_ = at_most;
    memory_.pairs.bind(a_, b_, counts_.casts);
    const bool has_witness =
        witness.a < a_.what->mesh().triangles().size() && witness.b < b_.what->mesh().triangles().size();
    if (has_witness) take({witness.a, witness.b}, 0, exact::Effort::fine, true);
    memory_.queue.clear();  // the witness comes again
    walk();
    if (first_ && key_of(first_->time) == key_of(at_most) && key_of(at_most) < key_of(1.0) && !is_by_then_) {
        return std::nullopt;
    }
    return first_;
}

void MovingSearch::walk() {
    memory_.push(0, {tree_a_.boxes.root, tree_b_.boxes.root});
    while (!memory_.queue.is_empty()) {
        const Candidate top = memory_.queue.pop();
        if (top.time > key_of(limit())) return;
        if (top.kind == Candidate::Kind::nodes) {
            visit(top.nodes);
        } else {
            const bool is_new = top.kind == Candidate::Kind::triangles;
            take(top.triangles, double_of(top.time), is_new ? exact::Effort::coarse : exact::Effort::fine,
                 top.kind == Candidate::Kind::fine);
        }
    }
}

void MovingSearch::visit(const NodePair& nodes) {
    const auto bound = [&](const auto& x, const auto& y) {
        ++counts_.box_tests;
        return meeting_mask(memory_.axes.sets(), round_up(limit()), x, y, memory_.times);
    };
    const auto time_of = [&](LanePairs lanes) { return static_cast<double>(least_of(memory_.times, lanes)); };
    const auto push = [&](const NodePair& children, LanePairs lanes) { memory_.push(time_of(lanes), children); };
    open_pair(tree_a_.boxes, tree_b_.boxes, nodes, bound, push, [&](const TreeLeaf& x, const TreeLeaf& y) {
        for (LanePairs lanes(bound(x, y)); lanes.more(); lanes.next()) {
            const TrianglePair triangles{x.triangle[lanes.i()], y.triangle[lanes.j()]};
            memory_.push(time_of(lanes.first()), Candidate::Kind::triangles, triangles);
        }
        return true;
    });
}

// A time that rounds to the limit may be above it.
void MovingSearch::take(const TrianglePair& triangles, double from, exact::Effort effort, bool is_next) {
    const double to = std::min(next_up(limit()), 1.0);
    if (key_of(from) > key_of(to)) return;
    const auto time = memory_.pairs.bound(triangles, from, to, effort);
    if (!time || key_of(time->from) > key_of(limit())) return;
    const Waiting<Candidate>& queue = memory_.queue;
    const bool is_fine = effort == exact::Effort::fine;
    if (!is_next && !queue.is_empty() && key_of(time->from) > queue.front().time) {
        return memory_.push(time->from, is_fine ? Candidate::Kind::fine : Candidate::Kind::coarse, triangles);
    }
    if (!is_fine) return take(triangles, time->from, exact::Effort::fine, is_next);
    const auto meeting = memory_.pairs.decide(triangles, *time, to);
    if (!meeting || key_of(meeting->time) > key_of(at_most_)) return;
    is_by_then_ = is_by_then_ || !meeting->is_late || key_of(meeting->time) < key_of(at_most_);
    FirstContact contact;
    contact.time = meeting->time;
    exact::name_features(contact, meeting->features, triangles);
    if (!first_ || rank_in_time(contact) < rank_in_time(*first_)) first_ = contact;
}

}  // namespace ecods
