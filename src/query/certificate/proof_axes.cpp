#include "query/certificate/proof_axes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/arithmetic.hpp"

namespace ecods {
namespace {

constexpr double size_max = 0x1p300;
constexpr double size_min = 0x1p-300;

}  // namespace

BodyAxis put_on_axis(const MeshBvh& tree, const Mat3& R, const Vec3& d, const Vec3& n) {
    BodyAxis axis;
    const LocalFrame& frame = tree.frame;
    if (!frame.is_bounded) return axis;
    const Vec3 along = R.transpose() * n;
    const Vec3 p = frame.map.transpose() * along;
    axis.q = n.dot(R * frame.center + d);
    const Vec3 n_size = n.cwiseAbs(), R_sums = R.cwiseAbs().rowwise().sum();
    const double w = n_size.dot(R.cwiseAbs() * frame.map_size);
    const double w_d = n_size.dot(R.cwiseAbs() * frame.center.cwiseAbs() + d.cwiseAbs());
    const double largest = (1 + R_sums.sum()) * frame.size_max + d.cwiseAbs().sum();
    for (int k = 0; k < 3; ++k) axis.p[static_cast<std::size_t>(k)] = p[k];
    axis.error = 32 * two_u * (w + w_d);
    axis.corner_reach = p.cwiseAbs().sum() * (corner_error * (1 + 0x1p-20));
    // In this form NaN is not bounded.
    axis.is_bounded = largest < size_max && w + w_d > size_min;
    return axis;
}

Reaches reaches_of(const BodyAxis& axis, const BvhNode& node) {
    Reaches reaches;
    reaches.count = node.count;
    for (std::size_t lane = 0; lane < node.count; ++lane) {
        double middle = axis.q, reach = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            middle += axis.p[k] * static_cast<double>(node.center[k][lane]);
            reach += std::abs(axis.p[k]) * static_cast<double>(node.half[k][lane]);
        }
        reaches.low[lane] = middle - reach;
        reaches.high[lane] = middle + reach;
    }
    return reaches;
}

Reaches reaches_of(const BodyAxis& axis, const TreeLeaf& leaf) {
    Reaches reaches;
    reaches.count = leaf.count;
    for (std::size_t lane = 0; lane < leaf.count; ++lane) {
        for (std::size_t c = 0; c < 3; ++c) {
            double x = axis.q;
            for (std::size_t k = 0; k < 3; ++k) x += axis.p[k] * static_cast<double>(leaf.corner[c][k][lane]);
            reaches.low[lane] = c == 0 ? x : std::min(reaches.low[lane], x);
            reaches.high[lane] = c == 0 ? x : std::max(reaches.high[lane], x);
        }
        reaches.low[lane] -= axis.corner_reach;
        reaches.high[lane] += axis.corner_reach;
    }
    return reaches;
}

Vec3 shortened(const Vec3& direction) {
    const double largest = direction.cwiseAbs().maxCoeff();
    if (!(largest >= 0x1p-900 && largest <= 0x1p900)) return Vec3::Zero();
    const auto biased = static_cast<std::uint64_t>(std::bit_cast<std::uint64_t>(largest) >> 52);
    const double scale = std::bit_cast<double>((1023 + 16 + 1023 - biased) << 52);
    Vec3 result;
    for (int k = 0; k < 3; ++k) result[k] = static_cast<double>(static_cast<std::int64_t>(direction[k] * scale)) * 0x1p-16;
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
