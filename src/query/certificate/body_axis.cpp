#include "query/certificate/body_axis.hpp"

#include <bit>

#include "base/arithmetic.hpp"
#include "query/shape/mesh_body.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

constexpr double size_max = 0x1p300;
constexpr double size_min = 0x1p-300;

}  // namespace

BodyFrame::BodyFrame(const Posed<MeshShape>& body, const Vec3& base)
    : ref(MeshBody(body).ref()), tree(MeshBody(body).tree.boxes), offset(body.pose.t - base) {
    const LocalFrame& frame = tree.frame;
    const Mat3 &R = body.pose.R, R_size = R.cwiseAbs();
    edges = R * frame.map;
    origin = R * frame.center + offset;
    size = R_size * frame.map_size;
    origin_size = R_size * frame.center.cwiseAbs() + offset.cwiseAbs();
    // The comparison is false for NaN, so NaN counts as unbounded.
    is_bounded = frame.is_bounded && (1 + R_size.sum()) * frame.size_max + offset.cwiseAbs().sum() < size_max;
}

Mat3 BodyFrame::normals() const {
    const Mat3 sides = ref.pose->R * tree.frame.axes;
    const Vec3 x = sides.col(0), y = sides.col(1), z = sides.col(2);
    const double det = x.dot(y.cross(z));
    if (!(det * det > 0x1p-40 * (x.dot(x) * y.dot(y) * z.dot(z)))) return Mat3::Identity();
    Mat3 normals;
    normals << y.cross(z), z.cross(x), x.cross(y);
    return normals;
}

BodyAxis put_on_axis(const BodyFrame& body, const Vec3& n) {
    BodyAxis axis;
    const Vec3 p = body.edges.transpose() * n, n_size = n.cwiseAbs();
    const double w = n_size.dot(body.size) + n_size.dot(body.origin_size);
    for (int k = 0; k < 3; ++k) axis.p[static_cast<std::size_t>(k)] = p[k];
    axis.q = n.dot(body.origin);
    axis.error = 32 * two_u * w;
    axis.corner_reach = p.cwiseAbs().sum() * (corner_error * (1 + 0x1p-20));
    axis.is_bounded = body.is_bounded && w > size_min;
    return axis;
}

template <class X>
void find_reaches(const BodyAxis& axis, const X& x, Reaches<double>& reaches) noexcept {
    dispatch<InDoubles::find_reaches<X>>(axis, 0.0, x, reaches);
}
template void find_reaches(const BodyAxis&, const BvhNode&, Reaches<double>&) noexcept;
template void find_reaches(const BodyAxis&, const TreeLeaf&, Reaches<double>&) noexcept;

Vec3 shortened(const Vec3& direction, int bits) {
    const double largest = direction.cwiseAbs().maxCoeff();
    if (!(largest >= 0x1p-900 && largest <= 0x1p900)) return Vec3::Zero();
    const auto biased = static_cast<std::uint64_t>(std::bit_cast<std::uint64_t>(largest) >> 52);
    const auto digits = static_cast<std::uint64_t>(bits);
    const double scale = std::bit_cast<double>((1023 + digits + 1023 - biased) << 52),
                 unit = std::bit_cast<double>((1023 - digits) << 52);
    Vec3 result;
    for (int k = 0; k < 3; ++k) result[k] = static_cast<double>(static_cast<std::int64_t>(direction[k] * scale)) * unit;
    return result;
}

}  // namespace ecods
