#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "base/double_key.hpp"
#include "ecods/predicates.hpp"
#include "geometry/box_distance.hpp"
#include "query/convex/solid_pair.hpp"
#include "world/enlarged.hpp"
#include "world/least.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

Posed<ConvexSolid> convex_at(const Bodies& bodies, ProxyIndex proxy) {
    const ConvexSolid* const solid = bodies[proxy].convex();
    if (solid == nullptr) throw NotSupported("slot " + std::to_string(proxy + 1) + ": its body is no convex solid");
    return {*solid, bodies[proxy].pose};
}

Posed<Solid> solid_at(const Bodies& bodies, ProxyIndex proxy) {
    const Solid* const solid = bodies[proxy].solid();
    if (solid == nullptr) throw NotSupported("slot " + std::to_string(proxy + 1) + ": its body is no solid");
    return {*solid, bodies[proxy].pose};
}

// Asks about two bodies. Errors of the question name them.
template <class Ask>
auto ask_of(const Bodies& bodies, ProxyIndex a, ProxyIndex b, const Ask& ask) {
    try {
        return ask();
    } catch (const SingularPose& error) {
        throw SingularPose(error.argument, bodies.id_of(error.argument == 0 ? a : b));
    } catch (const SolidsApart&) {
        throw SolidsApart(bodies.id_of(a), bodies.id_of(b));
    }
}

bool is_regular(const Pose& pose) {
    return orient3d(Vec3::Zero(), pose.R.col(0), pose.R.col(1), pose.R.col(2)) != Sign::zero;
}

// By bits, as subnormal numbers may be taken for zero: a zero stays +0.
Vec3 opposite(const Vec3& direction) {
    Vec3 result;
    for (int axis = 0; axis < 3; ++axis) result[axis] = key_of(direction[axis]) == 0 ? 0.0 : -direction[axis];
    return result;
}

}  // namespace

// ---- of two bodies: the one of the lesser id comes first, where it matters

double World::solid_distance(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    const ProxyPair pair = w.bodies.require_pair(a, b);
    const auto first = convex_at(w.bodies, pair.a), second = convex_at(w.bodies, pair.b);
    return ask_of(w.bodies, pair.a, pair.b, [&] { return ecods::solid_distance(first, second, memory); });
}

std::optional<ClosestPoints> World::solid_closest(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    const ProxyPair pair = w.bodies.require_pair(a, b);
    const auto first = convex_at(w.bodies, pair.a), second = convex_at(w.bodies, pair.b);
    auto points = ask_of(w.bodies, pair.a, pair.b, [&] { return ecods::solid_closest(first, second, memory); });
    if (points && a.slot - 1 != pair.a) {
        std::swap(points->a, points->b);
        std::swap(points->point_a, points->point_b);
    }
    return points;
}

Depth World::depth(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    const ProxyPair pair = w.bodies.require_pair(a, b);
    const auto first = convex_at(w.bodies, pair.a), second = convex_at(w.bodies, pair.b);
    Depth depth = ask_of(w.bodies, pair.a, pair.b, [&] { return ecods::depth(first, second, memory); });
    if (a.slot - 1 != pair.a) {
        std::swap(depth.a, depth.b);
        depth.direction = opposite(depth.direction);
    }
    return depth;
}

DepthBounds World::depth_bounds(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    w.bodies.require_pair(a, b);
    const ProxyIndex first = a.slot - 1, second = b.slot - 1;
    const auto solid_a = solid_at(w.bodies, first), solid_b = solid_at(w.bodies, second);
    return ask_of(w.bodies, first, second, [&] { return ecods::depth_bounds(solid_a, solid_b, memory); });
}

double World::solid_distance(BodyId a, BodyId b) {
    return solid_distance(a, b, impl().workers.caller_memory());
}
std::optional<ClosestPoints> World::solid_closest(BodyId a, BodyId b) {
    return solid_closest(a, b, impl().workers.caller_memory());
}
Depth World::depth(BodyId a, BodyId b) {
    return depth(a, b, impl().workers.caller_memory());
}
DepthBounds World::depth_bounds(BodyId a, BodyId b) {
    return depth_bounds(a, b, impl().workers.caller_memory());
}

// ---- of all: asked in the order in which the trees find pairs, of which neighbours share bodies

ProxyPairs World::Impl::near_convex_pairs(double limit) const {
    std::vector<ProxyIndex> convex;
    std::vector<Aabb> boxes;
    for (ProxyIndex proxy = 0; proxy < bodies.end(); ++proxy) {
        const Slot& slot = bodies[proxy];
        if (slot.convex() == nullptr) continue;
        if (!is_regular(slot.pose)) throw SingularPose(0, bodies.id_of(proxy));
        convex.push_back(proxy);
        boxes.push_back(enlarged(broad_phase.box(proxy), limit));
    }
    ProxyPairs pairs;
    broad_phase.find_pairs_among(convex, boxes, pairs);
    std::erase_if(pairs, [&](const ProxyPair& pair) {
        return distance_below(broad_phase.box(pair.a), broad_phase.box(pair.b)) > limit || !bodies.is_enabled(pair);
    });
    return pairs;
}

std::vector<BodyDepth> World::depths(QueryMemory& memory) const {
    const Impl& w = impl();
    std::vector<BodyDepth> result;
    for (const ProxyPair& pair : w.near_convex_pairs(0)) {
        const auto a = convex_at(w.bodies, pair.a), b = convex_at(w.bodies, pair.b);
        if (!convex::do_meet(a, b, memory)) continue;
        result.push_back({w.bodies.ids_of(pair), ecods::depth(a, b, memory)});
    }
    std::ranges::sort(result, {}, &BodyDepth::bodies);
    return result;
}

std::vector<SolidDistance> World::solid_distances(double limit, QueryMemory& memory) const {
    const Impl& w = impl();
    if (!Least<ProxyPair>::is_limit(limit)) throw InvalidDistance(limit);
    std::vector<SolidDistance> result;
    for (const ProxyPair& pair : w.near_convex_pairs(limit)) {
        const auto a = convex_at(w.bodies, pair.a), b = convex_at(w.bodies, pair.b);
        const auto distance = convex::distance_within(a, b, limit, memory);
        if (distance) result.push_back({w.bodies.ids_of(pair), *distance});
    }
    std::ranges::sort(result, {}, &SolidDistance::bodies);
    return result;
}

std::vector<BodyDepth> World::depths() {
    Impl& w = impl();
    return w.traced<calls::Depths>(depths(w.workers.caller_memory()));
}
std::vector<SolidDistance> World::solid_distances(double limit) {
    Impl& w = impl();
    return w.traced<calls::SolidDistances>(solid_distances(limit, w.workers.caller_memory()), limit);
}

}  // namespace ecods
