#include <limits>
#include <utility>
#include <vector>

#include "query/body/hit_lists.hpp"
#include "query/body/starts_inside.hpp"
#include "query/hit/hit_search.hpp"
#include "query/intersection/asking.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

void require_hits(const Bodies& bodies) {
    if (const auto kind = bodies.kind_without_hits()) throw NotSupported(Question::hits, *kind, *kind);
}

// Targets are the bodies of a world that a line may hit.
struct Targets {
    const Bodies& bodies;
    const OverlapTracker& boxes;
    PosedBody::Meaning meaning;

    // Returns the mesh of a body; nullopt if its shape is not a mesh.
    std::optional<PosedBody> mesh_at(ProxyIndex proxy) const {
        const Slot& slot = bodies[proxy];
        if (slot.kind != ShapeKind::mesh()) return std::nullopt;
        return PosedBody({static_cast<const MeshShape&>(*slot.shape), slot.pose}, meaning);
    }

    // Returns the hit with the id of its body, and with its feature named in the body's mesh.
    BodyHit named(KeyedHit found) const {
        const auto proxy = static_cast<ProxyIndex>(found.key);
        if (const auto body = mesh_at(proxy)) body->rename(found.hit.feature);
        return {bodies.id_of(proxy), found.hit};
    }
};

// `world` is a World::Impl.
template <class Impl>
Targets targets_of(const Impl& world) {
    const bool are_surfaces = world.are_solids_surfaces;
    return {world.bodies, world.broad_phase, are_surfaces ? PosedBody::Meaning::surface : PosedBody::Meaning::set};
}

// Returns the first hit of the line with a body; nullopt if the line hits none. Names bodies by proxies, which have the
// same order as the ids.
template <class SegmentOrRay>
std::optional<BodyHit> find_first(const SegmentOrRay& asked, const Targets& targets, QueryMemory& memory,
                                  const std::optional<CollisionFilter>& filter) {
    validate(asked);
    require_hits(targets.bodies);
    const Line line(asked);
    FirstHit first(line, memory);
    targets.boxes.visit_along(asked, [&](ProxyIndex proxy) {
        const Slot& slot = targets.bodies[proxy];
        if (filter && !may_meet(*filter, slot.filter)) return first.limit();
        if (const auto body = targets.mesh_at(proxy)) {
            if (is_inside(begin_of(asked), *body, memory)) {
                first.offer(hit_inside(begin_of(asked)), proxy);
            } else {
                first.ask(body->boundary(), proxy);
            }
        } else if (const auto hit = first.beside([&] { return slot.shape->first_hit(asked, slot.pose, memory); })) {
            first.offer(*hit, proxy);
        }
        return first.limit();
    });
    if (!first.found()) return std::nullopt;
    return targets.named(first.get());
}

template <class SegmentOrRay>
std::vector<BodyHit> find_all(const SegmentOrRay& asked, const Targets& targets, QueryMemory& memory,
                              const std::optional<CollisionFilter>& filter) {
    validate(asked);
    require_hits(targets.bodies);
    const Line line(asked);
    AllHits all(line, memory);
    targets.boxes.visit_along(asked, [&](ProxyIndex proxy) {
        const Slot& slot = targets.bodies[proxy];
        if (filter && !may_meet(*filter, slot.filter)) return std::numeric_limits<double>::infinity();
        if (const auto body = targets.mesh_at(proxy)) {
            if (is_inside(begin_of(asked), *body, memory)) all.offer(hit_inside(begin_of(asked)), proxy);
            all.ask(body->boundary(), proxy);
        } else {
            for (const Hit& hit : slot.shape->all_hits(asked, slot.pose, memory)) all.offer(hit, proxy);
        }
        return std::numeric_limits<double>::infinity();
    });
    std::vector<BodyHit> result;
    for (const KeyedHit& each : all.get()) result.push_back(targets.named(each));
    return result;
}

// Returns the hits of each line, found by one all_hits() for each line. So a trace records each line as a question of
// its own, if `ask` has no memory.
template <class SegmentOrRay>
BodyHitLists find_lists(const World& world, std::span<const SegmentOrRay> lines,
                        const std::optional<CollisionFilter>& filter, const Ask& ask) {
    return list_hits<BodyHitLists>(lines, [&](const SegmentOrRay& line) { return world.all_hits(line, filter, ask); });
}

}  // namespace

std::optional<BodyHit> World::first_hit(const Segment& segment, std::optional<CollisionFilter> filter,
                                        const Ask& ask) const {
    const Impl& w = impl();
    auto found = find_first(segment, targets_of(w), Asking(ask).memory(), filter);
    return w.traced<calls::FirstHit>(ask, std::move(found), segment, filter);
}

std::optional<BodyHit> World::first_hit(const Ray& ray, std::optional<CollisionFilter> filter, const Ask& ask) const {
    const Impl& w = impl();
    auto found = find_first(ray, targets_of(w), Asking(ask).memory(), filter);
    return w.traced<calls::FirstHitOfRay>(ask, std::move(found), ray, filter);
}

std::vector<BodyHit> World::all_hits(const Segment& segment, std::optional<CollisionFilter> filter,
                                     const Ask& ask) const {
    const Impl& w = impl();
    auto found = find_all(segment, targets_of(w), Asking(ask).memory(), filter);
    return w.traced<calls::AllHits>(ask, std::move(found), segment, filter);
}

std::vector<BodyHit> World::all_hits(const Ray& ray, std::optional<CollisionFilter> filter, const Ask& ask) const {
    const Impl& w = impl();
    auto found = find_all(ray, targets_of(w), Asking(ask).memory(), filter);
    return w.traced<calls::AllHitsOfRay>(ask, std::move(found), ray, filter);
}

BodyHitLists World::all_hits(std::span<const Segment> segments, std::optional<CollisionFilter> filter,
                             const Ask& ask) const {
    impl();  // throws MovedFromWorld, even if there is no line
    return find_lists(*this, segments, filter, ask);
}

BodyHitLists World::all_hits(std::span<const Ray> rays, std::optional<CollisionFilter> filter, const Ask& ask) const {
    impl();
    return find_lists(*this, rays, filter, ask);
}

}  // namespace ecods
