#include <memory>

#include "query/cast/cast_until.hpp"
#include "query/cast/settling_motion.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {

std::optional<FirstContact> settle_from(const MeshShape& a, const TurnLeg& leg, const Pose& to,
                                        const Posed<MeshShape>& b, QueryMemory& memory, PairWitness& witness) {
    using Settling = MeetingQuestion<SettlingMotion>;
    const auto working = std::make_unique<SearchMemory<Settling>>();
    QueryCounts& counts = QueryMemoryAccess::state(memory).counts;
    ++counts.queries;
    Settling& question = working->question;
    question.motion().bind(a, leg, to, b, counts.casts);
    if (!question.motion().first_of_boxes()) return std::nullopt;
    question.start(1);
    const MeshPair bodies{MeshBody(a, to), MeshBody(b)};
    Search(bodies, *working, memory).run({.at_most = 1}, bodies.named_by(witness));
    auto contact = first_contact(working->sieve, [](const auto&) { return std::optional<FirstContact>(); });
    if (!contact) return std::nullopt;
    witness = {contact->a.triangle, contact->b.triangle};
    if (key_of(contact->time) == 0) {
        contact->kind = ClosestKind::intersecting;
        for (Feature* const feature : {&contact->a, &contact->b})
            *feature = {Feature::Kind::face, feature->triangle, 0};
    }
    return contact;
}

}  // namespace ecods
