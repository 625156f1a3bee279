#include "query/hit/hit_memory.hpp"
#include "query/hit/hit_search.hpp"
#include "query/hit/surface_hit.hpp"
#include "query/intersection/asking.hpp"

namespace ecods {

namespace {

std::optional<Hit> find_first(const Line& line, const Posed<MeshShape>& body, QueryMemory& memory,
                              PairWitness& witness) {
    FirstHit first(line, memory, true);
    first.ask(body, 0, witness);
    if (!first.found()) return std::nullopt;
    return first.get().hit;
}

// Returns the first hit, as find_first() does. If the segment is within the region that was gathered for earlier
// segments, tests only the triangles of that region, without a walk.
std::optional<Hit> find_step(const Line& segment, const Posed<MeshShape>& body, QueryMemory& memory,
                             PairWitness& witness) {
    HitMemory& own = HitMemory::of(memory);
    const MeshTree& tree = MeshShapeAccess::tree(*body.what);
    QueryCounts& counts = QueryMemoryAccess::state(memory).counts;
    if (!own.is_bound_to(tree, body.pose) || !own.steps.holds(segment)) {
        const std::optional<Hit> hit = find_first(segment, body, memory, witness);
        own.steps.follow(segment, tree.boxes, own.axes, counts.box_tests);
        return hit;
    }
    const auto triangles =
        own.steps.leaves().find(tree.boxes, own.axes, segment.a, segment.b, counts.hits.triangle_tests);
    if (triangles.empty()) {
        ++counts.queries;
        return std::nullopt;
    }
    FirstHit first(segment, memory, true);
    first.ask_about(triangles, body, 0, witness);
    if (!first.found()) return std::nullopt;
    return first.get().hit;
}

std::vector<Hit> find_all(const Line& line, const Posed<MeshShape>& body, QueryMemory& memory) {
    AllHits all(line, memory);
    all.ask(body, 0);
    std::vector<Hit> result;
    for (const KeyedHit& keyed : all.get()) result.push_back(keyed.hit);
    return result;
}

}  // namespace

std::optional<Hit> surface::first_hit(const Segment& segment, const Posed<MeshShape>& body, const Ask& ask) {
    validate(segment);
    Asking asking(ask);
    if (ask.witness != nullptr) return find_step(Line(segment), body, asking.memory(), *ask.witness);
    return find_first(Line(segment), body, asking.memory(), asking.witness());
}

std::optional<Hit> surface::first_hit(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask) {
    validate(ray);
    Asking asking(ask);
    return find_first(Line(ray), body, asking.memory(), asking.witness());
}

std::vector<Hit> surface::all_hits(const Segment& segment, const Posed<MeshShape>& body, const Ask& ask) {
    validate(segment);
    return find_all(Line(segment), body, Asking(ask).memory());
}

std::vector<Hit> surface::all_hits(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask) {
    validate(ray);
    return find_all(Line(ray), body, Asking(ask).memory());
}

}  // namespace ecods
