// Answers where a line enters and leaves the bodies of a world, and which parts of the line are inside the bodies.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "query/body/inside_parts.hpp"
#include "query/intersection/asking.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

// Throws NotSupported unless the shapes of all bodies are meshes. Cost: a pass over the kinds. In a world of version 1
// (are_solids_surfaces), lines met solids as surfaces, so their hits have no sides there.
template <class Impl>
void require_meshes(const Impl& world, const char* question) {
    if (!world.are_solids_surfaces && world.bodies.are_meshes()) return;
    throw NotSupported(std::string(question) + ": the shapes of all bodies must be meshes or solids");
}

Posed<MeshShape> mesh_at(const Slot& slot) {
    return {static_cast<const MeshShape&>(*slot.shape), slot.pose};
}

// Returns the hits in the order of all_hits(), in which the hits of each body are in their own order.
template <class SegmentOrRay>
std::vector<BodySidedHit> find_sided(const World& world, const Bodies& bodies, const SegmentOrRay& line,
                                     const std::optional<CollisionFilter>& filter, QueryMemory& memory) {
    struct OfBody {
        std::vector<SidedHit> hits;
        std::size_t next = 0;
    };
    std::unordered_map<ProxyIndex, OfBody> found;
    std::vector<BodySidedHit> result;
    for (const BodyHit& hit : world.all_hits(line, filter, memory)) {
        const ProxyIndex proxy = bodies.require(hit.body);
        const auto [at, is_new] = found.try_emplace(proxy);
        OfBody& of_body = at->second;
        if (is_new) of_body.hits = sided_hits(line, mesh_at(bodies[proxy]), memory);
        SidedHit& sided = of_body.hits[of_body.next++];
        sided.hit.rank = hit.hit.rank;
        result.push_back({hit.body, sided});
    }
    return result;
}

template <class Impl, class SegmentOrRay>
std::vector<BodyInsidePart> find_parts(const Impl& world, const SegmentOrRay& line,
                                       const std::optional<CollisionFilter>& filter, QueryMemory& memory) {
    struct Found {
        ExactPart exact;
        ProxyIndex proxy;
    };
    std::vector<Found> found;
    world.broad_phase.visit_along(line, [&](ProxyIndex proxy) {
        const Slot& slot = world.bodies[proxy];
        const bool is_asked = slot.solid() != nullptr && (!filter || may_meet(*filter, slot.filter));
        if (is_asked) {
            for (ExactPart& part : exact_parts(line, world.bodies.solid_at(proxy), memory)) {
                found.push_back({std::move(part), proxy});
            }
        }
        return std::numeric_limits<double>::infinity();
    });
    std::ranges::sort(found, [](const Found& a, const Found& b) {
        const int order = compare(a.exact.from, b.exact.from);
        return order != 0 ? order < 0 : a.proxy < b.proxy;
    });
    std::vector<BodyInsidePart> parts;
    for (const Found& each : found) parts.push_back({world.bodies.id_of(each.proxy), each.exact.part});
    return parts;
}

// Answers a question about a line and all bodies, and writes it to the trace. find(memory) returns the answer.
template <template <class> class Row, class Impl, class SegmentOrRay, class Find>
auto ask_line(const Impl& world, const char* question, const SegmentOrRay& line,
              const std::optional<CollisionFilter>& filter, const Ask& ask, const Find& find) {
    validate(line);
    require_meshes(world, question);
    return world.template traced<Row>(ask, find(Asking(ask).memory()), line, filter);
}

}  // namespace

std::vector<BodySidedHit> World::sided_hits(const Segment& segment, std::optional<CollisionFilter> filter,
                                            const Ask& ask) const {
    const Impl& w = impl();
    return ask_line<calls::SidedHits>(w, "sided_hits", segment, filter, ask, [&](QueryMemory& memory) {
        return find_sided(*this, w.bodies, segment, filter, memory);
    });
}

std::vector<BodySidedHit> World::sided_hits(const Ray& ray, std::optional<CollisionFilter> filter,
                                            const Ask& ask) const {
    const Impl& w = impl();
    return ask_line<calls::SidedHitsOfRay>(w, "sided_hits", ray, filter, ask, [&](QueryMemory& memory) {
        return find_sided(*this, w.bodies, ray, filter, memory);
    });
}

std::vector<BodyInsidePart> World::inside_parts(const Segment& segment, std::optional<CollisionFilter> filter,
                                                const Ask& ask) const {
    const Impl& w = impl();
    return ask_line<calls::InsideParts>(w, "inside_parts", segment, filter, ask,
                                        [&](QueryMemory& memory) { return find_parts(w, segment, filter, memory); });
}

std::vector<BodyInsidePart> World::inside_parts(const Ray& ray, std::optional<CollisionFilter> filter,
                                                const Ask& ask) const {
    const Impl& w = impl();
    return ask_line<calls::InsidePartsOfRay>(w, "inside_parts", ray, filter, ask,
                                             [&](QueryMemory& memory) { return find_parts(w, ray, filter, memory); });
}

}  // namespace ecods
