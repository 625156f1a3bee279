// What the searches for hits work in, and what both of them do.
#pragma once

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include "bvh/axes/line_axes.hpp"
#include "bvh/walks/walk_line.hpp"
#include "ecods/hit.hpp"
#include "geometry/same_bits.hpp"
#include "query/hit/step_region.hpp"
#include "query/hit/triangle_hits.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/search/sieve.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

struct HitMemory final : QueryMemoryPart {
    // Contains the scaled parameter at which a triangle with these vertices is certainly hit inside its face.
    struct FaceHit {
        double lower, upper;
        Triangle vertices;
    };
    // Faces in question. What the sieve leaves is compared in full, with the hits of edges and vertices: no value is
    // kept.
    using FaceSieve = Sieve<FaceHit, std::monostate>;

    LineAxes axes;
    TriangleHits triangles;
    std::vector<LineNode> stack;
    FaceSieve faces;
    StepRegion steps;  // near the body that all is bound to
    std::array<exact::LineHit, 3> hits;
    // The least hit of all bodies, that of the body in question, and the one in question.
    exact::LineHit *best = &hits[0], *own = &hits[1], *other = &hits[2];

    static HitMemory& of(QueryMemory& memory) {
        return QueryMemoryAccess::part<HitMemory>(memory, &QueryMemoryAccess::State::hit);
    }

    // Prepares all for a line and a body, both of which must outlive the questions. What depends on the body alone is
    // kept: most bodies are asked more than once. Returns where the line is, up to the scaled parameter `limit`.
    LineAxes::Place bind(const Line& line, const ScaledLine& scaled, double limit, const Posed<MeshShape>& body) {
        const MeshTree& tree = MeshShapeAccess::tree(*body.what);
        const exact::BodyRef ref{&body.what->mesh(), &tree.extent, &body.pose};
        if (!is_bound_to(tree, body.pose)) {
            steps.forget();
            tree_id_ = tree.id;
            pose_ = body.pose;
            axes.bind(tree.boxes, body.pose);
            triangles.prepare(ref);
        }
        const LineAxes::Place place = axes.place(scaled, limit);
        if (place != LineAxes::Place::apart) triangles.bind(line, scaled, ref);
        return place;
    }

    // What the questions about single triangles need, of the body that all is bound to.
    void bind_triangles(const Line& line, const ScaledLine& scaled, const Posed<MeshShape>& body) noexcept {
        triangles.bind(line, scaled, {&body.what->mesh(), &MeshShapeAccess::tree(*body.what).extent, &body.pose});
    }

    bool is_bound_to(const MeshTree& tree, const Pose& pose) const noexcept {
        return tree_id_ == tree.id && same_bits(pose_, pose);
    }

    // Calls visit(triangle) for each triangle that the line may hit; `result` as for walk_line otherwise.
    template <class Result>
    void walk(const Posed<MeshShape>& body, LineAxes::Place place, Result& result) {
        if (place == LineAxes::Place::placed) {
            walk_line(MeshShapeAccess::tree(*body.what).boxes, axes.part(), stack, result);
        } else if (place == LineAxes::Place::unknown) {
            const std::size_t count = body.what->mesh().triangles().size();
            for (std::uint32_t i = 0; i < count; ++i) result.visit(i);
        }
    }

  private:
    std::uint64_t tree_id_ = 0;
    Pose pose_;
};

inline HitKind kind_of(const exact::LineHit& hit) noexcept {
    if (hit.is_along) return HitKind::along;
    if (hit.feature == Feature::Kind::vertex) return HitKind::vertex;
    if (hit.feature == Feature::Kind::edge) return HitKind::edge;
    return hit.facing < 0 ? HitKind::front : hit.facing > 0 ? HitKind::back : HitKind::face;
}

// Rounds everything once.
inline Hit rounded(const Line& line, const exact::LineHit& hit, std::uint32_t triangle) noexcept {
    Hit result;
    result.kind = kind_of(hit);
    result.feature = {hit.feature, triangle, hit.corner};
    const exact::RoundedOnLine enter = exact::round_on_line(line.a, line.b, line.is_ray, hit.enter.ref());
    result.parameter = result.leave_parameter = enter.parameter;
    result.point = result.leave_point = enter.point;
    if (hit.is_along) {
        const exact::RoundedOnLine leave = exact::round_on_line(line.a, line.b, line.is_ray, hit.leave.ref());
        result.leave_parameter = leave.parameter;
        result.leave_point = leave.point;
    }
    return result;
}

}  // namespace ecods
