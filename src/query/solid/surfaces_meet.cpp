#include "query/solid/surfaces_meet.hpp"

#include <array>

#include "bvh/walks/walk_two.hpp"
#include "exact/simplex/common_pose.hpp"
#include "query/intersection/overlap_bound.hpp"
#include "query/shape/mesh_body.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {

SurfaceAt::SurfaceAt(const Posed<MeshShape>& posed)
    : body(MeshBody(posed).ref()), tree(MeshBody(posed).tree), proper(nullptr) {}

SurfaceAt::SurfaceAt(const Posed<Solid>& posed)
    : body{SolidAccess::parts(*posed.what).proper.mesh.get(), nullptr, &posed.pose},
      tree(SolidAccess::tree(*posed.what)),
      proper(&SolidAccess::parts(*posed.what).proper) {
    body.extent = &tree.extent;
}

bool are_boxes_apart(const SurfaceAt& a, const SurfaceAt& b, QueryMemoryAccess::State& state) {
    const Pose &at_a = *a.body.pose, &at_b = *b.body.pose;
    return state.axes.bind({a.tree.boxes, at_a.R}, {b.tree.boxes, at_b.R}, at_b.t - at_a.t) >= 0;
}

exact::Frame& bind(exact::Frame& frame, const SurfaceAt& a, const SurfaceAt& b) {
    std::array<exact::BodyRef, 2> bodies{a.body, b.body};
    exact::cancel_common_pose(bodies);
    frame.bind(bodies);
    return frame;
}

bool surfaces_meet(const SurfaceAt& a, const SurfaceAt& b, QueryMemory& memory) {
    auto& state = QueryMemoryAccess::state(memory);
    if (are_boxes_apart(a, b, state)) return false;
    state.pair.reset_counts();
    state.pair.bind(a.body, b.body);
    bool meet = false;
    walk_two(a.tree.boxes, b.tree.boxes, state.stack, OverlapBound(state.axes.sets(), state.counts),
             [&](std::uint32_t i, std::uint32_t j) {
                 meet = a.has(i) && b.has(j) && state.pair.relation(i, j) != Relation::apart;
                 return !meet;
             });
    state.counts.stages += state.pair.counts();
    return meet;
}

}  // namespace ecods
