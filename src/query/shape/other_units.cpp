#include "query/shape/other_units.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "exact/number/power.hpp"
#include "geometry/used_vertices.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {
namespace {

using exact::exponent_above;

constexpr int moderate_max = 200;
constexpr double least = 0x1p-200, most = 0x1p200;

bool is_moderate(int exponent) {
    return exponent >= -moderate_max && exponent <= moderate_max;
}

// Returns the exponent of the mesh's largest coordinate.
int exponent_of(const MeshShape& shape) {
    const Vec3& size = MeshShapeAccess::tree(shape).extent.magnitude;
    return std::max({exponent_above(size[0]), exponent_above(size[1]), exponent_above(size[2])});
}

// Returns the exponent e for which the shape's mesh is scaled by 2^e; 0 if it is not scaled. The exponent depends on
// the shape alone.
int scale_of(const MeshShape& shape) {
    const int exponent = exponent_of(shape);
    return is_moderate(exponent) || exponent == exact::exponent_of_zero ? 0 : -exponent;
}

template <class Numbers>
int exponent_of_all(const Numbers& numbers) {
    int exponent = exact::exponent_of_zero;
    for (int i = 0; i < numbers.size(); ++i) exponent = std::max(exponent, exponent_above(numbers.data()[i]));
    return exponent;
}

// Returns true if each of the numbers times 2^e is zero or a double that is not subnormal.
template <class Numbers>
bool can_scale_all(const Numbers& numbers, int e) {
    return std::all_of(numbers.data(), numbers.data() + numbers.size(), [e](double x) {
        return exact::decode(x).m == 0 || (exact::decode(x).e + e >= -1022 && exponent_above(x) + e <= 1024);
    });
}

template <class Numbers>
Numbers scaled_all(const Numbers& numbers, int e) {
    Numbers result;
    for (int i = 0; i < numbers.size(); ++i) result.data()[i] = exact::times_power(numbers.data()[i], e);
    return result;
}

// Returns the mesh scaled by 2^e. Vertices that no triangle uses keep their coordinates.
std::shared_ptr<const Mesh> scaled_mesh(const Mesh& mesh, int e) {
    std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
    std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
    for_each_used_vertex(mesh, [&](std::uint32_t index) { vertices[index] = scaled_all(mesh.vertices()[index], e); });
    return Mesh::create(std::move(vertices), std::move(triangles));
}

const MeshShape& own_mesh(const MeshShape& shape) {
    const int e = scale_of(shape);
    return e == 0 ? shape : MeshShapeAccess::in_other_units(shape, scaled_mesh, e);
}

// Returns roughly the largest coordinate of the posed shape relative to its translation. If the result is subnormal, it
// may be far off.
double size_of(const MeshShape& shape, const Pose& pose) {
    return pose.R.cwiseAbs().maxCoeff() * MeshShapeAccess::tree(shape).extent.magnitude.maxCoeff();
}

}  // namespace

OtherUnits::OtherUnits(const Moving<MeshShape>& a, const Moving<MeshShape>& b)
    : OtherUnits(a, b, Vec3::Zero(), Vec3::Zero()) {}

OtherUnits::OtherUnits(const Moving<MeshShape>& a, const Moving<MeshShape>& b, const Vec3& way_a, const Vec3& way_b) {
    const double size = std::max(std::max(size_of(*a.what, a.from), size_of(*a.what, a.to)),
                                 std::max(size_of(*b.what, b.from), size_of(*b.what, b.to)));
    if (size > least && size < most) [[likely]]
        return;
    choose({Body{a.what, {&a.from, &a.to}}, Body{b.what, {&b.from, &b.to}}}, {&way_a, &way_b});
}

OtherUnits::OtherUnits(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Vec3& motion) {
    const double size = std::max(size_of(*a.what, a.pose), size_of(*b.what, b.pose));
    if (size > least && size < most) [[likely]]
        return;
    choose({Body{a.what, {&a.pose, &a.pose}}, Body{b.what, {&b.pose, &b.pose}}}, {&motion});
}

OtherUnits::OtherUnits(const Turning<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b) {
    const double size = std::max(size_of(*a.what, a.pose), size_of(*b.what, b.pose));
    if (size > least && size < most) [[likely]]
        return;
    choose({Body{a.what, {&a.pose, &a.pose}}, Body{b.what, {&b.pose, &b.pose}}},
           {&a.turn.pivot_from, &a.turn.pivot_to, &motion});
}

OtherUnits::OtherUnits(const Turning<MeshShape>& a, const Turning<MeshShape>& b) {
    const double size = std::max(size_of(*a.what, a.pose), size_of(*b.what, b.pose));
    if (size > least && size < most) [[likely]]
        return;
    choose({Body{a.what, {&a.pose, &a.pose}}, Body{b.what, {&b.pose, &b.pose}}},
           {&a.turn.pivot_from, &a.turn.pivot_to, &b.turn.pivot_from, &b.turn.pivot_to});
}

OtherUnits::OtherUnits(const Turning<MeshShape>& a, const Moving<MeshShape>& b) {
    const double size = std::max({size_of(*a.what, a.pose), size_of(*b.what, b.from), size_of(*b.what, b.to)});
    if (size > least && size < most) [[likely]]
        return;
    choose({Body{a.what, {&a.pose, &a.pose}}, Body{b.what, {&b.from, &b.to}}}, {&a.turn.pivot_from, &a.turn.pivot_to});
}

OtherUnits::OtherUnits(const Posed<MeshShape>& a, const Posed<MeshShape>& b, std::span<const Vec3> vectors)
    : OtherUnits(a, b) {
    if (!std::ranges::all_of(vectors, [&](const Vec3& v) { return can_scale_all(v, exponent_); })) exponent_ = 0;
}

void OtherUnits::choose(const std::array<Body, 2>& bodies, std::initializer_list<const Vec3*> vectors) {
    int exponent = 2 * exact::exponent_of_zero;
    for (const Body& body : bodies) {
        const int of_mesh = exponent_of(*body.shape);
        for (const Pose* pose : body.poses) exponent = std::max(exponent, exponent_of_all(pose->R) + of_mesh);
    }
    if (is_moderate(exponent) || exponent < exact::exponent_of_zero / 2) return;
    exponent_ = -exponent;
    const bool can = std::ranges::all_of(vectors, [&](const Vec3* v) { return can_scale_all(*v, exponent_); }) &&
                     std::ranges::all_of(bodies, [&](const Body& body) { return can_scale(body); });
    if (!can) exponent_ = 0;
}

bool OtherUnits::can_scale(const Body& body) const {
    const int of_mesh = scale_of(*body.shape);
    if (of_mesh != 0) {
        for (const exact::BitRange& digits : MeshShapeAccess::tree(*body.shape).extent.digits) {
            if (!digits.empty() && digits.low + of_mesh < -1022) return false;
        }
    }
    return std::ranges::all_of(body.poses, [&](const Pose* pose) {
        return can_scale_all(pose->t, exponent_) && can_scale_all(pose->R, exponent_ - of_mesh);
    });
}

Pose OtherUnits::pose_of(const MeshShape& shape, const Pose& pose) const {
    return {scaled_all(pose.R, exponent_ - scale_of(shape)), scaled_all(pose.t, exponent_)};
}

Posed<MeshShape> OtherUnits::of(const Posed<MeshShape>& body) const {
    return {own_mesh(*body.what), pose_of(*body.what, body.pose)};
}

Moving<MeshShape> OtherUnits::of(const Moving<MeshShape>& body) const {
    return {own_mesh(*body.what), pose_of(*body.what, body.from), pose_of(*body.what, body.to)};
}

Turning<MeshShape> OtherUnits::of(const Turning<MeshShape>& body) const {
    const Turn& turn = body.turn;
    return {own_mesh(*body.what), pose_of(*body.what, body.pose),
            Turn{turn.q, scaled_all(turn.pivot_from, exponent_), scaled_all(turn.pivot_to, exponent_)}};
}

Vec3 OtherUnits::of(const Vec3& motion) const noexcept {
    return scaled_all(motion, exponent_);
}

}  // namespace ecods
