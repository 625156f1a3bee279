// Computes the signed distance and the depth of rounded bodies. Let h(n) be the gap of two convex sets along a unit
// vector n: (the least n . y of the second) - (the greatest n . x of the first). Radii shorten the gap by their sum p
// along every vector. So the greatest gap of all, which is the distance D, or minus the depth, is less by p.
#include "base/double_key.hpp"
#include "ecods/error.hpp"
#include "exact/simplex/common_pose.hpp"
#include "query/body/contained.hpp"
#include "query/body/rounded_pair.hpp"
#include "query/body/small_pair.hpp"
#include "query/convex/convex_core.hpp"
#include "query/depth/signed_pair.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {
namespace {

// Returns the signed distance if fixed precision decides it; otherwise nullopt.
std::optional<SignedDistance> find_fixed(const RoundedPair& pair, const Ask& ask) {
    const auto segments = SmallPair(pair).find_closest();
    if (!segments) return std::nullopt;
    const auto at = segments->signed_closest();
    const auto direction = at ? segments->direction() : std::nullopt;
    if (!direction) return std::nullopt;
    RoundedPair::count_found(*segments, ask);
    return SignedDistance{at->distance, at->kind, at->a, at->b, at->point_a, at->point_b, *direction};
}

}  // namespace

// Returns the signed distance. Convex cores that share a point are treated as convex solids. If the cores are apart,
// and one of them is no solid, features are those of triangles.
SignedDistance RoundedPair::signed_distance(const Ask& ask) const {
    if (const auto found = find_fixed(*this, ask)) return *found;
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    const BodyPairAsked bodies(a.core, b.core);
    return as_one_query(memory, [&] {
        const Ask part(memory, asking.witness());
        if (bodies.are_convex()) {
            return depths::signed_distance(bodies.a.convex(), bodies.b.convex(), radii(), part);
        }
        const bool have_depth = convex::is_convex_core(*a.core.what) && convex::is_convex_core(*b.core.what);
        const bool are_sets = have_depth && exact::is_regular(a.core.pose.R) && exact::is_regular(b.core.pose.R);
        if (are_sets) {
            const auto deep =
                depths::signed_depth(convex::convex_core(a.core), convex::convex_core(b.core), radii(), part);
            if (deep) return *deep;
        }
        if (are_sets || !is_part_inside(bodies, memory)) {
            if (auto apart = surface::signed_closest(bodies.a.boundary(), bodies.b.boundary(), part, radii())) {
                ClosestPoints& at = apart->closest;
                bodies.rename(at);
                return SignedDistance{at.distance, at.kind, at.a, at.b, at.point_a, at.point_b, *apart->direction};
            }
        }
        if (!have_depth) {
            throw NotSupported("the cores share a point, and one of them is not convex: their depth is not known");
        }
        // Throws SingularPose, because a pose is singular here.
        return depths::signed_distance(convex::convex_core(a.core), convex::convex_core(b.core), radii(), part);
    });
}

std::optional<Depth> RoundedPair::depth(const Ask& ask) const {
    if (!convex::is_convex_core(*a.core.what) || !convex::is_convex_core(*b.core.what)) {
        throw NotSupported("a body is not convex: its depth is not known");
    }
    const BodyPairAsked bodies(a.core, b.core);
    if (radii().sum().sign() == 0 && bodies.are_convex()) {
        return ecods::depth(bodies.a.convex(), bodies.b.convex(), ask);
    }
    const SignedDistance found = signed_distance(ask);
    if (key_of(found.distance) > 0) return std::nullopt;
    return Depth{opposite(found.distance), found.a, found.b, found.direction};
}

SignedDistance signed_distance(const Posed<Rounded>& a, const Posed<Rounded>& b, const Ask& ask) {
    return RoundedPair{a, b}.signed_distance(ask);
}
SignedDistance signed_distance(const Posed<Rounded>& a, const Posed<MeshShape>& b, const Ask& ask) {
    return RoundedPair{a, b}.signed_distance(ask);
}
SignedDistance signed_distance(const Posed<MeshShape>& a, const Posed<Rounded>& b, const Ask& ask) {
    return RoundedPair{a, b}.signed_distance(ask);
}

std::optional<Depth> depth(const Posed<Rounded>& a, const Posed<Rounded>& b, const Ask& ask) {
    return RoundedPair{a, b}.depth(ask);
}
std::optional<Depth> depth(const Posed<Rounded>& a, const Posed<MeshShape>& b, const Ask& ask) {
    return RoundedPair{a, b}.depth(ask);
}
std::optional<Depth> depth(const Posed<MeshShape>& a, const Posed<Rounded>& b, const Ask& ask) {
    return RoundedPair{a, b}.depth(ask);
}

}  // namespace ecods
