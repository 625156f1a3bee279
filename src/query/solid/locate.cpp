#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/solid.hpp"
#include "exact/sign/frame_signs.hpp"
#include "exact/simplex/common_pose.hpp"
#include "geometry/find_invalid.hpp"
#include "query/solid/ray_query.hpp"
#include "query/solid/solid_memory.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {
namespace {

// A mesh of one vertex at the origin: under a translation it is a point that stands for a body.
struct PointMesh {
    std::shared_ptr<const Mesh> mesh = Mesh::create({Vec3(0, 0, 0)}, {Triangle{0, 0, 0}});
    exact::MeshExtent extent = exact::measure(*mesh);

    static const PointMesh& get() {
        static const PointMesh mesh;
        return mesh;
    }
};

// True if on some axis no point of the body can have the point's coordinate: |point - t| exceeds the sum of |R_k| m_k,
// where m is the greatest magnitude of the mesh's coordinates by axis. Rounding, with u' = 2^-52: the difference is off
// by u' of itself, the three products and sums by 3.01 u' of the sum, and 2^-50 = 4 u'; each underflow loses at most
// 2^-1022. Overflow does no harm: an infinite sum is not exceeded, and an infinite difference is larger than every
// finite sum.
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
        if (!is_finite(point[axis])) throw InvalidPoint(axis, point[axis]);
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
