#include <optional>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "geometry/find_invalid.hpp"
#include "query/cast/cast_until.hpp"
#include "query/cast/contact_interval.hpp"
#include "query/cast/translated_pairs.hpp"
#include "query/intersection/surface_intersection.hpp"
#include "query/search/search.hpp"
#include "query/shape/other_units.hpp"

namespace ecods {
namespace {

// TranslationQuestion is a PairQuestion (query/search) for a translation of body a. The number of a pair of triangles
// is the time of its first contact.
class TranslationQuestion : public TranslatedPairs {
  public:
    using Interval = ContactInterval;
    using Value = FirstContact;

    bool may_share(float time) const noexcept { return !(time > 0); }
    ContactInterval enclose(const TrianglePair& triangles, double) { return enclosed(triangles); }
    // Decides the pair exactly unless the interval proves that the pair has a contact. Returns false if the pair has no
    // contact.
    bool complete(const TrianglePair& triangles, ContactInterval& interval, std::optional<FirstContact>& contact) {
        if (key_of(interval.upper) <= key_of(1.0)) return true;
        contact = round(triangles, interval);
        if (contact) interval.lower = interval.upper = contact->time;
        return contact.has_value();
    }
    std::optional<FirstContact> round(const TrianglePair& triangles, const ContactInterval& interval) {
        return exact_contacts().contact(triangles.a, triangles.b, interval);
    }
    bool meet_by(const TrianglePair& triangles, double latest) {
        return exact_contacts().meet_by(triangles.a, triangles.b, latest);
    }
};

// Returns the first open contact if its real time is at most `latest`. A real time that rounds to less than `latest` is
// less than `latest`. One that rounds to `latest` may exceed it: of several pairs that tie in rounded time, some may
// exceed it and others not, so these are compared exactly. If `latest` is 1, every contact is in time.
std::optional<FirstContact> first_by(double latest, TranslationQuestion& translation,
                                     SieveOf<TranslationQuestion>& sieve) {
    const auto contact =
        first_contact(sieve, [&](const auto& open) { return translation.round(open.triangles, open.interval); });
    if (!contact || key_of(contact->time) > key_of(latest)) return std::nullopt;
    if (key_of(contact->time) < key_of(latest) || key_of(latest) >= key_of(1.0)) return contact;
    const auto is_by = [&](const TrianglePair& triangles) { return translation.meet_by(triangles, latest); };
    return sieve.is_least_within(latest, is_by) ? contact : std::nullopt;
}

// Returns the first contact of two bodies that are both at rest: at time 0, or nullopt if they share no point.
std::optional<FirstContact> cast_at_rest(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory,
                                         PairWitness& witness) {
    if (!surface::intersects(a, b, {memory, witness})) return std::nullopt;
    const FirstContact result = contact_at_start(a, b, memory);
    witness = {result.a.triangle, result.b.triangle};
    return result;
}

}  // namespace

FirstContact contact_at_start(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory) {
    const TrianglePair first = as_part(memory, [&] { return surface::intersecting_triangles(a, b, memory); }).front();
    return {0, ClosestKind::intersecting, {Feature::Kind::face, first.a, 0}, {Feature::Kind::face, first.b, 0}};
}

std::optional<FirstContact> cast_until(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                       double latest, QueryMemory& memory, PairWitness& witness) {
    validate_motion(motion);
    if (is_zero(motion)) return cast_at_rest(a, b, memory, witness);
    using Working = SearchMemory<TranslationQuestion>;
    Working& working = QueryMemoryAccess::part<Working>(memory, &QueryMemoryAccess::State::cast);
    QueryCounts& counts = QueryMemoryAccess::state(memory).counts;
    ++counts.queries;
    const MeshPair bodies{MeshBody(a), MeshBody(b)};
    if (!working.question.bind(bodies, motion, latest, counts.casts)) return std::nullopt;
    const OtherUnits units(a, b, motion);
    if (units.are_better()) {
        return as_part(memory,
                       [&] { return cast_until(units.of(a), units.of(motion), units.of(b), latest, memory, witness); });
    }
    Search(bodies, working, memory).run({.at_most = latest}, bodies.named_by(witness));
    const auto contact = working.sieve.is_zero() ? std::optional(contact_at_start(a, b, memory))
                                                 : first_by(latest, working.question, working.sieve);
    if (contact) witness = {contact->a.triangle, contact->b.triangle};
    return contact;
}

}  // namespace ecods
