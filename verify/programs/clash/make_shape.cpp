#include "programs/clash/make_shape.hpp"

#include <algorithm>
#include <utility>

#include "ecods/error.hpp"
#include "ecods/predicates.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"

namespace ecods::clash {
namespace {

// Returns null where the mesh bounds a solid that is not convex, or an empty one; throws where it bounds none.
std::shared_ptr<const MeshShape> make_convex(const std::shared_ptr<const Mesh>& mesh) {
    try {
        return std::make_shared<const ConvexSolid>(mesh);
    } catch (const NotSolid& error) {
        if (error.reason != NotSolid::Reason::dent && error.reason != NotSolid::Reason::no_interior) throw;
    }
    return nullptr;
}

bool has_area(const Mesh& mesh, const Triangle& triangle) {
    const auto vertices = mesh.vertices();
    for (int axis = 0; axis < 3; ++axis) {
        const auto shadow = [&](std::uint32_t vertex) {
            return Vec2(vertices[vertex][axis], vertices[vertex][(axis + 1) % 3]);
        };
        if (orient2d(shadow(triangle[0]), shadow(triangle[1]), shadow(triangle[2])) != Sign::zero) return true;
    }
    return false;
}

// A mesh without area bounds the empty solid, which has no point in common with anything: it is judged as what it is.
void require_area(const Mesh& mesh, std::string& reason) {
    const auto triangles = mesh.triangles();
    const bool is_found =
        std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) { return has_area(mesh, t); });
    if (!is_found) reason = "no triangle has an area";
}

}  // namespace

MadeShape make_shape(const std::shared_ptr<const Mesh>& mesh, bool may_be_convex) {
    std::string reason;
    try {
        if (auto convex = may_be_convex ? make_convex(mesh) : nullptr) return {std::move(convex), ""};
        auto solid = std::make_shared<const Solid>(mesh);
        require_area(*mesh, reason);
        if (reason.empty()) return {std::move(solid), ""};
    } catch (const NotSolid& error) {
        reason = error.what();
    }
    return {std::make_shared<const MeshShape>(mesh), reason};
}

}  // namespace ecods::clash
