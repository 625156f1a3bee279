// Implements the functions of hit.hpp for posed bodies. A line that begins inside a solid hits the solid at the line's
// beginning, and then the solid's surface.
#include "ecods/hit.hpp"

#include "base/double_key.hpp"
#include "ecods/solid.hpp"
#include "query/body/hit_lists.hpp"
#include "query/body/starts_inside.hpp"
#include "query/hit/surface_hit.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {
namespace {

template <class SegmentOrRay>
std::optional<Hit> find_first(const SegmentOrRay& line, const Posed<MeshShape>& posed, const Ask& ask) {
    if (posed.what->form() == MeshForm::surface) return surface::first_hit(line, posed, ask);
    validate(line);
    Asking asking(ask);
    const PosedBody body(posed);
    Ask boundary(asking.memory());
    boundary.witness = ask.witness;
    return as_one_query(asking.memory(), [&]() -> std::optional<Hit> {
        if (is_inside(begin_of(line), body, asking.memory())) return hit_inside(begin_of(line));
        auto hit = surface::first_hit(line, body.boundary(), boundary);
        if (hit) body.rename(hit->feature);
        return hit;
    });
}

template <class SegmentOrRay>
std::vector<Hit> find_all(const SegmentOrRay& line, const Posed<MeshShape>& posed, const Ask& ask) {
    if (posed.what->form() == MeshForm::surface) return surface::all_hits(line, posed, ask);
    validate(line);
    Asking asking(ask);
    const PosedBody body(posed);
    std::vector<Hit> hits = surface::all_hits(line, body.boundary(), asking.memory());
    for (Hit& hit : hits) body.rename(hit.feature);
    if (!is_inside(begin_of(line), body, asking.memory())) return hits;
    for (Hit& hit : hits) ++hit.rank;
    hits.insert(hits.begin(), hit_inside(begin_of(line)));
    return hits;
}

template <class SegmentOrRay>
HitLists find_lists(std::span<const SegmentOrRay> lines, const Posed<MeshShape>& body, const Ask& ask) {
    Asking asking(ask);
    return list_hits<HitLists>(lines, [&](const SegmentOrRay& line) { return find_all(line, body, asking.memory()); });
}

}  // namespace

bool is_inside(const Vec3& point, const PosedBody& body, QueryMemory& memory) {
    return body.has_inside() &&
           as_part(memory, [&] { return locate(point, body.solid(), memory).side == Side::inside; });
}

Hit hit_inside(const Vec3& begin) noexcept {
    Hit hit;
    hit.kind = HitKind::inside;
    hit.feature = no_feature;
    for (int axis = 0; axis < 3; ++axis) hit.point[axis] = key_of(begin[axis]) == 0 ? 0.0 : begin[axis];
    hit.leave_point = hit.point;
    return hit;
}

std::optional<Hit> first_hit(const Segment& segment, const Posed<MeshShape>& body, const Ask& ask) {
    return find_first(segment, body, ask);
}
std::optional<Hit> first_hit(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask) {
    return find_first(ray, body, ask);
}
std::vector<Hit> all_hits(const Segment& segment, const Posed<MeshShape>& body, const Ask& ask) {
    return find_all(segment, body, ask);
}
std::vector<Hit> all_hits(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask) {
    return find_all(ray, body, ask);
}

HitLists all_hits(std::span<const Segment> segments, const Posed<MeshShape>& body, const Ask& ask) {
    return find_lists(segments, body, ask);
}
HitLists all_hits(std::span<const Ray> rays, const Posed<MeshShape>& body, const Ask& ask) {
    return find_lists(rays, body, ask);
}

}  // namespace ecods
