#include <limits>
#include <optional>
#include <utility>

#include "base/double_key.hpp"
#include "ecods/certificate.hpp"
#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "query/certificate/certificate_content.hpp"
#include "query/certificate/pair_proof.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/mesh_body.hpp"

namespace ecods {
namespace {

using Claim = Certificate::Claim;
using Content = CertificateAccess::Content;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct CertificateMemory final : QueryMemoryPart {
    TriangleDistances pair;
};

// One certificate in the making.
class Maker {
  public:
    Maker(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory)
        : a_(a), b_(b), memory_(memory), pair_(bound_pair(a, b, memory)) {
        content_.shape_a = a.what;
        content_.shape_b = b.what;
        content_.pose_a = a.pose;
        content_.pose_b = b.pose;
    }

    Certificate relation() {
        // A proof that they are disjoint is begun as if they were: it ends where they meet.
        content_.claim = Claim::disjoint;
        const auto meeting = PairProof(a_, b_, 0, pair_, content_.proof).run(std::nullopt, PairProof::EndsAt::meeting);
        if (!meeting) return CertificateAccess::make(std::move(content_));
        content_.proof.clear();
        name_meeting(*meeting);
        return prove(Claim::touching, 0, {.a = meeting->a, .b = meeting->b});
    }

    Certificate distance() {
        PairWitness witness;
        const double d = ecods::distance(a_, b_, memory_, witness);
        content_.claim = Claim::distance;
        content_.value = d;
        if (key_of(d) == 0) return meeting(witness);
        if (key_of(d) < key_of(infinity)) name_closest(witness);
        return prove(Claim::distance, d, witness);
    }

    Certificate within(double d) {
        PairWitness witness;
        const bool is_within = ecods::within(a_, b_, d, memory_, witness);
        if (key_of(d) == 0) d = 0;  // not its negative
        content_.value = d;
        if (!is_within) return prove(Claim::beyond, d);
        content_.claim = Claim::within;
        // Anything is within infinity, and the witness may be of a search that found a common point by itself.
        if (key_of(d) == key_of(infinity) || !names_pair(witness) || pair_.compare(witness.a, witness.b, d) > 0) {
            witness = {};
            if (key_of(ecods::distance(a_, b_, memory_, witness)) == 0) return meeting(witness);
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
            intersects(a_, b_, memory_, witness);
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

Certificate certify(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory) {
    return Maker(a, b, memory).relation();
}

Certificate certify_distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory) {
    return Maker(a, b, memory).distance();
}

Certificate certify_within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d, QueryMemory& memory) {
    return Maker(a, b, memory).within(d);
}

}  // namespace ecods
