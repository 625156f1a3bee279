#include "programs/clash/make_shape.hpp"

#include <algorithm>
#include <limits>

#include "ecods/convex_solid.hpp"
#include "ecods/error.hpp"
#include "ecods/solid.hpp"

namespace ecods::clash {
namespace {

// Whether one of the triangles, as far as they are looked at, has vertices on both sides of its plane: then the mesh
// bounds no convex solid, which costs less to find out here than from the exact check.
//
// A determinant is computed with an error of at most 8 u times the sum of the magnitudes of its six products (Shewchuk
// 1997, bound A of orient3d: (7 + 56 u) u), each of which is at most e^3 for the mesh's largest extent e: 48 u e^3.
bool has_dent(const Mesh& mesh) {
    constexpr double u = std::numeric_limits<double>::epsilon() / 2;
    constexpr std::size_t work_limit = std::size_t{1} << 20;
    const auto vertices = mesh.vertices();
    Vec3 min = vertices[0];
    Vec3 max = vertices[0];
    for (const Vec3& v : vertices) {
        min = min.cwiseMin(v);
        max = max.cwiseMax(v);
    }
    const double extent = (max - min).maxCoeff();
    const double bound = 64 * u * extent * extent * extent;
    const std::size_t triangle_count = std::min(mesh.triangles().size(), work_limit / vertices.size() + 1);
    for (const Triangle& t : mesh.triangles().first(triangle_count)) {
        const Vec3& a = vertices[t[0]];
        const Vec3 normal = (vertices[t[1]] - a).cross(vertices[t[2]] - a);
        double least = 0;
        double most = 0;
        for (const Vec3& v : vertices) {
            const double height = normal.dot(v - a);
            least = std::min(least, height);
            most = std::max(most, height);
        }
        if (least < -bound && most > bound) return true;
    }
    return false;
}

std::shared_ptr<const MeshShape> make_convex(const std::shared_ptr<const Mesh>& mesh) {
    if (has_dent(*mesh)) return nullptr;
    try {
        return std::make_shared<const ConvexSolid>(mesh);
    } catch (const NotConvex&) {
    } catch (const NoInterior&) {
    }
    return nullptr;
}

}  // namespace

MadeShape make_shape(const std::shared_ptr<const Mesh>& mesh) {
    std::string reason;
    try {
        if (auto convex = make_convex(mesh)) return {std::move(convex), ""};
        return {std::make_shared<const Solid>(mesh), ""};
    } catch (const NotClosed& error) {
        reason = error.what();
    } catch (const SelfIntersecting& error) {
        reason = error.what();
    }
    return {std::make_shared<const MeshShape>(mesh), reason};
}

}  // namespace ecods::clash
