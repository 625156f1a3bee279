#include <vector>

#include "base/double_key.hpp"
#include "geometry/find_invalid.hpp"
#include "query/cast/cast_until.hpp"
#include "query/cast/turning_question.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/intersection/surface_intersection.hpp"
#include "query/shape/other_units.hpp"

namespace ecods {
namespace {

// Searches the pieces of a turn, earliest first.
class TurnSearch {
  public:
    TurnSearch(const Turning<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b, double latest,
               QueryMemory& memory, PairWitness& witness)
        : start_(*a.what, a.pose),
          b_(b),
          latest_(latest),
          memory_(memory),
          witness_(witness),
          working_(QueryMemoryAccess::part<Working>(memory, &QueryMemoryAccess::State::turning)),
          motion_(working_.question.motion()) {
        motion_.bind(a, motion, b, QueryMemoryAccess::state(memory).counts.casts);
    }

    std::optional<FirstContact> run() {
        std::vector<double> ends{latest_};  // of pieces; the next one is last
        double from = 0;
        while (!ends.empty()) {
            const double to = ends.back();
            motion_.set_piece(from, to);
            const std::optional<float> first = motion_.first_of_boxes();
            std::optional<double> middle = first && motion_.is_wide() ? motion_.middle() : std::nullopt;
            if (first && !middle) {
                if (from == 0 && !(*first > 0) && meet_at_start()) return contact_;
                if (auto contact = search(to)) return contact;
                if (motion_.is_given_up()) middle = motion_.middle();
            }
            if (middle) {
                ends.push_back(*middle);
            } else {
                from = to;
                ends.pop_back();
            }
        }
        return std::nullopt;
    }

  private:
    using Working = SearchMemory<TurningQuestion>;

    // True if the bodies share a point at time 0; then sets contact_. Asks once.
    bool meet_at_start() {
        if (is_start_known_) return false;
        is_start_known_ = true;
        PairWitness at_start = witness_;
        if (!as_part(memory_, [&] { return surface::intersects(start_, b_, {memory_, at_start}); })) return false;
        witness_ = at_start;
        contact_ = contact_at_start(start_, b_, memory_);
        return true;
    }

    // Returns the first contact in the piece that ends at `to`, unless the search is given up. Contacts before the
    // piece are none.
    std::optional<FirstContact> search(double to) {
        TurningQuestion& question = working_.question;
        question.start(to);
        const MeshPair bodies{MeshBody(start_), MeshBody(b_)};
        Search(bodies, working_, memory_).run({.at_most = to}, bodies.named_by(witness_));
        if (motion_.is_given_up()) return std::nullopt;
        const auto contact = first_contact(working_.sieve, [](const auto&) { return std::optional<FirstContact>(); });
        const bool may_be_late = contact && key_of(contact->time) == key_of(latest_) && key_of(latest_) < key_of(1.0);
        if (!contact || (may_be_late && !question.is_by_then())) return std::nullopt;
        witness_ = {contact->a.triangle, contact->b.triangle};
        return contact;
    }

    const Posed<MeshShape> start_;
    const Posed<MeshShape>& b_;
    double latest_;
    QueryMemory& memory_;
    PairWitness& witness_;
    Working& working_;
    TurnMotion& motion_;
    bool is_start_known_ = false;
    std::optional<FirstContact> contact_;
};

}  // namespace

std::optional<FirstContact> cast_until(const Turning<MeshShape>& a, const Vec3& motion_of_b, const Posed<MeshShape>& b,
                                       double latest, QueryMemory& memory, PairWitness& witness) {
    validate_motion(motion_of_b);
    ++QueryMemoryAccess::state(memory).counts.queries;
    const OtherUnits units(a, motion_of_b, b);
    if (!units.are_better()) return TurnSearch(a, motion_of_b, b, latest, memory, witness).run();
    const Turning<MeshShape> scaled_a = units.of(a);
    const Posed<MeshShape> scaled_b = units.of(b);
    const Vec3 motion = units.of(motion_of_b);
    return as_part(memory, [&] { return TurnSearch(scaled_a, motion, scaled_b, latest, memory, witness).run(); });
}

}  // namespace ecods
