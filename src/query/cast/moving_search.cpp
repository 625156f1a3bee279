#include "query/cast/moving_search.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "base/outward.hpp"
#include "bvh/motion_axes.hpp"
#include "bvh/walk_two.hpp"
#include "exact/measure/bound_meeting.hpp"
#include "exact/measure/first_meeting.hpp"
#include "exact/point/frame.hpp"

namespace ecods {
namespace {

// What waits to be looked at: a pair of nodes or leaves, or of triangles, whose first time may be bounded in doubles.
struct Waiting {
    enum class Kind : std::uint8_t { nodes, triangles, bounded };

    std::int64_t time;  // the key of a time before which the two do not meet
    std::uint32_t order;
    Kind kind;
    TreeRef a, b;
    TrianglePair triangles;
};

// Earliest first; of those, what came last, so that the walk goes deep.
struct IsLater {
    bool operator()(const Waiting& x, const Waiting& y) const noexcept {
        return x.time != y.time ? x.time > y.time : x.order < y.order;
    }
};

auto rank(const FirstContact& contact) {
    return std::tuple(key_of(contact.time), contact.kind, contact.a.triangle, contact.a.corner, contact.b.triangle,
                      contact.b.corner, contact.a.kind);
}

FirstContact contact_of(const TrianglePair& triangles, const exact::Meeting& meeting) {
    using exact::FeatureKind;
    constexpr auto vertex = Feature::Kind::vertex, edge = Feature::Kind::edge, face = Feature::Kind::face;
    static_assert(static_cast<int>(ClosestKind::vertex_vertex) == static_cast<int>(FeatureKind::vertex_vertex) &&
                  static_cast<int>(ClosestKind::edge_edge) == static_cast<int>(FeatureKind::edge_edge));
    const exact::FeaturePair& pair = meeting.features;
    FirstContact result;
    result.time = meeting.time;
    result.kind = static_cast<ClosestKind>(pair.kind);
    Feature::Kind kind_a = vertex, kind_b = vertex;
    if (pair.kind == FeatureKind::vertex_edge) (pair.vertex_side == 0 ? kind_b : kind_a) = edge;
    if (pair.kind == FeatureKind::vertex_face) (pair.vertex_side == 0 ? kind_b : kind_a) = face;
    if (pair.kind == FeatureKind::edge_edge) kind_a = kind_b = edge;
    result.a = {kind_a, triangles.a, pair.a};
    result.b = {kind_b, triangles.b, pair.b};
    return result;
}

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
    exact::Frame frame;  // of a and b at the start, then at the end
    MotionAxes axes;
    std::vector<Waiting> queue;
    std::uint32_t order = 0;
    alignas(32) LaneTimes times{};

    void push(double time, Waiting::Kind kind, TreeRef a, TreeRef b, const TrianglePair& triangles) {
        queue.push_back({key_of(time), order++, kind, a, b, triangles});
        std::ranges::push_heap(queue, IsLater{});
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
    const std::array<exact::BodyRef, 4> bodies{{{&a_.what->mesh(), &tree_a_.extent, &a_.from},
                                                {&b_.what->mesh(), &tree_b_.extent, &b_.from},
                                                {&a_.what->mesh(), &tree_a_.extent, &a_.to},
                                                {&b_.what->mesh(), &tree_b_.extent, &b_.to}}};
    memory_.frame.bind(bodies);
    const bool has_witness =
        witness.a < a_.what->mesh().triangles().size() && witness.b < b_.what->mesh().triangles().size();
    if (has_witness) take_bounded({witness.a, witness.b}, 0);
    memory_.queue.clear();  // the witness comes again
    walk();
    return first_;
}

void MovingSearch::walk() {
    std::vector<Waiting>& queue = memory_.queue;
    memory_.push(0, Waiting::Kind::nodes, tree_a_.boxes.root, tree_b_.boxes.root, {});
    while (!queue.empty()) {
        std::ranges::pop_heap(queue, IsLater{});
        const Waiting top = queue.back();
        queue.pop_back();
        if (top.time > key_of(limit())) return;
        switch (top.kind) {
            case Waiting::Kind::nodes:
                visit(top.a, top.b);
                break;
            case Waiting::Kind::triangles:
                take_bounded(top.triangles, double_of(top.time));
                break;
            case Waiting::Kind::bounded:
                decide(top.triangles);
                break;
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
    const auto each = [&](std::uint64_t mask, auto&& child_a, auto&& child_b, const auto& triangles) {
        for (LanePairs pairs(mask); pairs.more(); pairs.next()) {
            const std::size_t i = pairs.i(), j = pairs.j();
            const double time = static_cast<double>(memory_.times[tree_width * i + j]);
            const auto pair = triangles(i, j);
            memory_.push(time, pair ? Waiting::Kind::triangles : Waiting::Kind::nodes, child_a(i), child_b(j),
                         pair.value_or(TrianglePair{}));
        }
    };
    const auto nothing = [](std::size_t, std::size_t) { return std::optional<TrianglePair>(); };
    if (a.is_leaf() && b.is_leaf()) {
        const TreeLeaf &x = tree_a.leaves[a.index()], &y = tree_b.leaves[b.index()];
        const auto same_a = [&](std::size_t) { return a; };
        const auto same_b = [&](std::size_t) { return b; };
        each(find_meeting(x, y), same_a, same_b, [&](std::size_t i, std::size_t j) {
            return std::optional(TrianglePair{x.triangle[i], y.triangle[j]});
        });
    } else if (a.is_leaf()) {
        const BvhNode& y = tree_b.nodes[b.index()];
        const std::uint64_t mask = find_meeting(tree_a.leaves[a.index()], y);
        for (std::size_t j = 0; j < y.count; ++j) {
            float least = 2;
            for (LanePairs pairs(mask); pairs.more(); pairs.next()) {
                if (pairs.j() == j) least = std::min(least, memory_.times[tree_width * pairs.i() + j]);
            }
            if (least <= 1) memory_.push(static_cast<double>(least), Waiting::Kind::nodes, a, y.child[j], {});
        }
    } else if (b.is_leaf()) {
        const BvhNode& x = tree_a.nodes[a.index()];
        const std::uint64_t mask = find_meeting(x, tree_b.leaves[b.index()]);
        for (std::size_t i = 0; i < x.count; ++i) {
            float least = 2;
            for (LanePairs pairs(mask); pairs.more(); pairs.next()) {
                if (pairs.i() == i) least = std::min(least, memory_.times[tree_width * i + pairs.j()]);
            }
            if (least <= 1) memory_.push(static_cast<double>(least), Waiting::Kind::nodes, x.child[i], b, {});
        }
    } else {
        const BvhNode &x = tree_a.nodes[a.index()], &y = tree_b.nodes[b.index()];
        each(
            find_meeting(x, y), [&](std::size_t i) { return x.child[i]; }, [&](std::size_t j) { return y.child[j]; },
            nothing);
    }
}

// A time that is rounded to the limit may be above it.
void MovingSearch::take_bounded(const TrianglePair& triangles, double from) {
    ++counts_.distances.enclosures;
    const Triangle &s = a_.what->mesh().triangles()[triangles.a], &t = b_.what->mesh().triangles()[triangles.b];
    exact::Frame& frame = memory_.frame;
    exact::MovingPoints points;
    for (std::size_t i = 0; i < 3; ++i) {
        points.start[i] = frame.rounded(0, s[i]);
        points.start[3 + i] = frame.rounded(1, t[i]);
        points.end[i] = frame.rounded(2, s[i]);
        points.end[3 + i] = frame.rounded(3, t[i]);
    }
    points.error = frame.delta();
    const double to = std::min(next_up(limit()), 1.0);
    const std::optional<double> time = exact::bound_first_meeting(points, std::min(from, to), to);
    if (!time || key_of(*time) > key_of(limit())) return;
    const std::vector<Waiting>& queue = memory_.queue;
    if (queue.empty() || key_of(*time) <= queue.front().time) return decide(triangles);
    memory_.push(*time, Waiting::Kind::bounded, {}, {}, triangles);
}

void MovingSearch::decide(const TrianglePair& triangles) {
    ++counts_.distances.exact;
    const Mesh &mesh_a = a_.what->mesh(), &mesh_b = b_.what->mesh();
    const Triangle &s = mesh_a.triangles()[triangles.a], &t = mesh_b.triangles()[triangles.b];
    exact::PosedPoints<12> points;
    for (std::size_t i = 0; i < 3; ++i) {
        points[i] = {&a_.from, &mesh_a.vertices()[s[i]]};
        points[3 + i] = {&b_.from, &mesh_b.vertices()[t[i]]};
        points[6 + i] = {&a_.to, &mesh_a.vertices()[s[i]]};
        points[9 + i] = {&b_.to, &mesh_b.vertices()[t[i]]};
    }
    const std::optional<exact::Meeting> meeting = exact::with_integers(points, [](const auto& integers) {
        exact::MovingTriangles moving(integers);
        return exact::first_meeting(moving);
    });
    if (!meeting || key_of(meeting->time) > key_of(at_most_)) return;
    const FirstContact contact = contact_of(triangles, *meeting);
    if (!first_ || rank(contact) < rank(*first_)) first_ = contact;
}

}  // namespace ecods
