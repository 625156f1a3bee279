#include <limits>
#include <utility>
#include <vector>

#include "query/hit/hit_search.hpp"
#include "query/intersection/asking.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

const MeshShape* mesh_of(const Slot& slot) noexcept {
    return slot.kind == ShapeKind::mesh() ? static_cast<const MeshShape*>(slot.shape.get()) : nullptr;
}

void require_hits(const Bodies& bodies) {
    if (const auto kind = bodies.kind_without_hits()) throw NotSupported(Question::hits, *kind, *kind);
}

// Names candidates by proxies, which have the same order as the ids.
template <class SegmentOrRay>
std::optional<BodyHit> find_first(const SegmentOrRay& asked, const Bodies& bodies, const OverlapTracker& boxes,
                                  QueryMemory& memory, const std::optional<CollisionFilter>& filter) {
    validate(asked);
    require_hits(bodies);
    const Line line(asked);
    FirstHit first(line, memory);
    boxes.visit_along(asked, [&](ProxyIndex proxy) {
        const Slot& slot = bodies[proxy];
        if (filter && !may_meet(*filter, slot.filter)) return first.limit();
        if (const MeshShape* mesh = mesh_of(slot)) {
            first.ask({*mesh, slot.pose}, proxy);
        } else if (const auto hit = slot.shape->first_hit(asked, slot.pose, memory)) {
            first.offer(*hit, proxy);
        }
        return first.limit();
    });
    if (!first.found()) return std::nullopt;
    const KeyedHit least = first.get();
    return BodyHit{bodies.id_of(static_cast<ProxyIndex>(least.key)), least.hit};
}

template <class SegmentOrRay>
std::vector<BodyHit> find_all(const SegmentOrRay& asked, const Bodies& bodies, const OverlapTracker& boxes,
                              QueryMemory& memory, const std::optional<CollisionFilter>& filter) {
    validate(asked);
    require_hits(bodies);
    const Line line(asked);
    AllHits all(line, memory);
    boxes.visit_along(asked, [&](ProxyIndex proxy) {
        const Slot& slot = bodies[proxy];
        if (filter && !may_meet(*filter, slot.filter)) return std::numeric_limits<double>::infinity();
        if (const MeshShape* mesh = mesh_of(slot)) {
            all.ask({*mesh, slot.pose}, proxy);
        } else {
            for (const Hit& hit : slot.shape->all_hits(asked, slot.pose, memory)) all.offer(hit, proxy);
        }
        return std::numeric_limits<double>::infinity();
    });
    std::vector<BodyHit> result;
    for (const KeyedHit& each : all.get()) {
        result.push_back({bodies.id_of(static_cast<ProxyIndex>(each.key)), each.hit});
    }
    return result;
}

}  // namespace

std::optional<BodyHit> World::first_hit(const Segment& segment, std::optional<CollisionFilter> filter,
                                        const Ask& ask) const {
    const Impl& w = impl();
    auto found = find_first(segment, w.bodies, w.broad_phase, Asking(ask).memory(), filter);
    return w.traced<calls::FirstHit>(ask, std::move(found), segment, filter);
}

std::optional<BodyHit> World::first_hit(const Ray& ray, std::optional<CollisionFilter> filter, const Ask& ask) const {
    const Impl& w = impl();
    auto found = find_first(ray, w.bodies, w.broad_phase, Asking(ask).memory(), filter);
    return w.traced<calls::FirstHitOfRay>(ask, std::move(found), ray, filter);
}

std::vector<BodyHit> World::all_hits(const Segment& segment, std::optional<CollisionFilter> filter,
                                     const Ask& ask) const {
    const Impl& w = impl();
    auto found = find_all(segment, w.bodies, w.broad_phase, Asking(ask).memory(), filter);
    return w.traced<calls::AllHits>(ask, std::move(found), segment, filter);
}

std::vector<BodyHit> World::all_hits(const Ray& ray, std::optional<CollisionFilter> filter, const Ask& ask) const {
    const Impl& w = impl();
    auto found = find_all(ray, w.bodies, w.broad_phase, Asking(ask).memory(), filter);
    return w.traced<calls::AllHitsOfRay>(ask, std::move(found), ray, filter);
}

}  // namespace ecods
