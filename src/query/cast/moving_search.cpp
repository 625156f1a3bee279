#include "query/cast/moving_search.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "base/outward.hpp"
#include "bvh/axes/motion_axes.hpp"
#include "bvh/walks/walk_two.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "query/cast/contact_interval.hpp"
#include "query/cast/moving_pairs.hpp"

namespace ecods {
namespace {

// What waits to be looked at: a pair of nodes or leaves; or of triangles, of which only their boxes' time is known, or
// also a coarse or a fine bound of when they meet.
struct Waiting {
    enum class Kind : std::uint8_t { nodes, triangles, coarse, fine };

    std::int64_t time;  // the key of a time before which the two do not meet
    std::uint32_t order;
    std::uint32_t a, b;  // references of nodes, as bits, or triangles
    Kind kind;
};

// Earliest first; of those, what came last, so that the walk goes deep.
struct IsLater {
    bool operator()(const Waiting& x, const Waiting& y) const noexcept {
        return x.time != y.time ? x.time > y.time : x.order < y.order;
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
    std::vector<Waiting> queue;
    std::uint32_t order = 0;
    alignas(32) LaneTimes times{};

    void push(double time, Waiting::Kind kind, std::uint32_t a, std::uint32_t b) {
        queue.push_back({key_of(time), order++, a, b, kind});
        std::ranges::push_heap(queue, IsLater{});
    }
    void push(double time, TreeRef a, TreeRef b) {
        push(time, Waiting::Kind::nodes, std::bit_cast<std::uint32_t>(a), std::bit_cast<std::uint32_t>(b));
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
    std::vector<Waiting>& queue = memory_.queue;
    memory_.push(0, tree_a_.boxes.root, tree_b_.boxes.root);
    while (!queue.empty()) {
        std::ranges::pop_heap(queue, IsLater{});
        const Waiting top = queue.back();
        queue.pop_back();
        if (top.time > key_of(limit())) return;
        if (top.kind == Waiting::Kind::nodes) {
            visit(std::bit_cast<TreeRef>(top.a), std::bit_cast<TreeRef>(top.b));
        } else {
            const bool is_new = top.kind == Waiting::Kind::triangles;
            take({top.a, top.b}, double_of(top.time), is_new ? exact::Effort::coarse : exact::Effort::fine,
                 top.kind == Waiting::Kind::fine);
        }
    }
}

template <class X, class Y>
std::uint64_t MovingSearch::find_meeting(const X& x, const Y& y) {
    ++counts_.box_tests;
    return meeting_mask(memory_.axes.sets(), round_up(limit()), x, y, memory_.times);
}

void MovingSearch::visit(TreeRef a, TreeRef b) {
    const MeshBvh &tree_a = tree_a_.boxes, &tree_b = tree_b_.boxes;
    const auto each = [&](std::uint64_t mask, auto&& push) {
        for (LanePairs pairs(mask); pairs.more(); pairs.next()) {
            const std::size_t i = pairs.i(), j = pairs.j();
            push(static_cast<double>(memory_.times[tree_width * i + j]), i, j);
        }
    };
    if (a.is_leaf() && b.is_leaf()) {
        const TreeLeaf &x = tree_a.leaves[a.index()], &y = tree_b.leaves[b.index()];
        each(find_meeting(x, y), [&](double time, std::size_t i, std::size_t j) {
            memory_.push(time, Waiting::Kind::triangles, x.triangle[i], y.triangle[j]);
        });
    } else if (a.is_leaf()) {
        const BvhNode& y = tree_b.nodes[b.index()];
        const std::uint64_t mask = find_meeting(tree_a.leaves[a.index()], y);
        for (std::size_t j = 0; j < y.count; ++j) {
            float least = 2;
            for (LanePairs pairs(mask); pairs.more(); pairs.next()) {
                if (pairs.j() == j) least = std::min(least, memory_.times[tree_width * pairs.i() + j]);
            }
            if (least <= 1) memory_.push(static_cast<double>(least), a, y.child[j]);
        }
    } else if (b.is_leaf()) {
        const BvhNode& x = tree_a.nodes[a.index()];
        const std::uint64_t mask = find_meeting(x, tree_b.leaves[b.index()]);
        for (std::size_t i = 0; i < x.count; ++i) {
            float least = 2;
            for (LanePairs pairs(mask); pairs.more(); pairs.next()) {
                if (pairs.i() == i) least = std::min(least, memory_.times[tree_width * i + pairs.j()]);
            }
            if (least <= 1) memory_.push(static_cast<double>(least), x.child[i], b);
        }
    } else {
        const BvhNode &x = tree_a.nodes[a.index()], &y = tree_b.nodes[b.index()];
        each(find_meeting(x, y),
             [&](double time, std::size_t i, std::size_t j) { memory_.push(time, x.child[i], y.child[j]); });
    }
}

// A time that rounds to the limit may be above it.
void MovingSearch::take(const TrianglePair& triangles, double from, exact::Effort effort, bool is_next) {
    const double to = std::min(next_up(limit()), 1.0);
    if (key_of(from) > key_of(to)) return;
    const auto time = memory_.pairs.bound(triangles, from, to, effort);
    if (!time || key_of(time->from) > key_of(limit())) return;
    const std::vector<Waiting>& queue = memory_.queue;
    const bool is_fine = effort == exact::Effort::fine;
    if (!is_next && !queue.empty() && key_of(time->from) > queue.front().time) {
        const Waiting::Kind kind = is_fine ? Waiting::Kind::fine : Waiting::Kind::coarse;
        return memory_.push(time->from, kind, triangles.a, triangles.b);
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
