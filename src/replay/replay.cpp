#include "ecods/trace.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "trace/trace_reader.hpp"
#include "world/answer_digest.hpp"
#include "world/world_access.hpp"

namespace ecods {
namespace {

using Pairs = std::vector<BodyPair>;

bool is_difference(std::span<const BodyPair> difference, const Pairs& of, const Pairs& without) {
    Pairs expected;
    std::ranges::set_difference(of, without, std::back_inserter(expected));
    return std::ranges::equal(difference, expected);
}

std::string hex_text(std::uint64_t number) {
    std::string text;
    append_hex(text, number);
    return text;
}

// Replays a trace: makes its calls in a new world, and compares the answers.
class Replayer {
  public:
    Replayer(std::istream& in, const ReplayOptions& options)
        : reader_(in),
          options_(options),
          world_({.broad_phase = options.broad_phase.value_or(reader_.broad_phase()), .executor = options.executor}) {
        if (reader_.is_of_version_1()) WorldAccess::take_solids_for_surfaces(world_);
        if (options_.set_up) options_.set_up(world_);
    }
    ReplayReport run();

  private:
    void take(const TracedCall& call);
    void take(const TracedQuestion& question);
    void take(const TracedUpdate& update);
    void take(const TracedMesh& mesh) { shapes_.push_back(make_shape(mesh.mesh, mesh.form)); }
    void take(const TracedHalfSpace& traced) {
        shapes_.push_back(std::make_shared<const HalfSpace>(traced.normal, traced.offset));
    }
    void take(const TracedShape& shape);
    void take(const TracedRounded& shape);
    void take(const TracedNote&) {}

    template <template <class> class Row>
    void make(const Row<calls::InOrder>& traced);
    template <template <class> class Row>
    void ask(const Row<calls::InOrder>& traced);
    template <template <class> class Row>
    Row<calls::InWorld> in_world(const Row<calls::InOrder>& traced) const;
    void keep_id(calls::Label label, BodyId made);
    void compare_events(const Pairs& before, const Pairs& after);
    void differ(std::string what);

    TraceReader reader_;
    const ReplayOptions& options_;
    World world_;
    std::vector<std::shared_ptr<const Shape>> shapes_;  // by their order in the trace
    std::vector<BodyId> ids_;                           // by label
    ReplayReport report_;
};

ReplayReport Replayer::run() {
    while (!report_.difference) {
        const auto item = reader_.next();
        if (!item) break;
        try {
            std::visit([&](const auto& one) { take(one); }, *item);
        } catch (const InvalidTrace&) {
            throw;
        } catch (const NotSupported&) {
            throw;
        } catch (const ExecutorFailed&) {
            throw;
        } catch (const Error& error) {
            reader_.fail(error.what());
        }
        if (std::holds_alternative<TracedCall>(*item) || std::holds_alternative<TracedUpdate>(*item) ||
            std::holds_alternative<TracedQuestion>(*item)) {
            ++report_.call_count;
        }
    }
    report_.body_count = reader_.names().bodies.size();
    report_.colliding_count = world_.colliding_pairs().size();
    return std::move(report_);
}

void Replayer::take(const TracedShape& shape) {
    if (!options_.read_shape) {
        throw NotSupported("line " + std::to_string(reader_.line()) + ": a shape of kind " +
                           std::to_string(shape.kind.value) + " cannot be read: ReplayOptions::read_shape is not set");
    }
    auto made = options_.read_shape(shape.kind, shape.text);
    if (!made || made->kind() != shape.kind) reader_.fail("ReplayOptions::read_shape gave no shape of this kind");
    shapes_.push_back(std::move(made));
}

void Replayer::take(const TracedRounded& shape) {
    auto core = std::dynamic_pointer_cast<const MeshShape>(shapes_[shape.core]);
    if (!core) reader_.fail("the core of a rounded shape is no mesh");
    shapes_.push_back(std::make_shared<const Rounded>(std::move(core), shape.radius));
}

void Replayer::take(const TracedCall& call) {
    std::visit([&](const auto& row) { make(row); }, call);
}

void Replayer::take(const TracedQuestion& question) {
    std::visit([&](const auto& row) { ask(row); }, question);
}

template <template <class> class Row>
Row<calls::InWorld> Replayer::in_world(const Row<calls::InOrder>& traced) const {
    return calls::renamed<calls::InWorld>(
        traced, [&](calls::Label label) { return ids_[label]; }, [&](std::size_t index) { return shapes_[index]; });
}

template <template <class> class Row>
void Replayer::make(const Row<calls::InOrder>& traced) {
    auto call = in_world(traced);
    call.make(world_);

    struct KeepIds : calls::NoField {
        Replayer& replayer;
        void created(const calls::Label& label, const BodyId& made) const { replayer.keep_id(label, made); }
    };
    Row<calls::InOrder>::fields(KeepIds{{}, *this}, traced, call);
}

// Asks the new world the question of the trace. Compares the digest of the answer with the digest in the trace only if
// the world has the ids of the trace, since the least id decides a tie.
template <template <class> class Row>
void Replayer::ask(const Row<calls::InOrder>& traced) {
    const std::uint64_t answer = AnswerDigest::of(in_world(traced).ask(world_));
    if (reader_.begins_empty() && answer != traced.answer) {
        differ("the digest of the answer to " + std::string(traced.name) + " is " + hex_text(answer) + " and was " +
               hex_text(traced.answer));
    }
    if (!report_.difference) ++report_.question_count;
}

void Replayer::keep_id(calls::Label label, BodyId made) {
    ids_.push_back(made);
    if (!reader_.begins_empty() || traced(made) == reader_.names().created[label]) return;
    std::string text = "the new body is ";
    append(text, made);
    differ(text);
}

void Replayer::take(const TracedUpdate& update) {
    const Pairs before(world_.colliding_pairs().begin(), world_.colliding_pairs().end());
    world_.update();
    const Pairs after(world_.colliding_pairs().begin(), world_.colliding_pairs().end());
    const auto& expected = update.result;
    if (expected && world_.digest() != expected->digest) {
        differ("the digest is " + hex_text(world_.digest()) + " and was " + hex_text(expected->digest) + "; " +
               std::to_string(after.size()) + " pairs collide and " + std::to_string(expected->colliding_count) +
               " did");
    } else if (expected && after.size() != expected->colliding_count) {
        differ(std::to_string(after.size()) + " pairs collide and " + std::to_string(expected->colliding_count) +
               " did");
    }
    compare_events(before, after);
    if (options_.checks_invariants) {
        try {
            world_.check_invariants();
        } catch (const Error& error) {
            differ(error.what());
        }
    }
    if (report_.difference) return;
    ++report_.update_count;
    if (options_.updated) options_.updated(world_);
}

void Replayer::compare_events(const Pairs& before, const Pairs& after) {
    if (!is_difference(world_.began(), after, before)) differ("the pairs that began are not those that are new");
    if (!is_difference(world_.ended(), before, after)) differ("the pairs that ended are not those that are gone");
}

void Replayer::differ(std::string what) {
    if (report_.difference) return;
    report_.difference = {
        .update = report_.update_count, .call = report_.call_count, .line = reader_.line(), .what = std::move(what)};
}

}  // namespace

ReplayReport replay(std::istream& trace, const ReplayOptions& options) {
    return Replayer(trace, options).run();
}

}  // namespace ecods
