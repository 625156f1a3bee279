#include "base/double_key.hpp"
#include "query/cast/cast_until.hpp"
#include "query/cast/mesh_at_ends.hpp"
#include "query/cast/moving_question.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/intersection/surface_intersection.hpp"
#include "query/shape/other_units.hpp"

namespace ecods {
namespace {

// StraightSearch searches for the first contact of two meshes whose points move straight. Everything that the arguments
// refer to must outlive this object.
class StraightSearch {
  public:
    StraightSearch(const MeshAtEnds& a, const MeshAtEnds& b, double latest, QueryMemory& memory, PairWitness& witness)
        : a_(a),
          b_(b),
          latest_(latest),
          memory_(memory),
          witness_(witness),
          working_(QueryMemoryAccess::part<Working>(memory, &QueryMemoryAccess::State::moving)) {
        ++QueryMemoryAccess::state(memory).counts.queries;
        motion().bind_boxes(a, b);
        first_ = motion().first_of_boxes();
    }

    // Returns false if the boxes of the meshes never meet. Call run() only if this function returns true.
    bool may_meet() const noexcept { return first_.has_value(); }

    std::optional<FirstContact> run() {
        const Posed<MeshShape> start_a(a_.start.shape, a_.start.pose), start_b(b_.start.shape, b_.start.pose);
        PairWitness at_start = witness_;
        if (!(*first_ > 0) && as_part(memory_, [&] {
                return surface::intersects(start_a, start_b, {memory_, at_start});
            })) {
            witness_ = at_start;
            return contact_at_start(start_a, start_b, memory_);
        }
        if (a_.is_at_rest && b_.is_at_rest) return std::nullopt;
        motion().bind(a_, b_, QueryMemoryAccess::state(memory_).counts.casts);
        MovingQuestion& question = working_.question;
        question.start(latest_);
        const MeshPair bodies{a_.start, b_.start};
        Search(bodies, working_, memory_).run({.at_most = latest_}, bodies.named_by(witness_));
        const auto contact = first_contact(working_.sieve, [](const auto&) { return std::optional<FirstContact>(); });
        const bool may_be_late = contact && key_of(contact->time) == key_of(latest_) && key_of(latest_) < key_of(1.0);
        if (!contact || (may_be_late && !question.is_by_then())) return std::nullopt;
        witness_ = {contact->a.triangle, contact->b.triangle};
        return contact;
    }

  private:
    using Working = SearchMemory<MovingQuestion>;

    StraightMotion& motion() noexcept { return working_.question.motion(); }

    const MeshAtEnds &a_, &b_;
    double latest_;
    QueryMemory& memory_;
    PairWitness& witness_;
    Working& working_;
    std::optional<float> first_;  // lower bound of the time at which the boxes meet
};

std::optional<FirstContact> search_moves(const StraightMove& a, const StraightMove& b, double latest,
                                         QueryMemory& memory, PairWitness& witness) {
    const Pose end_a = a.rounded_end(), end_b = b.rounded_end();
    return cast_until(MeshAtEnds(a, end_a), MeshAtEnds(b, end_b), latest, memory, witness);
}

}  // namespace

std::optional<FirstContact> cast_until(const Moving<MeshShape>& a, const Moving<MeshShape>& b, double latest,
                                       QueryMemory& memory, PairWitness& witness) {
    const MeshAtEnds of_a(a), of_b(b);
    StraightSearch search(of_a, of_b, latest, memory, witness);
    if (!search.may_meet()) return std::nullopt;
    const OtherUnits units(a, b);
    if (units.are_better()) {
        return as_part(memory, [&] { return cast_until(units.of(a), units.of(b), latest, memory, witness); });
    }
    return search.run();
}

std::optional<FirstContact> cast_until(const StraightMove& a, const StraightMove& b, double latest, QueryMemory& memory,
                                       PairWitness& witness) {
    static const Vec3 rest = Vec3::Zero();
    const Vec3 &way_a = a.translation ? *a.translation : rest, &way_b = b.translation ? *b.translation : rest;
    const OtherUnits units(a.body, b.body, way_a, way_b);
    if (!units.are_better()) return search_moves(a, b, latest, memory, witness);
    const auto scaled = [&](const StraightMove& move) {
        return StraightMove{units.of(move.body),
                            move.translation ? std::optional(units.of(*move.translation)) : std::nullopt};
    };
    ++QueryMemoryAccess::state(memory).counts.queries;
    return as_part(memory, [&] { return search_moves(scaled(a), scaled(b), latest, memory, witness); });
}

std::optional<FirstContact> cast_until(const MeshAtEnds& a, const MeshAtEnds& b, double latest, QueryMemory& memory,
                                       PairWitness& witness) {
    StraightSearch search(a, b, latest, memory, witness);
    return search.may_meet() ? search.run() : std::nullopt;
}

}  // namespace ecods
