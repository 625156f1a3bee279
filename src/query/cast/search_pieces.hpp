// PieceSearch searches the pieces of a motion for the first contact, in the order of time.
#pragma once

#include <optional>
#include <vector>

#include "base/double_key.hpp"
#include "query/cast/cast_until.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/intersection/surface_intersection.hpp"
#include "query/search/search.hpp"

namespace ecods {

// PieceSearch takes a `Question`, a MeetingQuestion whose motion derives from TurnPieces and has set_piece(from, to).
template <class Question>
class PieceSearch {
  public:
    using Working = SearchMemory<Question>;

    // Takes the bodies at their poses at time 0. The motion of working.question must be bound to them. Everything that
    // the arguments refer to must outlive this object.
    PieceSearch(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double latest, QueryMemory& memory,
                PairWitness& witness, Working& working)
        : a_(a),
          b_(b),
          latest_(latest),
          memory_(memory),
          witness_(witness),
          working_(working),
          motion_(working.question.motion()) {}

    // States that the bodies share no point at time 0, so that run() need not test them at time 0.
    void begin_apart() noexcept { is_start_known_ = true; }

    std::optional<FirstContact> run() {
        std::vector<double> ends{latest_};  // ends of the pieces left; the next one is last
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
    // Returns true if the bodies share a point at time 0, and then sets contact_. Only the first call tests the bodies;
    // later calls return false.
    bool meet_at_start() {
        if (is_start_known_) return false;
        is_start_known_ = true;
        PairWitness at_start = witness_;
        if (!as_part(memory_, [&] { return surface::intersects(a_, b_, {memory_, at_start}); })) return false;
        witness_ = at_start;
        contact_ = contact_at_start(a_, b_, memory_);
        return true;
    }

    // Returns the first contact in the piece that ends at `to`; nullopt if there is none, or if the search is given up.
    // The bodies must have no contact before the piece.
    std::optional<FirstContact> search(double to) {
        Question& question = working_.question;
        question.start(to);
        const MeshPair bodies{MeshBody(a_), MeshBody(b_)};
        Search(bodies, working_, memory_).run({.at_most = to}, bodies.named_by(witness_));
        if (motion_.is_given_up()) return std::nullopt;
        const auto contact = first_contact(working_.sieve, [](const auto&) { return std::optional<FirstContact>(); });
        const bool may_be_late = contact && key_of(contact->time) == key_of(latest_) && key_of(latest_) < key_of(1.0);
        if (!contact || (may_be_late && !question.is_by_then())) return std::nullopt;
        witness_ = {contact->a.triangle, contact->b.triangle};
        return contact;
    }

    const Posed<MeshShape>& a_;
    const Posed<MeshShape>& b_;
    double latest_;
    QueryMemory& memory_;
    PairWitness& witness_;
    Working& working_;
    decltype(working_.question.motion()) motion_;
    bool is_start_known_ = false;
    std::optional<FirstContact> contact_;
};

}  // namespace ecods
