#include <algorithm>
#include <limits>

#include "oracle/float_environment.hpp"
#include "oracle/mesh_impl.hpp"
#include "oracle/oracle.hpp"

namespace ecods::oracle {
namespace {

// A box that contains nothing yet.
Aabb nothing() {
    const double infinity = std::numeric_limits<double>::infinity();
    return {Vec3::Constant(infinity), Vec3::Constant(-infinity)};
}

void add_point(Aabb& box, const IntervalKernel::Point_3& point) {
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = std::min(box.min[axis], point[axis].inf());
        box.max[axis] = std::max(box.max[axis], point[axis].sup());
    }
}

}  // namespace

Simplex OracleMesh::Impl::simplex(std::size_t triangle) const {
    const Triangle& t = mesh->triangles()[triangle];
    const auto v = mesh->vertices();
    return make_simplex(pose, {v[t[0]], v[t[1]], v[t[2]]}, {intervals[t[0]], intervals[t[1]], intervals[t[2]]});
}

Aabb OracleMesh::Impl::triangle_box(std::size_t triangle) const {
    Aabb box = nothing();
    for (const std::uint32_t vertex : mesh->triangles()[triangle]) add_point(box, intervals[vertex]);
    return box;
}

OracleMesh::OracleMesh(std::shared_ptr<const Mesh> mesh, const Pose& pose) {
    const FloatEnvironment environment;
    auto impl = std::make_shared<Impl>();
    impl->mesh = std::move(mesh);
    impl->pose = pose;
    impl->intervals.reserve(impl->mesh->vertices().size());
    for (const Vec3& v : impl->mesh->vertices()) impl->intervals.push_back(posed_point<IntervalKernel>(pose, v));
    impl->outer_box = nothing();
    for (const Triangle& triangle : impl->mesh->triangles()) {
        for (const std::uint32_t vertex : triangle) add_point(impl->outer_box, impl->intervals[vertex]);
    }
    impl_ = std::move(impl);
}

const Aabb& OracleMesh::outer_box() const noexcept {
    return impl_->outer_box;
}

}  // namespace ecods::oracle
