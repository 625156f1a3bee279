#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "bvh/axes/separating_axes.hpp"
#include "bvh/walks/walk_two.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/overlap_bound.hpp"
#include "query/intersection/plane_bound.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/intersection/single_triangles.hpp"
#include "query/intersection/surface_intersection.hpp"
#include "query/shape/mesh_body.hpp"
#include "query/shape/other_units.hpp"

namespace ecods {

namespace {

// A MeshAt refers to a mesh and its pose, and copies neither.
struct MeshAt {
    MeshAt(const Posed<MeshShape>& posed) : shape(*posed.what), pose(posed.pose) {}
    MeshAt(const Posed<Shape>& posed) : shape(static_cast<const MeshShape&>(*posed.what)), pose(posed.pose) {}

    const MeshShape& shape;
    const Pose& pose;
};

// A Query holds the two bodies of a running query, and the memory that the query works in.
class Query {
  public:
    Query(const MeshAt& a, const MeshAt& b, QueryMemory& memory)
        : bodies_{{a.shape, a.pose}, {b.shape, b.pose}}, state_(QueryMemoryAccess::state(memory)) {
        ++state_.counts.queries;
    }
    Query(const Query&) = delete;
    Query& operator=(const Query&) = delete;
    ~Query() { leave_pair(); }

    Relation relation_of(std::uint32_t i, std::uint32_t j) {
        if (!pair_is_bound_) bind_pair();
        return state_.pair.relation(i, j);
    }

    // Returns the relation of the two triangles that the witness names. If a filter decides it, the bodies are not
    // bound.
    Relation relation_of_witness(const PairWitness& witness) {
        const std::optional<Relation> relation =
            filter_triangles(a().mesh(), witness.a, a().pose, b().mesh(), witness.b, b().pose);
        if (!relation) return relation_of(witness.a, witness.b);
        ++state_.counts.stages.triangle_tests;
        ++state_.counts.stages.filter_passes;
        return *relation;
    }

    // Returns the relation of triangles i and j, which the walk visits. `crosses` is true if a filter has proven that
    // the pair crosses.
    Relation relation_of(std::uint32_t i, std::uint32_t j, bool crosses) {
        if (!crosses) return relation_of(i, j);
        ++state_.counts.stages.triangle_tests;
        ++state_.counts.stages.filter_passes;
        return Relation::crossing;
    }

    // Binds the axes to the bodies. Returns the index of an axis that separates the roots' boxes, or -1 if no axis
    // does. Tries the axis `first` first.
    int bind_axes(int first = -1) {
        return state_.axes.bind({a().tree.boxes, a().pose.R}, {b().tree.boxes, b().pose.R}, b().pose.t - a().pose.t,
                                first);
    }

    // Calls ask(a, b) with both bodies in other units, and returns the result of ask(), if other units are better;
    // otherwise returns nullopt. Other units are considered only if floats bound nothing on the axes, as happens near
    // the ends of the range of doubles. Call this function after bind_axes().
    template <class Function>
    std::optional<std::invoke_result_t<Function, MeshAt, MeshAt>> ask_in_other_units(QueryMemory& memory,
                                                                                     const Function& ask) {
        if (state_.axes.sets()[0].b.margin[0] != std::numeric_limits<float>::infinity()) [[likely]]
            return std::nullopt;
        leave_pair();
        const Posed<MeshShape> posed_a(a().shape, a().pose), posed_b(b().shape, b().pose);
        const OtherUnits units(posed_a, posed_b);
        if (!units.are_better()) return std::nullopt;
        const Posed<MeshShape> other_a = units.of(posed_a), other_b = units.of(posed_b);
        return as_part(memory, [&] { return ask(MeshAt(other_a), MeshAt(other_b)); });
    }

    // Calls visit(i, j, crosses) for pairs of triangles until `visit` returns false. Visits every pair that shares a
    // point, and some others. `crosses` is true if the pair is known to cross. Call this function after bind_axes().
    template <class Visit>
    void visit_near_pairs(Visit&& visit) {
        if (!pair_is_bound_) state_.pair.forget_groups();
        const OverlapBound boxes(state_.axes.sets(), state_.counts);
        walk_two(a().tree.boxes, b().tree.boxes, state_.stack,
                 PlaneBound(boxes, a().tree.boxes, b().tree.boxes, state_.pair),
                 [&](std::uint32_t i, std::uint32_t j, bool crosses) {
                     return visit(i, j, crosses) && !state_.pair.are_parted();
                 });
    }

  private:
    // Ends the use of state_.pair and adds its counts to those of the memory. Call it before another query uses the
    // memory.
    void leave_pair() noexcept {
        if (pair_is_bound_) state_.counts.stages += state_.pair.counts();
        pair_is_bound_ = false;
    }

    // Binds state_.pair to the bodies. The binding happens at the first pair of triangles, so that queries without such
    // pairs do not pay for it.
    void bind_pair() {
        state_.pair.reset_counts();
        state_.pair.bind(a().ref(), b().ref());
        state_.pair.offer_groups(a().shape, b().shape);
        pair_is_bound_ = true;
    }

    const MeshBody& a() const noexcept { return bodies_.a; }
    const MeshBody& b() const noexcept { return bodies_.b; }

    MeshPair bodies_;
    QueryMemoryAccess::State& state_;
    bool pair_is_bound_ = false;
};

// Returns true if the witness names a triangle of each body. Otherwise the witness may name an axis; see axis_of().
bool holds_triangles(const PairWitness& witness, const MeshAt& a, const MeshAt& b) {
    return witness.a < a.shape.mesh().triangles().size() && witness.b < b.shape.mesh().triangles().size();
}
int axis_of(const PairWitness& witness) {
    return witness.a == PairWitness::none && witness.b < root_axis_count ? static_cast<int>(witness.b) : -1;
}
PairWitness witness_of(int axis) {
    return {PairWitness::none, static_cast<std::uint32_t>(axis)};
}

// Returns the relation of two meshes of one triangle each if a filter decides it. Returns nullopt otherwise, and for
// all other meshes.
std::optional<Relation> filter_singles(const MeshAt& a, const MeshAt& b, QueryMemory& memory) {
    if (a.shape.mesh().triangles().size() != 1 || b.shape.mesh().triangles().size() != 1) return std::nullopt;
    const std::optional<Relation> relation = filter_triangles(a.shape.mesh(), 0, a.pose, b.shape.mesh(), 0, b.pose);
    if (relation) {
        QueryCounts& counts = QueryMemoryAccess::state(memory).counts;
        ++counts.queries;
        ++counts.stages.triangle_tests;
        ++counts.stages.semi_static_passes;
    }
    return relation;
}

bool find_contact(const MeshAt& a, const MeshAt& b, QueryMemory& memory, PairWitness& witness) {
    if (const std::optional<Relation> relation = filter_singles(a, b, memory)) {
        const bool hits = *relation != Relation::apart;
        witness = hits ? PairWitness{0, 0} : PairWitness{};
        return hits;
    }
    Query query(a, b, memory);
    QueryCounts& counts = QueryMemoryAccess::state(memory).counts;
    if (holds_triangles(witness, a, b) && query.relation_of_witness(witness) != Relation::apart) {
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
    const auto again = [&](const MeshAt& x, const MeshAt& y) { return find_contact(x, y, memory, witness); };
    if (auto answer = query.ask_in_other_units(memory, again)) return *std::move(answer);
    witness = {};
    bool found = false;
    query.visit_near_pairs([&](std::uint32_t i, std::uint32_t j, bool crosses) {
        found = query.relation_of(i, j, crosses) != Relation::apart;
        if (found) witness = {i, j};
        return !found;
    });
    return found;
}

Relation find_relation(const MeshAt& a, const MeshAt& b, QueryMemory& memory) {
    if (const std::optional<Relation> relation = filter_singles(a, b, memory)) return *relation;
    Query query(a, b, memory);
    Relation strongest = Relation::apart;
    if (query.bind_axes() >= 0) return strongest;
    const auto again = [&](const MeshAt& x, const MeshAt& y) { return find_relation(x, y, memory); };
    if (auto answer = query.ask_in_other_units(memory, again)) return *std::move(answer);
    query.visit_near_pairs([&](std::uint32_t i, std::uint32_t j, bool crosses) {
        strongest = std::max(strongest, query.relation_of(i, j, crosses));
        return strongest != Relation::crossing;
    });
    return strongest;
}

std::vector<TrianglePair> find_triangles(const MeshAt& a, const MeshAt& b, QueryMemory& memory) {
    std::vector<TrianglePair> pairs;
    Query query(a, b, memory);
    if (query.bind_axes() >= 0) return pairs;
    const auto again = [&](const MeshAt& x, const MeshAt& y) { return find_triangles(x, y, memory); };
    if (auto answer = query.ask_in_other_units(memory, again)) return *std::move(answer);
    query.visit_near_pairs([&](std::uint32_t i, std::uint32_t j, bool crosses) {
        if (query.relation_of(i, j, crosses) != Relation::apart) pairs.push_back({i, j});
        return true;
    });
    std::ranges::sort(pairs);
    return pairs;
}

}  // namespace

bool surface::intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) {
    Asking asking(ask);
    return find_contact(a, b, asking.memory(), asking.witness());
}

bool surface::intersects(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    Asking asking(ask);
    return find_contact(a, b, asking.memory(), asking.witness());
}

bool surface::holds_axis(const PairWitness& witness) noexcept {
    return axis_of(witness) >= 0;
}

Relation surface::relation(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    return find_relation(a, b, Asking(ask).memory());
}

std::vector<TrianglePair> surface::intersecting_triangles(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                          const Ask& ask) {
    return find_triangles(a, b, Asking(ask).memory());
}

}  // namespace ecods
