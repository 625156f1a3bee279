// HitMemory is the scratch memory of FirstHit and AllHits, and has the steps that both searches share.
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
    // A FaceHit is a triangle, by its vertices, that is certainly hit inside its face, and bounds of the scaled
    // parameter of this hit.
    struct FaceHit {
        double lower, upper;
        Triangle vertices;
    };
    // The sieve stores FaceHits. At the end the FaceHits are compared exactly, together with hits of edges and
    // vertices, so the sieve needs no values.
    using FaceSieve = Sieve<FaceHit, std::monostate>;

    LineAxes axes;
    TriangleHits triangles;
    std::vector<OrderedNode> stack;
    FaceSieve faces;
    StepRegion steps;  // region on the body to which the members are bound
    std::array<exact::LineHit, 3> hits;
    // `best`, `own` and `other` point to the least hit of all bodies, the least hit of the current body, and the hit of
    // the current triangle.
    exact::LineHit *best = &hits[0], *own = &hits[1], *other = &hits[2];

    static HitMemory& of(QueryMemory& memory) {
        return QueryMemoryAccess::part<HitMemory>(memory, &QueryMemoryAccess::State::hit);
    }

    // Prepares all members for a line and a body, which must both outlive each use of the members. Numbers that depend
    // on the body alone are kept if the body is the same as before. Returns where the line, up to the scaled parameter
    // `limit`, is relative to the body.
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

    // Prepares only `triangles`, for a line and the body to which the members are already bound.
    void bind_triangles(const Line& line, const ScaledLine& scaled, const Posed<MeshShape>& body) noexcept {
        triangles.bind(line, scaled, {&body.what->mesh(), &MeshShapeAccess::tree(*body.what).extent, &body.pose});
    }

    bool is_bound_to(const MeshTree& tree, const Pose& pose) const noexcept {
        return tree_id_ == tree.id && same_bits(pose_, pose);
    }

    // Calls result.visit(leaf, found) for each leaf with triangles that the line may hit, as walk_line() does. If the
    // place of the line is unknown, calls result.visit(triangle) for every triangle instead.
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

// Returns an exact hit of the line with `triangle` as a Hit, each number of which is rounded once.
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
