#include <algorithm>
#include <exception>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "ecods/solid.hpp"
#include "geometry/box_distance.hpp"
#include "query/convex/solid_pair.hpp"
#include "world/enlarged.hpp"
#include "world/first_failure.hpp"
#include "world/pair_question.hpp"
#include "world/world_access.hpp"
#include "world/world_impl.hpp"

namespace ecods {

namespace {

// Prefetches the data of bodies some places after `proxy`, from which their SolidInMemory objects will be made.
void prefetch_after(const Bodies& bodies, ProxyIndex proxy) noexcept {
    constexpr ProxyIndex solids_ahead = 16, parts_ahead = 8;
    if (bodies.end() - proxy > solids_ahead)
        convex::SolidInMemory::prefetch_solid(bodies[proxy + solids_ahead].convex());
    if (bodies.end() - proxy <= parts_ahead) return;
    if (const ConvexSolid* const solid = bodies[proxy + parts_ahead].convex())
        convex::SolidInMemory::prefetch_parts(*solid);
}

}  // namespace

auto World::Impl::near_pairs(double limit, Kinds kinds) const -> NearPairs {
    NearPairs near;
    near.solids.resize(bodies.end());
    std::vector<ProxyIndex> chosen;
    std::vector<Aabb> boxes;
    for (ProxyIndex proxy = 0; proxy < bodies.end(); ++proxy) {
        prefetch_after(bodies, proxy);
        const Slot& slot = bodies[proxy];
        const bool is_convex = slot.convex() != nullptr && convex::is_regular(slot.pose);
        if (kinds != Kinds::all && slot.convex() != nullptr && !is_convex) {
            throw SingularPose(0, bodies.id_of(proxy));
        }
        const bool is_chosen = is_convex || (kinds == Kinds::all && slot.is_alive()) ||
                               (kinds == Kinds::convex && slot.is_alive() && slot.kind == ShapeKind::rounded_convex());
        if (!is_chosen) continue;
        chosen.push_back(proxy);
        boxes.push_back(enlarged(broad_phase.box(proxy), limit));
        if (is_convex) near.solids[proxy] = convex::SolidInMemory(*slot.convex());
    }
    broad_phase.find_pairs_among(chosen, boxes, near.pairs);
    std::erase_if(near.pairs, [&](const ProxyPair& pair) {
        return distance_below(broad_phase.box(pair.a), broad_phase.box(pair.b)) > limit || !bodies.is_enabled(pair);
    });
    return near;
}

// Asks the pairs in the order in which the trees find them, because successive pairs then often share a body.
// Prefetches the solids of the pair two places ahead, because a thousand moving solids do not fit into a fast cache.
template <class Answer, class Function>
std::vector<Answer> World::Impl::ask_pairs(const NearPairs& near, const Ask& ask, const Function& find) const {
    constexpr std::size_t ahead = 2;
    std::vector<std::invoke_result_t<Function, const ProxyPair&, QueryMemory&>> found(near.pairs.size());
    FirstFailure failure;
    workers.run_question(near.pairs.size(), ask, [&](std::size_t at, QueryMemory& memory) {
        const ProxyPair& pair = near.pairs[at];
        if (at + ahead < near.pairs.size()) {
            const ProxyPair& later = near.pairs[at + ahead];
            near.solids[later.a].prefetch();
            near.solids[later.b].prefetch();
        }
        try {
            found[at] = find(pair, memory);
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
    const Impl::NearPairs near = w.near_pairs(0, Impl::Kinds::convex);
    auto found =
        w.ask_pairs<BodyDepth>(near, ask, [&](const ProxyPair& pair, QueryMemory& memory) -> std::optional<Depth> {
            const BodyPair ids = w.bodies.ids_of(pair);
            if (!near.are_convex(pair)) return depth(ids.a, ids.b, memory);
            const Posed<ConvexSolid> a = w.bodies.convex_at(pair.a), b = w.bodies.convex_at(pair.b);
            return convex::do_meet(a, b, memory) ? ecods::depth(a, b, memory) : std::nullopt;
        });
    return w.traced<calls::Depths>(ask, std::move(found));
}

std::vector<PairDistance> World::signed_distances(double max_distance, const Ask& ask) const {
    const Impl& w = impl();
    require_distance(max_distance);
    w.require_answers(Question::within);
    w.require_answers(Question::distance);
    const bool have_signs = w.tests.find(ShapeKind::mesh(), ShapeKind::mesh()).has_signs;
    const Impl::NearPairs near = w.near_pairs(max_distance, Impl::Kinds::all);
    auto found =
        w.ask_pairs<PairDistance>(near, ask, [&](const ProxyPair& pair, QueryMemory& memory) -> std::optional<double> {
            if (have_signs && near.are_convex(pair)) {
                const Posed<ConvexSolid> a = w.bodies.convex_at(pair.a), b = w.bodies.convex_at(pair.b);
                const std::optional<double> apart = convex::distance_within(a, b, max_distance, memory);
                if (!apart || key_of(*apart) != 0) return apart;
                return opposite(ecods::depth(a, b, memory)->depth);
            }
            const PairQuestion asked(w.bodies, w.tests, pair);
            PairWitness witness;
            const Ask in_memory(memory, witness);
            return asked.is_within(max_distance, in_memory) ? std::optional(asked.distance(in_memory)) : std::nullopt;
        });
    return w.traced<calls::SignedDistances>(ask, std::move(found), max_distance);
}

std::vector<PairDistance> WorldAccess::unsigned_distances(const World& world, double max_distance) {
    const World::Impl& w = world.impl();
    require_distance(max_distance);
    return w.ask_pairs<PairDistance>(w.near_pairs(max_distance, World::Impl::Kinds::convex_solids), {},
                                     [&](const ProxyPair& pair, QueryMemory& memory) {
                                         return convex::distance_within(w.bodies.convex_at(pair.a),
                                                                        w.bodies.convex_at(pair.b), max_distance,
                                                                        memory);
                                     });
}

}  // namespace ecods
