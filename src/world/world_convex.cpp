#include <algorithm>
#include <exception>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/limits.hpp"
#include "geometry/box_distance.hpp"
#include "query/convex/solid_pair.hpp"
#include "world/enlarged.hpp"
#include "world/first_failure.hpp"
#include "world/least.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

// Asks about two bodies. Errors of the question name them.
template <class Ask>
auto ask_of(const Bodies& bodies, ProxyIndex a, ProxyIndex b, const Ask& ask) {
    try {
        return ask();
    } catch (const SingularPose& error) {
        throw SingularPose(error.argument, bodies.id_of(error.argument == 0 ? a : b));
    }
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
    const auto first = w.bodies.convex_at(pair.a), second = w.bodies.convex_at(pair.b);
    return ask_of(w.bodies, pair.a, pair.b, [&] { return ecods::solid_distance(first, second, memory); });
}

std::optional<ClosestPoints> World::solid_closest(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    const ProxyPair pair = w.bodies.require_pair(a, b);
    const auto first = w.bodies.convex_at(pair.a), second = w.bodies.convex_at(pair.b);
    auto points = ask_of(w.bodies, pair.a, pair.b, [&] { return ecods::solid_closest(first, second, memory); });
    if (points && a.slot - 1 != pair.a) points = turned(*points);
    return points;
}

std::optional<Depth> World::depth(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    const ProxyPair pair = w.bodies.require_pair(a, b);
    const auto first = w.bodies.convex_at(pair.a), second = w.bodies.convex_at(pair.b);
    auto depth = ask_of(w.bodies, pair.a, pair.b, [&] { return ecods::depth(first, second, memory); });
    if (depth && a.slot - 1 != pair.a) {
        std::swap(depth->a, depth->b);
        depth->direction = opposite(depth->direction);
    }
    return depth;
}

std::optional<DepthBounds> World::depth_bounds(BodyId a, BodyId b, QueryMemory& memory) const {
    const Impl& w = impl();
    w.bodies.require_pair(a, b);
    const ProxyIndex first = a.slot - 1, second = b.slot - 1;
    const auto solid_a = w.bodies.solid_at(first), solid_b = w.bodies.solid_at(second);
    return ask_of(w.bodies, first, second, [&] { return ecods::depth_bounds(solid_a, solid_b, memory); });
}

double World::solid_distance(BodyId a, BodyId b) {
    return solid_distance(a, b, impl().workers.caller_memory());
}
std::optional<ClosestPoints> World::solid_closest(BodyId a, BodyId b) {
    return solid_closest(a, b, impl().workers.caller_memory());
}
std::optional<Depth> World::depth(BodyId a, BodyId b) {
    return depth(a, b, impl().workers.caller_memory());
}
std::optional<DepthBounds> World::depth_bounds(BodyId a, BodyId b) {
    return depth_bounds(a, b, impl().workers.caller_memory());
}

// ---- of all: asked in the order in which the trees find pairs, of which neighbours share bodies

namespace {

// Sends for what the next bodies' SolidInMemory are made from.
void prefetch_after(const Bodies& bodies, ProxyIndex proxy) noexcept {
    constexpr ProxyIndex solids_ahead = 16, parts_ahead = 8;
    if (bodies.end() - proxy > solids_ahead)
        convex::SolidInMemory::prefetch_solid(bodies[proxy + solids_ahead].convex());
    if (bodies.end() - proxy <= parts_ahead) return;
    if (const ConvexSolid* const solid = bodies[proxy + parts_ahead].convex())
        convex::SolidInMemory::prefetch_parts(*solid);
}

}  // namespace

auto World::Impl::near_convex_pairs(double limit) const -> NearConvexPairs {
    NearConvexPairs near;
    near.solids.resize(bodies.end());
    std::vector<ProxyIndex> convex;
    std::vector<Aabb> boxes;
    for (ProxyIndex proxy = 0; proxy < bodies.end(); ++proxy) {
        prefetch_after(bodies, proxy);
        const Slot& slot = bodies[proxy];
        if (slot.convex() == nullptr) continue;
        if (!convex::is_regular(slot.pose)) throw SingularPose(0, bodies.id_of(proxy));
        convex.push_back(proxy);
        boxes.push_back(enlarged(broad_phase.box(proxy), limit));
        near.solids[proxy] = convex::SolidInMemory(*slot.convex());
    }
    broad_phase.find_pairs_among(convex, boxes, near.pairs);
    std::erase_if(near.pairs, [&](const ProxyPair& pair) {
        return distance_below(broad_phase.box(pair.a), broad_phase.box(pair.b)) > limit || !bodies.is_enabled(pair);
    });
    return near;
}

// Of a thousand solids that move none is in a fast cache when its pair comes: it is sent for some pairs ahead.
template <class Answer, class Run, class Ask>
std::vector<Answer> World::Impl::ask_convex_pairs(double limit, const Run& run, const Ask& ask) const {
    using Body = Posed<ConvexSolid>;
    constexpr std::size_t ahead = 2;
    const NearConvexPairs near = near_convex_pairs(limit);
    std::vector<std::invoke_result_t<Ask, const Body&, const Body&, QueryMemory&>> found(near.pairs.size());
    FirstFailure failure;
    run(near.pairs.size(), [&](std::size_t at, QueryMemory& memory) {
        const ProxyPair& pair = near.pairs[at];
        if (at + ahead < near.pairs.size()) {
            const ProxyPair& later = near.pairs[at + ahead];
            near.solids[later.a].prefetch();
            near.solids[later.b].prefetch();
        }
        try {
            found[at] = ask(bodies.convex_at(pair.a), bodies.convex_at(pair.b), memory);
        } catch (...) {
            failure.keep(bodies.ids_of(pair), std::current_exception());
        }
    });
    failure.rethrow();
    std::vector<Answer> result;
    for (std::size_t at = 0; at < found.size(); ++at) {
        if (found[at]) result.push_back({bodies.ids_of(near.pairs[at]), *found[at]});
    }
    std::ranges::sort(result, {}, &Answer::bodies);
    return result;
}

template <class Run>
std::vector<BodyDepth> World::Impl::find_depths(const Run& run) const {
    return ask_convex_pairs<BodyDepth>(0, run,
                                       [](const auto& a, const auto& b, QueryMemory& memory) -> std::optional<Depth> {
                                           if (!convex::do_meet(a, b, memory)) return std::nullopt;
                                           return ecods::depth(a, b, memory);
                                       });
}

template <class Run>
std::vector<SolidDistance> World::Impl::find_solid_distances(double limit, const Run& run) const {
    require_distance(limit);
    return ask_convex_pairs<SolidDistance>(limit, run, [&](const auto& a, const auto& b, QueryMemory& memory) {
        return convex::distance_within(a, b, limit, memory);
    });
}

namespace {

// One after the other, in the memory of a caller.
auto one_by_one(QueryMemory& memory) {
    return [&memory](std::size_t count, const auto& run_one) {
        for (std::size_t at = 0; at < count; ++at) run_one(at, memory);
    };
}
auto by_workers(Workers& workers) {
    return [&workers](std::size_t count, const auto& run_one) { workers.run(count, run_one); };
}

}  // namespace

std::vector<BodyDepth> World::depths(QueryMemory& memory) const {
    return impl().find_depths(one_by_one(memory));
}
std::vector<SolidDistance> World::solid_distances(double limit, QueryMemory& memory) const {
    return impl().find_solid_distances(limit, one_by_one(memory));
}

std::vector<BodyDepth> World::depths() {
    Impl& w = impl();
    return w.traced<calls::Depths>(w.find_depths(by_workers(w.workers)));
}
std::vector<SolidDistance> World::solid_distances(double limit) {
    Impl& w = impl();
    return w.traced<calls::SolidDistances>(w.find_solid_distances(limit, by_workers(w.workers)), limit);
}

}  // namespace ecods
