#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "query/certificate/world_certificate_content.hpp"
#include "query/intersection/asking.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

using Content = WorldCertificateAccess::Content;
using Claim = Certificate::Claim;

void add_bodies(Content& content, const Bodies& bodies) {
    for (const BodyId id : bodies.ids()) {
        const Slot& slot = bodies[id.slot - 1];
        if (slot.kind != ShapeKind::mesh()) throw NotSupported(Question::certify, slot.kind, slot.kind, id);
        if (slot.form != MeshForm::surface) {
            throw NotSupported("slot " + std::to_string(id.slot) +
                               ": its body is a solid, and a certificate is about surfaces");
        }
        content.bodies.push_back({id, std::static_pointer_cast<const MeshShape>(slot.shape), slot.pose, slot.filter});
    }
}

Content::Pair certify_pair(const Bodies& bodies, ProxyPair pair, const std::optional<double>& clearance,
                           QueryMemory& memory) {
    const auto posed = [&](ProxyIndex proxy) {
        return Posed<MeshShape>(static_cast<const MeshShape&>(*bodies[proxy].shape), bodies[proxy].pose);
    };
    const Posed<MeshShape> a = posed(pair.a), b = posed(pair.b);
    Content::Pair result{bodies.ids_of(pair), certify(a, b, memory)};
    if (!clearance || result.first.claim() != Claim::disjoint) return result;
    Certificate within = certify_within(a, b, *clearance, memory);
    if (within.claim() == Claim::beyond) {
        result.first = std::move(within);
    } else {
        result.second = std::move(within);
    }
    return result;
}

// Returns an upper bound of the distance of two boxes whose gap on each axis is at most the clearance. Their distance
// is at most sqrt(3) * clearance.
double box_limit(const std::optional<double>& clearance) {
    constexpr double largest = std::numeric_limits<double>::max();
    if (!clearance) return 0;
    return *clearance < largest / 2 ? 2 * *clearance : largest;
}

}  // namespace

WorldCertificate World::certify(const Ask& ask) const {
    const Impl& w = impl();
    if (!w.changes.empty() || !w.closeness.is_up_to_date()) throw NotUpdated();
    Asking asking(ask);
    Content content;
    content.clearance = w.closeness.listed();
    if (content.clearance && key_of(*content.clearance) == 0) content.clearance = 0;  // turns -0 into +0
    add_bodies(content, w.bodies);
    for (const ProxyPair pair : w.bodies.disabled().list()) content.off.push_back(w.bodies.ids_of(pair));
    std::vector<ProxyPair> pairs;
    const double limit = box_limit(content.clearance);
    w.broad_phase.visit_near_pairs(limit, [&](ProxyPair pair) {
        if (w.bodies.is_enabled(pair)) pairs.push_back(pair.a < pair.b ? pair : ProxyPair{pair.b, pair.a});
        return limit;
    });
    std::ranges::sort(pairs);
    for (const ProxyPair pair : pairs) {
        content.pairs.push_back(certify_pair(w.bodies, pair, content.clearance, asking.memory()));
    }
    return WorldCertificateAccess::make(std::move(content));
}

}  // namespace ecods
