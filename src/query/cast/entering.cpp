#include "query/cast/entering.hpp"

#include <limits>
#include <memory>

#include "base/double_key.hpp"
#include "query/cast/contact_interval.hpp"
#include "query/cast/translated_pairs.hpp"
#include "query/search/search.hpp"

namespace ecods {
namespace {

// Entering is a PairQuestion (query/search). The number of a pair of triangles is the time at which the first triangle
// goes into the second one. This time is that of the first contact or later, so a lower bound of the contact's time is
// a lower bound of the number.
class Entering : public TranslatedPairs {
  public:
    using Interval = ContactInterval;
    using Value = PairEntry;

    // Binds the bodies and the motion. Returns false if there is certainly no contact from time 0 to `end`.
    bool bind(const MeshPair& bodies, const Vec3& motion, double end, SlidingEdges* edges, CastCounts& counts) {
        edges_ = edges;
        end_ = end;
        return TranslatedPairs::bind(bodies, motion, end, counts);
    }
    // Returns false: triangles that share a point at the start need not go into each other.
    bool may_share(float) const noexcept { return false; }

    ContactInterval enclose(const TrianglePair& pair, double) {
        if (edges_ != nullptr && !(edges_->counts(0, pair.a) && edges_->counts(1, pair.b))) return never();
        ContactInterval interval = enclosed(pair);
        // A certain contact is a contact of a vertex with a face that has the vertex strictly inside, or of two edges
        // that cross, seen along the motion. So the pair goes in properly at its first contact.
        const bool is_proven =
            interval.is_certain && key_of(interval.lower) > 0 && key_of(interval.upper) < key_of(end_);
        if (!is_proven) interval.upper = std::numeric_limits<double>::infinity();
        interval.is_certain = is_proven;
        return interval;
    }
    // Decides the pair exactly, unless its interval proves that the first triangle goes into the second one. Returns
    // false if the first triangle does not go into the second one.
    bool complete(const TrianglePair& pair, ContactInterval& interval, std::optional<PairEntry>& entry) {
        if (interval.is_certain) return true;
        entry = find(pair);
        if (entry) interval.lower = interval.upper = entry->time;
        return entry.has_value();
    }
    std::optional<PairEntry> find(const TrianglePair& pair) {
        const TriangleContacts::Entry found = exact_contacts().entry(pair.a, pair.b, end_, edges_ != nullptr);
        std::optional<double> time = found.time;
        for (std::uint32_t edge = 0; edge < 6; ++edge) {
            if ((found.sliding_edges >> edge & 1) == 0) continue;
            const bool is_of_a = edge < 3;
            const auto slides_in =
                is_of_a ? edges_->time(0, pair.a, edge, pair.b, end_) : edges_->time(1, pair.b, edge - 3, pair.a, end_);
            if (slides_in && (!time || key_of(*slides_in) < key_of(*time))) time = slides_in;
        }
        if (!time) return std::nullopt;
        return PairEntry{*time, pair};
    }

  private:
    static ContactInterval never() {
        ContactInterval interval;
        interval.lower = std::numeric_limits<double>::infinity();
        return interval;
    }

    SlidingEdges* edges_ = nullptr;
    double end_ = 1;
};

}  // namespace

std::optional<PairEntry> first_entry(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                     double end, SlidingEdges* edges, QueryMemory& memory) {
    const auto allocated = std::make_unique<SearchMemory<Entering>>();
    SearchMemory<Entering>& working = *allocated;
    const MeshPair bodies{MeshBody(a), MeshBody(b)};
    CastCounts& counts = QueryMemoryAccess::state(memory).counts.casts;
    if (!working.question.bind(bodies, motion, end, edges, counts)) return std::nullopt;
    Search(bodies, working, memory).run({.at_most = end}, std::nullopt);
    return working.sieve.least([&](const auto& open, const auto&) { return working.question.find(open.triangles); },
                               [](const PairEntry& e) { return e.time; },
                               [](const PairEntry& e) { return e.triangles; });
}

}  // namespace ecods
