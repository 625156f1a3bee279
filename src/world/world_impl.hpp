// World::Impl holds the parts of a World.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "broad_phase/changes/pair_events.hpp"
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
#include "world/subject.hpp"
#include "world/two_body_tests.hpp"
#include "world/workers.hpp"

namespace ecods {

struct World::Impl {
    explicit Impl(const WorldOptions& options);

    // Throws NotSupported unless there is a test for `kind` and the kind of each body, and it answers the question if
    // one is given. Does not count one body with the shape `replaced`, if that is not null.
    void require_tests_for(ShapeKind kind, const Shape* replaced, std::optional<Question> question = {}) const;

    // Throw NotSupported unless the tests answer the question: for every two bodies of the world, or for these two
    // kinds.
    void require_answers(Question question) const;
    void require_answer(ShapeKind a, ShapeKind b, Question question) const;

    // ---- subjects of questions
    Subject subject_of(const Asked& asked) const;  // throws StaleBody, InvalidArgument, NotSupported
    // True if a question about the subject skips this body: it is the subject itself, or the two are filtered out.
    bool passes_over(const Subject& subject, ProxyIndex other) const;
    Aabb box_of(const Subject& subject) const;
    void require_tests_for(const Subject& subject, std::optional<Question> question = {}) const;

    // PairOrder says in which order a test gets two bodies. With lesser_id_first, the body of the lesser id comes
    // first, so that ties are broken alike in both orders of the arguments. pair_of() throws SameBody, NotSupported,
    // and what subject_of() throws.
    enum class PairOrder { as_given, lesser_id_first };
    SubjectPair pair_of(const Asked& a, const Asked& b, PairOrder order = PairOrder::as_given) const;

    // ---- pairs of bodies
    OrderedTest test_of(ProxyPair pair) const { return tests.find(bodies[pair.a].kind, bodies[pair.b].kind); }
    template <class Question, class... Arguments>
    auto ask(ProxyPair pair, Question question, Arguments&&... arguments) const {
        return test_of(pair).ask(bodies[pair.a].posed(), bodies[pair.b].posed(), question, arguments...);
    }
    Relation relate(ProxyPair pair, QueryMemory& memory) const;  // of two solids; throws NotSupported

    // NearConvexPairs has the pairs of convex solids whose boxes are not proven to be further apart than the limit,
    // without those that are filtered out, in no promised order. near_convex_pairs() throws SingularPose.
    struct NearConvexPairs {
        ProxyPairs pairs;
        std::vector<convex::SolidInMemory> solids;  // by proxy
    };
    NearConvexPairs near_convex_pairs(double limit) const;
    // Asks about each near pair, even if one throws. `find(a, b, memory)` returns the second member of the Answer, or
    // nothing. Returns the answers, ascending by pair.
    template <class Answer, class Function>
    std::vector<Answer> ask_convex_pairs(double limit, const Ask& ask, const Function& find) const;

    // ---- the steps of an update, in this order
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

    // Returns the number of a shape in the trace, or 0 without a trace. Writes the shape if it is new there, so this
    // comes before the call that brings it in.
    std::uint64_t traced_number(const std::shared_ptr<const Shape>& shape) {
        return trace ? trace->number_of(shape) : 0;
    }

    // Returns the answer. Also writes the question and a digest of the answer, if the trace has questions and the
    // caller gave no memory. Questions of several threads are written one by one.
    template <template <class> class Row, class Answer, class... Arguments>
    Answer traced(const Ask& ask, Answer answer, const Arguments&... arguments) const noexcept {
        if (trace && trace->writes_questions() && ask.memory == nullptr) {
            const std::uint64_t digest = AnswerDigest::of(answer);
            const std::scoped_lock lock(trace_mutex);
            trace->write<Row>(digest, arguments...);
        }
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
    std::unique_ptr<TraceWriter> trace;  // null: no trace is under way
    mutable std::mutex trace_mutex;      // for questions, which may run beside each other
    Statistics statistics;               // sums alone; World::statistics() fills in the rest
};

// Returns the shape's box. Throws InvalidArgument unless min <= max on each axis, as the broad phase requires.
Aabb box_for(const Shape& shape, const Pose& pose, BodyId body = {}, const ListIndex& index = {});
[[noreturn]] void refuse_invalid(const Pose& pose, BodyId body, const ListIndex& index);
inline void require_valid(const Pose& pose, BodyId body = {}, const ListIndex& index = {}) {
    if (!is_finite(pose)) [[unlikely]]
        refuse_invalid(pose, body, index);
}
// Returns the points with the two bodies exchanged.
inline ClosestPoints turned(ClosestPoints points) noexcept {
    std::swap(points.a, points.b);
    std::swap(points.point_a, points.point_b);
    return points;
}
void require_usable(const std::shared_ptr<const Shape>& shape);  // throws InvalidArgument for null, and as below
void require_mesh_kind(const Shape& shape);                      // NotSupported if of kind mesh() but no MeshShape
void require_answer(const TwoBodyTest& test, Question question, ShapeKind a, ShapeKind b);  // throws NotSupported

}  // namespace ecods
