#include <algorithm>
#include <array>

#include "ecods/solid.hpp"
#include "exact/simplex/common_pose.hpp"
#include "query/solid/ray_query.hpp"
#include "query/solid/solid_memory.hpp"
#include "query/solid/solid_parts.hpp"
#include "query/solid/solid_search.hpp"
#include "query/solid/surfaces_meet.hpp"

namespace ecods {
namespace {

// Whether a shell of `a`, flat or not, is inside b, whose pose is regular and whose surface it does not meet.
bool has_shell_inside(const Solid& solid, const SurfaceAt& a, const SurfaceAt& b, QueryMemory& memory) {
    SolidMemory& own = SolidMemory::of(memory);
    const std::array<exact::BodyRef, 2> bodies{a.body, b.body};
    own.frame.bind(bodies);
    RayQuery rays(own.frame, 1, b.tree, own.stack, QueryMemoryAccess::state(memory).counts);
    const auto triangles = a.body.mesh->triangles();
    return std::ranges::any_of(SolidAccess::shells(solid).first, [&](std::uint32_t triangle) {
        return rays.place_of({0, triangles[triangle][0]}).is_inside;
    });
}

// One pose at least is singular. The image of a solid under a singular matrix is that of its surface: on a line that
// is mapped to one point, an inner point is between two of the surface. It has no inner point.
SolidRelation flat_relation(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory) {
    ++QueryMemoryAccess::state(memory).counts.queries;
    const SurfaceAt surface_a(a), surface_b(b);
    const bool is_touching = surfaces_meet(surface_a, surface_b, memory) ||
                             (exact::is_regular(b.pose.R) && has_shell_inside(*a.what, surface_a, surface_b, memory)) ||
                             (exact::is_regular(a.pose.R) && has_shell_inside(*b.what, surface_b, surface_a, memory));
    return is_touching ? SolidRelation::touching : SolidRelation::apart;
}

}  // namespace

SolidRelation solid_relation(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory) {
    if (exact::is_regular(a.pose.R) && exact::is_regular(b.pose.R)) return SolidSearch(a, b, memory).find();
    return flat_relation(a, b, memory);
}

}  // namespace ecods
