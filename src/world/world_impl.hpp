// The inside of a World.
#pragma once

#include <cstdint>
#include <memory>

#include "broad_phase/overlap_tracker.hpp"
#include "ecods/world.hpp"
#include "trace/trace_writer.hpp"
#include "world/bodies.hpp"
#include "world/changes.hpp"
#include "world/collisions.hpp"
#include "world/mesh_shapes.hpp"
#include "world/two_body_tests.hpp"
#include "world/workers.hpp"

namespace ecods {

struct World::Impl {
    explicit Impl(const WorldOptions& options);

    // A body of `kind` comes, in place of `replaced` if that is not null. Throws MissingTest.
    void require_tests_for(ShapeKind kind, const Shape* replaced) const;

    // ---- pairs of bodies
    OrderedTest test_of(ProxyPair pair) const { return tests.find(bodies[pair.a].kind, bodies[pair.b].kind); }
    bool test(ProxyPair pair, QueryMemory& memory) const;
    bool test_again(VerdictIndex verdict, QueryMemory& memory);

    // ---- update, in this order
    void update();
    void take_over_candidates();
    void take_over_events();
    void test_pairs();
    void commit();

    std::uint64_t digest() const;

    // The number of a shape in the trace, written before a call that brings it in; 0 without a trace.
    void trace_body(ProxyIndex proxy, std::uint64_t shape_number) noexcept;  // as the calls that make it
    std::uint64_t traced_number(const std::shared_ptr<const Shape>& shape) {
        return trace ? trace->number_of(shape) : 0;
    }

    Bodies bodies;
    Changes changes;
    MeshShapes mesh_shapes;
    TwoBodyTests tests;
    OverlapTracker broad_phase;
    Collisions collisions;
    Workers workers;
    std::unique_ptr<TraceWriter> trace;  // null: none is under way
    Statistics statistics;               // sums; the rest is filled in on request
};

// The shape's box, checked: what enters the broad phase must be ordered.
Aabb box_for(const Shape& shape, const Pose& pose, BodyId body = {}, const ListIndex& index = {});
void require_valid(const Pose& pose, BodyId body = {}, const ListIndex& index = {});
void require_usable(const std::shared_ptr<const Shape>& shape);  // throws NullArgument, and
void require_mesh_kind(const Shape& shape);                      // NotSupported: the kind of meshes, but no MeshShape

}  // namespace ecods
