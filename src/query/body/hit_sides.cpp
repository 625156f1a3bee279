// Implements the functions of hit.hpp that return normals and sides of hits, and parts of lines inside solids.
#include <utility>
#include <vector>

#include "ecods/hit.hpp"
#include "ecods/solid.hpp"
#include "exact/measure/round/long_rounding.hpp"
#include "exact/point/posed_point.hpp"
#include "exact/point/vectors.hpp"
#include "query/body/inside_parts.hpp"
#include "query/body/line_gaps.hpp"
#include "query/body/starts_inside.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {
namespace {

using exact::ScaledInteger;
using exact::ScaledLongVector;

ScaledLongVector normal_of(const Posed<MeshShape>& body, std::uint32_t triangle) {
    const Mesh& mesh = body.what->mesh();
    const auto corner = [&](std::size_t i) {
        return exact::posed_point(body.pose, mesh.vertices()[mesh.triangles()[triangle][i]]);
    };
    const ScaledLongVector p = corner(0);
    return cross(minus(corner(1), p), minus(corner(2), p));
}

// Opposed is a normal n, with the sign and the square of n . d, and the square of |n|.
struct Opposed {
    Opposed(ScaledLongVector normal, const ScaledLongVector& direction) : n(std::move(normal)), nn(dot(n, n)) {
        const ScaledInteger along = dot(n, direction);
        sign = along.sign();
        square = along * along;
    }
    // Returns true if n . d / |n| is less than that of the other normal.
    bool precedes(const Opposed& other) const {
        if (sign != other.sign) return sign < other.sign;
        return sign * compare(square * other.nn, other.square * nn) < 0;
    }

    ScaledLongVector n;
    ScaledInteger nn, square;
    int sign = 0;
};

// Returns, of the normals of the triangles that are hit with the rank of hit `i`, one that is most opposed to the line.
std::optional<Vec3> most_opposed(const Line& line, std::span<const ExactHit> hits, std::size_t i,
                                 const Posed<MeshShape>& body) {
    const ScaledLongVector direction = direction_of(line);
    const std::uint32_t rank = hits[i].hit.rank;
    while (i > 0 && hits[i - 1].hit.rank == rank) --i;
    std::optional<Opposed> best;
    for (; i < hits.size() && hits[i].hit.rank == rank; ++i) {
        ScaledLongVector n = normal_of(body, hits[i].hit.triangle());
        if (exact::is_zero(n)) continue;
        Opposed next(std::move(n), direction);
        if (!best || next.precedes(*best)) best = std::move(next);
    }
    if (!best) return std::nullopt;
    return exact::round_direction(best->n);
}

std::optional<Vec3> round_normal(const Posed<MeshShape>& body, std::uint32_t triangle) {
    const ScaledLongVector n = normal_of(body, triangle);
    if (exact::is_zero(n)) return std::nullopt;
    return exact::round_direction(n);
}

std::optional<Vec3> normal_at(const Line& line, std::span<const ExactHit> hits, std::size_t i,
                              const Posed<MeshShape>& body) {
    const Feature& feature = hits[i].hit.feature;
    return feature.kind == Feature::Kind::face ? round_normal(body, feature.triangle)
                                               : most_opposed(line, hits, i, body);
}

Passage passage_of(const LineGaps& gaps, std::size_t i, const SidedHit& sided, bool has_inside) {
    if (has_inside) {
        const bool was_inside = sided.before == Side::inside, is_inside = sided.after == Side::inside;
        return was_inside == is_inside ? Passage::grazes : is_inside ? Passage::enters : Passage::leaves;
    }
    const HitKind kind = sided.hit.kind;
    const bool crosses = kind == HitKind::front || kind == HitKind::back ||
                         ((kind == HitKind::edge || kind == HitKind::vertex) && gaps.crosses(i));
    return crosses ? Passage::crosses : Passage::grazes;
}

template <class SegmentOrRay>
std::vector<SidedHit> find_sided(const SegmentOrRay& asked, const Posed<MeshShape>& posed, const Ask& ask) {
    validate(asked);
    Asking asking(ask);
    const Line line(asked);
    const PosedBody body(posed);
    return as_one_query(asking.memory(), [&] {
        const LineGaps gaps(line, body, asking.memory());
        const bool is_point = LineGaps::is_point(line);
        std::vector<SidedHit> result;
        if (is_inside(begin_of(asked), body, asking.memory())) {
            result.push_back({hit_inside(begin_of(asked)), Side::inside, Side::inside, Passage::begins, {}});
        }
        const bool begins_inside = !result.empty();
        for (std::size_t i = 0; i < gaps.hits().size(); ++i) {
            const ExactHit& exact = gaps.hits()[i];
            SidedHit sided;
            sided.hit = exact.hit;
            sided.before = is_point ? Side::on : gaps.before(exact.enter);
            sided.after = is_point ? Side::on : gaps.after(exact.leave);
            sided.passage = passage_of(gaps, i, sided, body.has_inside());
            sided.normal = normal_at(line, gaps.hits(), i, body.boundary());
            sided.hit.rank += begins_inside ? 1 : 0;
            body.rename(sided.hit.feature);
            result.push_back(std::move(sided));
        }
        return result;
    });
}

template <class SegmentOrRay>
std::optional<Vec3> find_normal(const SegmentOrRay& asked, const Posed<MeshShape>& posed, const Hit& hit,
                                const Ask& ask) {
    validate(asked);
    if (hit.feature.kind == Feature::Kind::none) return std::nullopt;
    if (hit.triangle() >= posed.what->mesh().triangles().size()) return std::nullopt;
    if (hit.feature.kind == Feature::Kind::face) return round_normal(posed, hit.triangle());
    Asking asking(ask);
    const Line line(asked);
    const PosedBody body(posed);
    const auto hits = as_one_query(asking.memory(), [&] { return exact_hits(line, body.boundary(), asking.memory()); });
    for (std::size_t i = 0; i < hits.size(); ++i) {
        Feature feature = hits[i].hit.feature;
        body.rename(feature);
        if (feature == hit.feature) return most_opposed(line, hits, i, body.boundary());
    }
    return std::nullopt;
}

PartEnd end_of(Side beyond) noexcept {
    return beyond == Side::outside ? PartEnd::crosses : beyond == Side::on ? PartEnd::along : PartEnd::grazes;
}

template <class SegmentOrRay>
std::vector<ExactPart> find_parts(const SegmentOrRay& asked, const Posed<Solid>& solid, QueryMemory& memory) {
    const Line line(asked);
    const PosedBody body{Posed<MeshShape>(solid)};
    return as_one_query(memory, [&] {
        const LineGaps gaps(line, body, memory);
        std::vector<ExactPart> parts;
        if (LineGaps::is_point(line) || !body.has_inside()) return parts;
        for (const LineGaps::Gap& gap : gaps.gaps()) {
            if (gap.side != Side::inside) continue;
            InsidePart part;
            const exact::RoundedOnLine from = exact::round_on_line(line.a, line.b, line.is_ray, gap.from.ref()),
                                       to = exact::round_on_line(line.a, line.b, line.is_ray, gap.to->ref());
            part.from = from.parameter;
            part.from_point = from.point;
            part.to = to.parameter;
            part.to_point = to.point;
            const bool is_first = &gap == &gaps.gaps().front(), is_last = &gap == &gaps.gaps().back();
            const bool begins_line = is_first && gap.from.num.is_zero() && !gaps.begins_on_surface();
            const bool ends_line = is_last && gaps.is_at_end(*gap.to) && !gaps.ends_on_surface();
            part.begin = begins_line ? PartEnd::of_line : end_of(gaps.before(gap.from));
            part.end = ends_line ? PartEnd::of_line : end_of(gaps.after(*gap.to));
            parts.push_back({gap.from, part});
        }
        return parts;
    });
}

template <class SegmentOrRay>
std::vector<InsidePart> round_parts(const SegmentOrRay& asked, const Posed<Solid>& solid, const Ask& ask) {
    validate(asked);
    Asking asking(ask);
    std::vector<InsidePart> parts;
    for (const ExactPart& each : find_parts(asked, solid, asking.memory())) parts.push_back(each.part);
    return parts;
}

}  // namespace

std::vector<SidedHit> sided_hits(const Segment& segment, const Posed<MeshShape>& body, const Ask& ask) {
    return find_sided(segment, body, ask);
}
std::vector<SidedHit> sided_hits(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask) {
    return find_sided(ray, body, ask);
}

std::optional<Vec3> hit_normal(const Segment& segment, const Posed<MeshShape>& body, const Hit& hit, const Ask& ask) {
    return find_normal(segment, body, hit, ask);
}
std::optional<Vec3> hit_normal(const Ray& ray, const Posed<MeshShape>& body, const Hit& hit, const Ask& ask) {
    return find_normal(ray, body, hit, ask);
}

std::vector<ExactPart> exact_parts(const Segment& segment, const Posed<Solid>& solid, QueryMemory& memory) {
    return find_parts(segment, solid, memory);
}
std::vector<ExactPart> exact_parts(const Ray& ray, const Posed<Solid>& solid, QueryMemory& memory) {
    return find_parts(ray, solid, memory);
}

std::vector<InsidePart> inside_parts(const Segment& segment, const Posed<Solid>& solid, const Ask& ask) {
    return round_parts(segment, solid, ask);
}
std::vector<InsidePart> inside_parts(const Ray& ray, const Posed<Solid>& solid, const Ask& ask) {
    return round_parts(ray, solid, ask);
}

}  // namespace ecods
