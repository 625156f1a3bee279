#include <algorithm>
#include <exception>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/limits.hpp"
#include "ecods/solid.hpp"
#include "geometry/box_distance.hpp"
#include "query/convex/solid_pair.hpp"
#include "world/enlarged.hpp"
#include "world/first_failure.hpp"
#include "world/least.hpp"
#include "world/world_impl.hpp"

namespace ecods {

// Asks about pairs in the order in which the trees find them: neighbours in this order often share a body.

namespace {

// Prefetches data of the bodies that follow `proxy`, from which their SolidInMemory objects will be made.
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

// Prefetches the solids of the pair two places ahead, because a thousand moving solids do not fit into a fast cache.
template <class Answer, class Function>
std::vector<Answer> World::Impl::ask_convex_pairs(double limit, const Ask& ask, const Function& find) const {
    using Body = Posed<ConvexSolid>;
    constexpr std::size_t ahead = 2;
    const NearConvexPairs near = near_convex_pairs(limit);
    std::vector<std::invoke_result_t<Function, const Body&, const Body&, QueryMemory&>> found(near.pairs.size());
    FirstFailure failure;
    workers.run_question(near.pairs.size(), ask, [&](std::size_t at, QueryMemory& memory) {
        const ProxyPair& pair = near.pairs[at];
        if (at + ahead < near.pairs.size()) {
            const ProxyPair& later = near.pairs[at + ahead];
            near.solids[later.a].prefetch();
            near.solids[later.b].prefetch();
        }
        try {
            found[at] = find(bodies.convex_at(pair.a), bodies.convex_at(pair.b), memory);
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

std::vector<BodyDepth> World::depths(const Ask& ask) const {
    const Impl& w = impl();
    auto found = w.ask_convex_pairs<BodyDepth>(0, ask, [](const auto& a, const auto& b, QueryMemory& memory) {
        return convex::do_meet(a, b, memory) ? ecods::depth(a, b, memory) : std::nullopt;
    });
    return w.traced<calls::Depths>(ask, std::move(found));
}

std::vector<SolidDistance> World::solid_distances(double max_distance, const Ask& ask) const {
    const Impl& w = impl();
    require_distance(max_distance);
    auto found =
        w.ask_convex_pairs<SolidDistance>(max_distance, ask, [&](const auto& a, const auto& b, QueryMemory& memory) {
            return convex::distance_within(a, b, max_distance, memory);
        });
    return w.traced<calls::SolidDistances>(ask, std::move(found), max_distance);
}

}  // namespace ecods
