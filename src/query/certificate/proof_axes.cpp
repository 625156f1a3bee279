#include "query/certificate/proof_axes.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "base/arithmetic.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

namespace ecods {
namespace {

constexpr double size_max = 0x1p300;
constexpr double size_min = 0x1p-300;

}  // namespace

BodyFrame::BodyFrame(const MeshBvh& tree, const Mat3& R, const Vec3& d) {
    const LocalFrame& frame = tree.frame;
    const Mat3 R_size = R.cwiseAbs();
    edges = R * frame.map;
    origin = R * frame.center + d;
    size = R_size * frame.map_size;
    origin_size = R_size * frame.center.cwiseAbs() + d.cwiseAbs();
    // In this form NaN is not bounded.
    is_bounded = frame.is_bounded && (1 + R_size.sum()) * frame.size_max + d.cwiseAbs().sum() < size_max;
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

namespace {

using Half = Vec<double, 4>;

ECODS_ALWAYS_INLINE Half load_half(const FloatLanes& lanes, std::size_t part) noexcept {
    return convert<Half>(load<Vec<float, 4>>(lanes.data() + 4 * part));
}

ECODS_ALWAYS_INLINE void find_ends(const BodyAxis& axis, const BvhNode& node, std::size_t part, Half& low,
                                   Half& high) noexcept {
    const auto& p = axis.p;
    const Half middle = (p[0] * load_half(node.center[0], part) + p[1] * load_half(node.center[1], part)) +
                        (p[2] * load_half(node.center[2], part) + axis.q);
    const Half reach =
        (std::abs(p[0]) * load_half(node.half[0], part) + std::abs(p[1]) * load_half(node.half[1], part)) +
        std::abs(p[2]) * load_half(node.half[2], part);
    low = middle - reach;
    high = middle + reach;
}

// A function, not a lambda: compilers may leave a lambda as a call, which passes registers of another width than a
// target region has.
template <class Corner>
ECODS_ALWAYS_INLINE Half corner_on(const BodyAxis& axis, const Corner& y, std::size_t part) noexcept {
    const auto& p = axis.p;
    return (p[0] * load_half(y[0], part) + p[1] * load_half(y[1], part)) + (p[2] * load_half(y[2], part) + axis.q);
}
ECODS_ALWAYS_INLINE void find_ends(const BodyAxis& axis, const TreeLeaf& leaf, std::size_t part, Half& low,
                                   Half& high) noexcept {
    const Half x = corner_on(axis, leaf.corner[0], part), y = corner_on(axis, leaf.corner[1], part),
               z = corner_on(axis, leaf.corner[2], part);
    low = min(x, min(y, z)) - axis.corner_reach;
    high = max(x, max(y, z)) + axis.corner_reach;
}

template <class X>
ECODS_ALWAYS_INLINE void reaches_of(const BodyAxis& axis, const X& x, Reaches& reaches) noexcept {
    for (std::size_t part = 0; part < 2; ++part) {
        Half low, high;
        find_ends(axis, x, part, low, high);
        store(reaches.low.data() + 4 * part, low);
        store(reaches.high.data() + 4 * part, high);
    }
}

template <class X, class Y>
ECODS_ALWAYS_INLINE std::uint64_t mask_of(const BodyAxis& a, const BodyAxis& b, double margin, const X& x, const Y& y,
                                          std::uint32_t columns) noexcept {
    constexpr bool is_mixed = !std::is_same_v<X, Y>;
    Reaches of_x, of_y;
    reaches_of(a, x, of_x);
    reaches_of(b, y, of_y);
    if constexpr (is_mixed && std::is_same_v<X, TreeLeaf>) join_lanes(of_x);
    if constexpr (is_mixed && std::is_same_v<Y, TreeLeaf>) join_lanes(of_y);
    MaskOf<Half> apart[2]{};
    Half low[2], high[2];
    for (std::size_t part = 0; part < 2; ++part) {
        low[part] = load<Half>(of_x.low.data() + 4 * part) - margin;
        high[part] = load<Half>(of_x.high.data() + 4 * part) + margin;
    }
    for (; columns != 0; columns &= columns - 1) {
        const auto j = static_cast<std::size_t>(std::countr_zero(columns));
        for (std::size_t part = 0; part < 2; ++part)
            apart[part] |= ((low[part] > of_y.high[j]) | (high[part] < of_y.low[j])) & (1 << j);
    }
    return low_bytes(apart[0]) | low_bytes(apart[1]) << 32;
}

}  // namespace

void find_reaches(const BodyAxis& axis, const BvhNode& node, Reaches& reaches) noexcept {
    dispatch<reaches_of<BvhNode>>(axis, node, reaches);
}
void find_reaches(const BodyAxis& axis, const TreeLeaf& leaf, Reaches& reaches) noexcept {
    dispatch<reaches_of<TreeLeaf>>(axis, leaf, reaches);
}
std::uint64_t apart_mask(const BodyAxis& a, const BodyAxis& b, double margin, const BvhNode& x, const BvhNode& y,
                         std::uint32_t columns) noexcept {
    return dispatch<mask_of<BvhNode, BvhNode>>(a, b, margin, x, y, columns);
}
std::uint64_t apart_mask(const BodyAxis& a, const BodyAxis& b, double margin, const BvhNode& x, const TreeLeaf& y,
                         std::uint32_t columns) noexcept {
    return dispatch<mask_of<BvhNode, TreeLeaf>>(a, b, margin, x, y, columns);
}
std::uint64_t apart_mask(const BodyAxis& a, const BodyAxis& b, double margin, const TreeLeaf& x, const BvhNode& y,
                         std::uint32_t columns) noexcept {
    return dispatch<mask_of<TreeLeaf, BvhNode>>(a, b, margin, x, y, columns);
}
std::uint64_t apart_mask(const BodyAxis& a, const BodyAxis& b, double margin, const TreeLeaf& x, const TreeLeaf& y,
                         std::uint32_t columns) noexcept {
    return dispatch<mask_of<TreeLeaf, TreeLeaf>>(a, b, margin, x, y, columns);
}

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

Mat3 box_normals(const LocalFrame& frame, const Mat3& R) {
    const Mat3 edges = R * frame.axes;
    const Vec3 x = edges.col(0), y = edges.col(1), z = edges.col(2);
    const double det = x.dot(y.cross(z));
    if (!(det * det > 0x1p-40 * (x.dot(x) * y.dot(y) * z.dot(z)))) return Mat3::Identity();
    Mat3 normals;
    normals << y.cross(z), z.cross(x), x.cross(y);
    return normals;
}

}  // namespace ecods
