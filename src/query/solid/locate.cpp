#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "base/make_error.hpp"
#include "ecods/solid.hpp"
#include "exact/sign/frame_signs.hpp"
#include "exact/simplex/common_pose.hpp"
#include "geometry/find_invalid.hpp"
#include "query/solid/ray_query.hpp"
#include "query/solid/solid_memory.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {
namespace {

// A point as a body: a mesh of one vertex at the origin, under a pose that moves it there.
struct PointMesh {
    std::shared_ptr<const Mesh> mesh = Mesh::create({Vec3(0, 0, 0)}, {Triangle{0, 0, 0}});
    exact::MeshExtent extent = exact::measure(*mesh);

    static const PointMesh& get() {
        static const PointMesh mesh;
        return mesh;
    }
};

// Whether a coordinate of the point is certainly none of the body's: further from the translation's than the corner of
// the mesh's box about its origin can be. u' = 2^-52: the difference is off by u' of it, the three products and sums by
// 3.01 u' of the sum, and 2^-50 is four of these; where they underflow, they lose 2^-1022 each. What overflows is
// infinite: a sum then is not less, and a difference is larger than every finite sum.
bool is_far(const Vec3& point, const exact::MeshExtent& extent, const Pose& pose) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        const double offset = std::abs(point[axis] - pose.t[axis]);
        const double reach =
            (std::abs(pose.R(axis, 0)) * extent.magnitude[0] + std::abs(pose.R(axis, 1)) * extent.magnitude[1]) +
            std::abs(pose.R(axis, 2)) * extent.magnitude[2];
        if (offset * (1 - 0x1p-50) > reach * (1 + 0x1p-50) + 0x1p-1000) return true;
    }
    return false;
}

}  // namespace

void require_valid(const Vec3& point) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(point[axis])) throw invalid_point(axis, point[axis]);
    }
}

Location locate(const Vec3& point, const Posed<Solid>& solid, QueryMemory& memory) {
    require_valid(point);
    auto& state = QueryMemoryAccess::state(memory);
    ++state.counts.queries;
    const MeshShape& shape = *solid.what;
    const MeshTree& tree = MeshShapeAccess::tree(shape);
    if (is_far(point, tree.extent, solid.pose)) return {};
    SolidMemory& own = SolidMemory::of(memory);
    const Pose at{Mat3::Identity(), point};
    const std::array<exact::BodyRef, 2> bodies{exact::BodyRef{&shape.mesh(), &tree.extent, &solid.pose},
                                               {PointMesh::get().mesh.get(), &PointMesh::get().extent, &at}};
    own.frame.bind(bodies);
    RayQuery rays(own.frame, 0, tree, own.stack, state.counts);
    const bool is_regular = exact::is_regular(solid.pose.R);
    const RayQuery::Place place = is_regular ? rays.place_of({1, 0}) : rays.flat_place_of({1, 0});
    if (place.on) return {Side::on, *place.on};
    return {place.is_inside ? Side::inside : Side::outside, {}};
}

}  // namespace ecods
