// World::Impl holds the parts of a World.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <variant>
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
#include "world/closest_memory.hpp"
#include "world/mesh_shapes.hpp"
#include "world/pair_relations.hpp"
#include "world/pair_verdicts.hpp"
#include "world/subject.hpp"
#include "world/two_body_tests.hpp"
#include "world/workers.hpp"

namespace ecods {

struct World::Impl {
    explicit Impl(const WorldOptions& options);

    // Throws NotSupported unless there is a test of `kind` with the kind of each body; if `question` is given, each
    // such test must answer it. If `replaced` is not null, one body with the shape `replaced` is left out.
    void require_tests_for(ShapeKind kind, const Shape* replaced, std::optional<Question> question = {}) const;

    // Returns the questions, beside `intersects`, that updates ask of every test. require_update_tests_for() throws
    // NotSupported unless the tests of `kind` answer all of them.
    std::array<std::optional<Question>, 2> update_questions() const noexcept {
        return {closeness.question(), relations.question()};
    }
    void require_update_tests_for(ShapeKind kind, const Shape* replaced) const;

    // Throw NotSupported unless the tests answer the question: the first function for every two bodies of the world,
    // the second for these two kinds.
    void require_answers(Question question) const;
    void require_answer(ShapeKind a, ShapeKind b, Question question) const;

    // The functions down to pair_of() look up and check the subjects of questions.
    Subject subject_of(const Asked& asked) const;  // throws StaleBody, InvalidArgument, NotSupported
    // Returns true if a question about the subject skips the body `other`: `other` is the subject, or their filters
    // exclude the pair.
    bool passes_over(const Subject& subject, ProxyIndex other) const;
    Aabb box_of(const Subject& subject) const;
    void require_tests_for(const Subject& subject, std::optional<Question> question = {}) const;
    // Calls act(slot) for each body that a question about the subject does not skip. Cost: a pass over the slots.
    template <class Function>
    void for_each_asked(const Subject& subject, const Function& act) const {
        for (ProxyIndex proxy = 0; proxy < bodies.end(); ++proxy) {
            if (bodies[proxy].is_alive() && !passes_over(subject, proxy)) act(bodies[proxy]);
        }
    }

    // PairOrder says in which order a question gets the two subjects. With lesser_id_first, the body with the lesser id
    // comes first, so that both orders of the arguments break ties alike. pair_of() throws SameBody, NotSupported, and
    // the errors of subject_of().
    enum class PairOrder { as_given, lesser_id_first };
    SubjectPair pair_of(const Asked& a, const Asked& b, PairOrder order = PairOrder::as_given) const;

    // The functions down to ask_pairs() answer questions about pairs of bodies.
    OrderedTest test_of(ProxyPair pair) const { return tests.find(bodies[pair.a].kind, bodies[pair.b].kind); }
    template <class Question, class... Arguments>
    auto ask(ProxyPair pair, Question question, Arguments&&... arguments) const {
        return test_of(pair).ask(bodies[pair.a].posed(), bodies[pair.b].posed(), question, arguments...);
    }
    Relation relate(ProxyPair pair, QueryMemory& memory) const;  // throws NotSupported

    // Answers World::meetings() of bodies with as many motions.
    std::vector<Meeting> find_meetings(std::span<const BodyId> listed, std::span<const Motion> motions,
                                       const Ask& ask) const;

    // Answer World::closest_pair() and closest_pairs().
    std::optional<ClosestPair> find_closest(double max_distance, const GroupPair& groups, const Ask& ask) const;
    std::vector<ClosestPair> find_close(double max_distance, const GroupPair& groups, const Ask& ask) const;
    // Returns the pairs of these groups that are not filtered out and whose boxes may be within max_distance of each
    // other.
    ProxyPairs near_pairs_of(double max_distance, const GroupPair& groups) const;

    // Holds pairs of bodies, in no promised order: pairs that are not filtered out, and whose boxes may be within a
    // limit of each other.
    struct NearPairs {
        ProxyPairs pairs;
        std::vector<convex::SolidInMemory>
            solids;  // by proxy; null unless the body is a convex solid at a regular pose

        bool are_convex(const ProxyPair& pair) const noexcept {
            return solids[pair.a].parts != nullptr && solids[pair.b].parts != nullptr;
        }
    };
    // Returns the pairs of convex solids, of convex solids and convex rounded bodies, or of bodies of all kinds. The
    // first two throw SingularPose if the pose of any convex solid is singular.
    enum class Kinds : std::uint8_t { convex_solids, convex, all };
    NearPairs near_pairs(double limit, Kinds kinds) const;
    // Calls find(pair, memory) for each pair, even if a call throws; then throws the error of the least pair. `find`
    // returns the second member of the pair's Answer, or nullopt for no answer. Returns the answers, ascending by pair.
    template <class Answer, class Function>
    std::vector<Answer> ask_pairs(const NearPairs& near, const Ask& ask, const Function& find) const;

    // update() calls the other steps in this order: test_pairs(), test_close_pairs(), relate_pairs(), commit().
    // answer_tests() is a helper of these steps.
    void update();
    void test_pairs();
    void test_close_pairs();
    void relate_pairs();
    template <class Question, class... Arguments>
    void answer_tests(PairVerdicts& pairs, Question question, const Arguments&... arguments);
    void commit() noexcept;

    std::uint64_t digest() const;
    void validate_relations(QueryMemory& memory) const;  // throws BrokenInvariant

    // Writes the call that creates the body into the trace. Call only if there is a trace.
    void trace_body(ProxyIndex proxy, std::uint64_t shape_number) noexcept;

    // Returns the number of a shape in the trace, or 0 if there is no trace. If the shape is new in the trace, writes
    // it there; so call this before the call that uses the number is written.
    std::uint64_t traced_number(const std::shared_ptr<const Shape>& shape) {
        return trace ? trace->number_of(shape) : 0;
    }

    // Returns `answer`. If the trace records questions and the caller gave no memory, first writes the question and a
    // digest of the answer into the trace. A mutex lets questions of several threads be written one by one.
    template <template <class> class Row, class Answer, class... Arguments>
    Answer traced(const Ask& ask, Answer answer, const Arguments&... arguments) const noexcept {
        if (trace && trace->writes_questions() && ask.memory == nullptr) {
            const std::uint64_t digest = AnswerDigest::of(answer);
            const std::scoped_lock lock(trace_mutex);
            trace->write<Row>(digest, arguments...);
        }
        return answer;
    }
    // Returns the answer to a question about a subject: traced if the subject is a body without a filter.
    template <template <class> class Row, class Answer, class... Arguments>
    Answer traced_of(const Ask& ask, Answer answer, const Asked& asked, const Arguments&... arguments) const noexcept {
        const BodyId* const body = std::get_if<BodyId>(&asked.what());
        if (body == nullptr || asked.filter()) return answer;
        return traced<Row>(ask, std::move(answer), *body, arguments...);
    }

    bool are_solids_surfaces = false;  // true while a trace of version 1 is replayed (WorldAccess)
    Bodies bodies;
    Changes changes;
    MeshShapes mesh_shapes;
    TwoBodyTests tests;
    OverlapTracker broad_phase;
    PairVerdicts collisions;
    Closeness closeness;
    PairRelations relations;
    Workers workers;
    std::unique_ptr<TraceWriter> trace;  // null if no trace is being written
    mutable std::mutex trace_mutex;      // guards the trace: several threads may ask questions at once
    Statistics statistics;               // running totals only; World::statistics() fills in the other members
};

// Returns the box of the shape at the pose. Throws InvalidArgument unless min <= max on each axis, which the broad
// phase requires.
Aabb box_for(const Shape& shape, const Pose& pose, BodyId body = {}, const ListIndex& index = {});
[[noreturn]] void refuse_invalid(const Pose& pose, BodyId body, const ListIndex& index);
inline void require_valid(const Pose& pose, BodyId body = {}, const ListIndex& index = {}) {
    if (!is_finite(pose)) [[unlikely]]
        refuse_invalid(pose, body, index);
}
void require_usable(const std::shared_ptr<const Shape>& shape);  // throws InvalidArgument for null; NotSupported
// Throws NotSupported if the kind is one of the library's, but the class of the shape is not.
void require_own_kind(const Shape& shape);
void require_answer(const TwoBodyTest& test, Question question, ShapeKind a, ShapeKind b);  // throws NotSupported

}  // namespace ecods
