#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "base/double_key.hpp"
#include "ecods/certificate.hpp"
#include "query/certificate/certificate_content.hpp"
#include "query/certificate/pair_proof.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/intersection/surface_intersection.hpp"
#include "query/shape/mesh_body.hpp"

namespace ecods {
namespace {

using Claim = Certificate::Claim;
using Content = CertificateAccess::Content;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct CertificateMemory final : QueryMemoryPart {
    TriangleDistances pair;
};

// A Maker makes one certificate about two bodies: it states the claim and records the proof.
class Maker {
  public:
    Maker(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory)
        : a_(a), b_(b), memory_(memory), pair_(bound_pair(a, b, memory)) {
        content_.shape_a = CertificateAccess::shape_of(a);
        content_.shape_b = CertificateAccess::shape_of(b);
        content_.pose_a = a.pose;
        content_.pose_b = b.pose;
    }

    Certificate relation() {
        // Tries to prove that the bodies are disjoint. If the bodies share a point, the attempt ends at two triangles
        // that meet.
        content_.claim = Claim::disjoint;
        const auto meeting = PairProof(a_, b_, 0, pair_, content_.proof).run(std::nullopt, PairProof::EndsAt::meeting);
        if (!meeting) return CertificateAccess::make(std::move(content_));
        content_.proof.clear();
        name_meeting(*meeting);
        return prove(Claim::touching, 0, {.a = meeting->a, .b = meeting->b});
    }

    Certificate distance() {
        PairWitness witness;
        const double d = surface::distance(a_, b_, {memory_, witness});
        content_.claim = Claim::distance;
        content_.value = d;
        if (key_of(d) == 0) return meeting(witness);
        if (key_of(d) < key_of(infinity)) name_closest(witness);
        return prove(Claim::distance, d, witness);
    }

    Certificate within(double d) {
        PairWitness witness;
        const bool is_within = surface::within(a_, b_, d, {memory_, witness});
        if (key_of(d) == 0) d = 0;  // turns -0 into +0
        content_.value = d;
        if (!is_within) return prove(Claim::beyond, d);
        content_.claim = Claim::within;
        // The witness may not be a pair within d: if d is infinite, no search was made; otherwise the search may have
        // set no pair, or left the pair of an earlier query. In both cases, searches for the nearest pair.
        if (key_of(d) == key_of(infinity) || !names_pair(witness) || pair_.compare(witness.a, witness.b, d) > 0) {
            witness = {};
            if (key_of(surface::distance(a_, b_, {memory_, witness})) == 0) return meeting(witness);
        }
        name_closest(witness);
        return CertificateAccess::make(std::move(content_));
    }

  private:
    static TriangleDistances& bound_pair(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory) {
        using State = QueryMemoryAccess::State;
        TriangleDistances& pair = QueryMemoryAccess::part<CertificateMemory>(memory, &State::certificate).pair;
        pair.bind(MeshBody(a).ref(), MeshBody(b).ref());
        return pair;
    }

    bool names_pair(const PairWitness& witness) const {
        return witness.a != PairWitness::none && witness.b != PairWitness::none;
    }

    void name_meeting(const TrianglePair& pair) {
        content_.a = {Feature::Kind::face, pair.a, 0};
        content_.b = {Feature::Kind::face, pair.b, 0};
        content_.names_triangles = true;
    }

    void name_closest(const PairWitness& witness) {
        const ClosestPoints closest = pair_.closest(witness.a, witness.b);
        if (closest.kind == ClosestKind::intersecting) return name_meeting(closest.triangles());
        content_.a = closest.a;
        content_.b = closest.b;
    }

    Certificate meeting(PairWitness witness) {
        if (!names_pair(witness) || key_of(pair_.distance(witness.a, witness.b)) != 0) {
            witness = {};
            std::ignore = surface::intersects(a_, b_, {memory_, witness});
        }
        name_meeting({witness.a, witness.b});
        return CertificateAccess::make(std::move(content_));
    }

    Certificate prove(Claim claim, double least, const PairWitness& closest = {}) {
        content_.claim = claim;
        std::optional<TrianglePair> near;
        if (names_pair(closest)) near = TrianglePair{closest.a, closest.b};
        if (const auto crossing =
                PairProof(a_, b_, least, pair_, content_.proof).run(near, PairProof::EndsAt::crossing)) {
            content_.claim = Claim::crossing;
            content_.proof.clear();
            name_meeting(*crossing);
        }
        return CertificateAccess::make(std::move(content_));
    }

    const Posed<MeshShape>& a_;
    const Posed<MeshShape>& b_;
    QueryMemory& memory_;
    TriangleDistances& pair_;
    Content content_;
};

}  // namespace

Certificate certify(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    return Maker(a, b, Asking(ask).memory()).relation();
}

Certificate certify_distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    return Maker(a, b, Asking(ask).memory()).distance();
}

Certificate certify_within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double max_distance, const Ask& ask) {
    return Maker(a, b, Asking(ask).memory()).within(max_distance);
}

}  // namespace ecods
