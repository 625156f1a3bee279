#include "query/body/contained.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include "base/next.hpp"
#include "query/body/outside_ball.hpp"
#include "query/intersection/surface_intersection.hpp"
#include "query/solid/pieces.hpp"
#include "query/solid/ray_query.hpp"
#include "query/solid/solid_memory.hpp"
#include "query/solid/surfaces_meet.hpp"

namespace ecods {
namespace {

// Returns true if the vertex is certainly outside the box.
bool is_outside(const Aabb& box, const RoundedVertex& vertex) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        const double x = vertex.point[static_cast<std::size_t>(axis)];
        if (next_up(x + vertex.error) < box.min[axis] || next_down(x - vertex.error) > box.max[axis]) return true;
    }
    return false;
}

enum class Wanted : std::uint8_t { any, least };

// Returns the least triangle of a piece of the boundary of `part` that has a vertex in `whole`, which must have an
// inside: of the first such piece found if `wanted` is any, otherwise the least of all such pieces; nullopt if there is
// none.
std::optional<std::uint32_t> find_piece(const PosedBody& part, const PosedBody& whole, Wanted wanted,
                                        QueryMemory& memory) {
    const Pose& pose = part.boundary().pose;
    const Mesh& mesh = part.boundary().what->mesh();
    const Aabb box = whole.boundary().what->box(whole.boundary().pose);
    const Posed<Solid> solid = whole.solid();
    const SurfaceAt inner(part.boundary()), outer(solid);
    std::optional<RayQuery> rays;
    OutsideBall ball(whole.boundary(), memory);
    constexpr std::size_t few = 8;
    const std::vector<std::uint32_t>& pieces = MeshShapeAccess::pieces(*part.boundary().what, &find_pieces);
    const bool has_many = pieces.size() > few;
    std::optional<std::uint32_t> found;
    for (const std::uint32_t piece : pieces) {
        if (found && piece > *found) continue;
        const std::uint32_t vertex = mesh.triangles()[piece][0];
        const RoundedVertex rounded(pose, mesh.vertices()[vertex]);
        if (is_outside(box, rounded) || ball.contains(rounded)) continue;
        if (!rays) {
            SolidMemory& own = SolidMemory::of(memory);
            own.frame.bind(std::array{inner.body, outer.body});
            rays.emplace(own.frame, 1, outer.tree, own.stack, QueryMemoryAccess::state(memory).counts);
        }
        const RayQuery::Place place = rays->place_of({0, vertex});
        if (place.on || place.is_inside) {
            found = piece;
            if (wanted == Wanted::any) break;
        } else if (has_many) {
            ball.find_around(rounded);
        }
    }
    return found;
}

}  // namespace

bool is_part_inside(const BodyPairAsked& bodies, QueryMemory& memory) {
    return (bodies.b.has_inside() && find_piece(bodies.a, bodies.b, Wanted::any, memory)) ||
           (bodies.a.has_inside() && find_piece(bodies.b, bodies.a, Wanted::any, memory));
}

std::optional<ContainedFeatures> find_contained(const BodyPairAsked& bodies, QueryMemory& memory) {
    std::optional<std::uint32_t> of_a, of_b;
    if (bodies.b.has_inside()) of_a = find_piece(bodies.a, bodies.b, Wanted::least, memory);
    if (!of_a && bodies.a.has_inside()) of_b = find_piece(bodies.b, bodies.a, Wanted::least, memory);
    if (!of_a && !of_b) return std::nullopt;
    const auto meet = [&] { return surface::intersects(bodies.a.boundary(), bodies.b.boundary(), memory); };
    if (as_part(memory, meet)) return std::nullopt;
    ContainedFeatures result;
    if (of_a) result.a = {Feature::Kind::vertex, *of_a, 0};
    if (of_b) result.b = {Feature::Kind::vertex, *of_b, 0};
    bodies.rename(result);
    return result;
}

}  // namespace ecods
