// The inside of a World.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "broad_phase/overlap_tracker.hpp"
#include "ecods/world.hpp"
#include "geometry/find_invalid.hpp"
#include "query/convex/solid_pair.hpp"
#include "trace/trace_writer.hpp"
#include "world/answer_digest.hpp"
#include "world/bodies.hpp"
#include "world/changes.hpp"
#include "world/closeness.hpp"
#include "world/mesh_shapes.hpp"
#include "world/pair_verdicts.hpp"
#include "world/solid_pairs.hpp"
#include "world/two_body_tests.hpp"
#include "world/workers.hpp"

namespace ecods {

struct World::Impl {
    explicit Impl(const WorldOptions& options);

    // A body of `kind` comes, in place of `replaced` if that is not null. Throws NotSupported, also where a
    // question is given.
    void require_tests_for(ShapeKind kind, const Shape* replaced, std::optional<Question> question = {}) const;

    // The question is to be asked of pairs of any bodies, or of these two kinds. Throw NotSupported.
    void require_answers(Question question) const;
    void require_answer(ShapeKind a, ShapeKind b, Question question) const;

    // ---- pairs of bodies
    OrderedTest test_of(ProxyPair pair) const { return tests.find(bodies[pair.a].kind, bodies[pair.b].kind); }
    template <class Question, class... Arguments>
    auto ask(ProxyPair pair, Question question, Arguments&&... arguments) const {
        return test_of(pair).ask(bodies[pair.a].posed(), bodies[pair.b].posed(), question, arguments...);
    }
    SolidRelation relate(ProxyPair pair, QueryMemory& memory) const;  // throws NotSupported

    // The pairs of convex solids whose boxes are not proven to be further apart than the limit, without those that are
    // filtered out; in no promised order. Throws SingularPose.
    struct NearConvexPairs {
        ProxyPairs pairs;
        std::vector<convex::SolidInMemory> solids;  // by proxy
    };
    NearConvexPairs near_convex_pairs(double limit) const;
    // Asks about each of them by run(count, run_one(i, memory)), also when one throws; ask(a, b, memory) gives what the
    // answer has, or nothing. Ascending.
    template <class Answer, class Run, class Ask>
    std::vector<Answer> ask_convex_pairs(double limit, const Run& run, const Ask& ask) const;
    template <class Run>
    std::vector<BodyDepth> find_depths(const Run& run) const;
    template <class Run>
    std::vector<SolidDistance> find_solid_distances(double limit, const Run& run) const;

    // ---- update, in this order
    void update();
    void test_pairs();
    void test_close_pairs();
    void relate_solids();
    template <class Question, class... Arguments>
    void answer_tests(PairVerdicts& pairs, Question question, const Arguments&... arguments);
    void commit() noexcept;

    std::uint64_t digest() const;
    void validate_solids(QueryMemory& memory) const;  // throws BrokenInvariant

    // Writes a body into the trace, as the call that makes it.
    void trace_body(ProxyIndex proxy, std::uint64_t shape_number) noexcept;

    // The number of a shape in the trace, written before a call that brings it in; 0 without a trace.
    std::uint64_t traced_number(const std::shared_ptr<const Shape>& shape) {
        return trace ? trace->number_of(shape) : 0;
    }

    // Writes a question that was asked in the world's own memory, if questions are written, and returns the answer.
    template <template <class> class Row, class Answer, class... Arguments>
    Answer traced(Answer answer, const Arguments&... arguments) noexcept {
        if (trace && trace->writes_questions()) trace->write<Row>(AnswerDigest::of(answer), arguments...);
        return answer;
    }

    Bodies bodies;
    Changes changes;
    MeshShapes mesh_shapes;
    TwoBodyTests tests;
    OverlapTracker broad_phase;
    PairVerdicts collisions;
    Closeness closeness;
    SolidPairs solids;
    Workers workers;
    std::unique_ptr<TraceWriter> trace;  // null: none is under way
    Statistics statistics;               // sums; the rest is filled in on request
};

// The shape's box, checked: what enters the broad phase must be ordered.
Aabb box_for(const Shape& shape, const Pose& pose, BodyId body = {}, const ListIndex& index = {});
[[noreturn]] void refuse_invalid(const Pose& pose, BodyId body, const ListIndex& index);
inline void require_valid(const Pose& pose, BodyId body = {}, const ListIndex& index = {}) {
    if (!is_finite(pose)) [[unlikely]]
        refuse_invalid(pose, body, index);
}
// The points as the other body sees them.
inline ClosestPoints turned(ClosestPoints points) noexcept {
    std::swap(points.a, points.b);
    std::swap(points.point_a, points.point_b);
    return points;
}
void require_usable(const std::shared_ptr<const Shape>& shape);  // throws InvalidArgument, and
void require_mesh_kind(const Shape& shape);                      // NotSupported: the kind of meshes, but no MeshShape
void require_answer(const TwoBodyTest& test, Question question, ShapeKind a, ShapeKind b);  // NotSupported

}  // namespace ecods
