#include <array>
#include <cmath>

#include "base/make_error.hpp"
#include "ecods/solid.hpp"
#include "exact/sign/frame_signs.hpp"
#include "exact/simplex/common_pose.hpp"
#include "geometry/find_invalid.hpp"
#include "query/intersection/asking.hpp"
#include "query/shape/mesh_body.hpp"
#include "query/solid/ray_query.hpp"
#include "query/solid/solid_memory.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {
namespace {

// Returns true if on some axis k no point of the body can be equal to the point: |point - t| exceeds the sum of |R_ki|
// m_i, where m_i is the greatest magnitude of the mesh's coordinates on axis i. Rounding, with u' = 2^-52: the
// difference is off by u' of itself, the three products and sums by 3.01 u' of the sum, and 2^-50 = 4 u'; each
// underflow loses at most 2^-1022. Overflow does no harm: an infinite sum is not exceeded, and an infinite difference
// is larger than every finite sum.
// Claim: verify/proofs/small_bounds.py
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

Location locate(const Vec3& point, const Posed<Solid>& solid, const Ask& ask) {
    require_valid(point);
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    auto& state = QueryMemoryAccess::state(memory);
    ++state.counts.queries;
    const MeshBody body(*solid.what, solid.pose);
    if (is_far(point, body.tree.extent, solid.pose)) return {};
    SolidMemory& own = SolidMemory::of(memory);
    const Pose at{Mat3::Identity(), point};
    own.frame.bind(std::array{body.ref(), MeshBody(point_shape(), at).ref()});
    RayQuery rays(own.frame, 0, body.tree, own.stack, state.counts);
    const bool may_be_inside = has_inside(*solid.what) && exact::is_regular(solid.pose.R);
    const RayQuery::Place place =
        may_be_inside ? rays.place_of({1, 0}) : rays.flat_place_of({1, 0}, SolidAccess::parts(*solid.what).has_area);
    if (place.on) return {Side::on, *place.on};
    return {place.is_inside ? Side::inside : Side::outside, {}};
}

}  // namespace ecods
