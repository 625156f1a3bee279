#include "query/certificate/proof_axes.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

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

ECODS_ALWAYS_INLINE void reaches_of_node(const BodyAxis& axis, const BvhNode& node, Reaches& reaches) noexcept {
    const auto& p = axis.p;
    for (std::size_t part = 0; part < 2; ++part) {
        const Half middle = (p[0] * load_half(node.center[0], part) + p[1] * load_half(node.center[1], part)) +
                            (p[2] * load_half(node.center[2], part) + axis.q);
        const Half reach =
            (std::abs(p[0]) * load_half(node.half[0], part) + std::abs(p[1]) * load_half(node.half[1], part)) +
            std::abs(p[2]) * load_half(node.half[2], part);
        store(reaches.low.data() + 4 * part, middle - reach);
        store(reaches.high.data() + 4 * part, middle + reach);
    }
}

ECODS_ALWAYS_INLINE void reaches_of_leaf(const BodyAxis& axis, const TreeLeaf& leaf, Reaches& reaches) noexcept {
    const auto& p = axis.p;
    for (std::size_t part = 0; part < 2; ++part) {
        const auto at = [&](std::size_t c) -> Half {
            const auto& y = leaf.corner[c];
            return (p[0] * load_half(y[0], part) + p[1] * load_half(y[1], part)) +
                   (p[2] * load_half(y[2], part) + axis.q);
        };
        const Half x = at(0), y = at(1), z = at(2);
        store(reaches.low.data() + 4 * part, min(x, min(y, z)) - axis.corner_reach);
        store(reaches.high.data() + 4 * part, max(x, max(y, z)) + axis.corner_reach);
    }
}

ECODS_ALWAYS_INLINE std::uint64_t mask_of(const Reaches& a, const Reaches& b, double margin) noexcept {
    std::uint64_t mask = 0;
    for (std::size_t part = 0; part < 2; ++part) {
        const Half low = load<Half>(b.low.data() + 4 * part) - margin,
                   high = load<Half>(b.high.data() + 4 * part) + margin;
        MaskOf<Half> apart{};
        for (std::size_t i = 0; i < tree_width; ++i) apart |= ((low > a.high[i]) | (high < a.low[i])) & (1 << i);
        mask |= low_bytes(apart) << (32 * part);
    }
    // Bits 8 j + i to 8 i + j: blocks of one, two and four are exchanged (Warren, Hacker's Delight, 7-3).
    std::uint64_t t = (mask ^ (mask >> 7)) & 0x00aa00aa00aa00aa;
    mask ^= t ^ (t << 7);
    t = (mask ^ (mask >> 14)) & 0x0000cccc0000cccc;
    mask ^= t ^ (t << 14);
    t = (mask ^ (mask >> 28)) & 0x00000000f0f0f0f0;
    return mask ^ (t ^ (t << 28));
}

}  // namespace

void find_reaches(const BodyAxis& axis, const BvhNode& node, Reaches& reaches) noexcept {
    dispatch<reaches_of_node>(axis, node, reaches);
}
void find_reaches(const BodyAxis& axis, const TreeLeaf& leaf, Reaches& reaches) noexcept {
    dispatch<reaches_of_leaf>(axis, leaf, reaches);
}
std::uint64_t apart_mask(const Reaches& a, const Reaches& b, double margin) noexcept {
    return dispatch<mask_of>(a, b, margin);
}

Vec3 shortened(const Vec3& direction) {
    const double largest = direction.cwiseAbs().maxCoeff();
    if (!(largest >= 0x1p-900 && largest <= 0x1p900)) return Vec3::Zero();
    const auto biased = static_cast<std::uint64_t>(std::bit_cast<std::uint64_t>(largest) >> 52);
    const double scale = std::bit_cast<double>((1023 + 16 + 1023 - biased) << 52);
    Vec3 result;
    for (int k = 0; k < 3; ++k)
        result[k] = static_cast<double>(static_cast<std::int64_t>(direction[k] * scale)) * 0x1p-16;
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
