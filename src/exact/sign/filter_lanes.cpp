#include "exact/sign/filter_lanes.hpp"

#include <algorithm>

#include "simd/dispatch.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {
namespace {

// Four doubles that the compiler keeps in as many registers as the instruction set needs: half of the lanes. (Wider
// vectors are taken apart into single numbers where the registers are narrower.) Operators work lane by lane.
typedef double Vector __attribute__((vector_size(32), may_alias));
typedef std::int64_t Mask __attribute__((vector_size(32), may_alias));
constexpr std::size_t width = 4;

static_assert(lane_count == 2 * width && alignof(TriangleLanes) >= alignof(Vector) &&
              alignof(LaneTrace) >= alignof(Vector));

ECODS_ALWAYS_INLINE const Vector& load(const Lanes& lanes, std::size_t half) noexcept {
    return reinterpret_cast<const Vector&>(lanes[half * width]);
}
ECODS_ALWAYS_INLINE void store(Lanes& lanes, std::size_t half, const Vector& v) noexcept {
    reinterpret_cast<Vector&>(lanes[half * width]) = v;
}

// All ones in the lanes in which all three are above `bound`, or all three below its negative.
ECODS_ALWAYS_INLINE void find_beyond(const Vector& a, const Vector& b, const Vector& c, double bound,
                                     Mask& mask) noexcept {
    mask |= ((a > bound) & (b > bound) & (c > bound)) | ((a < -bound) & (b < -bound) & (c < -bound));
}

ECODS_ALWAYS_INLINE void pose_wide(const Mat3& R, const Vec3& d, const TriangleLanes& local,
                                   TriangleLanes& posed) noexcept {
    for (std::size_t corner = 0; corner < 3; ++corner) {
        for (std::size_t half = 0; half < 2; ++half) {
            const auto& v = local.corners[corner];
            const Vector x = load(v[0], half), y = load(v[1], half), z = load(v[2], half);
            for (int row = 0; row < 3; ++row) {
                store(posed.corners[corner][static_cast<std::size_t>(row)], half,
                      ((R(row, 0) * x + R(row, 1) * y) + R(row, 2) * z) + d[row]);
            }
        }
    }
}

ECODS_ALWAYS_INLINE std::uint32_t filter_wide(const std::array<Point, 3>& one, const TriangleLanes& eight, double bound,
                                              LaneTrace& trace) noexcept {
    const PlainNormal m = plain_normal(one[0], one[1], one[2]);
    std::uint32_t disjoint = 0;
    for (std::size_t half = 0; half < 2; ++half) {
        const auto at = [&](std::size_t corner, std::size_t k) -> const Vector& {
            return load(eight.corners[corner][k], half);
        };
        const Vector ax = at(0, 0), ay = at(0, 1), az = at(0, 2), bx = at(1, 0), by = at(1, 1), bz = at(1, 2),
                     cx = at(2, 0), cy = at(2, 1), cz = at(2, 2);
        const double ox = one[0][0], oy = one[0][1], oz = one[0][2];
        const Vector sa = (m.x * (ax - ox) + m.y * (ay - oy)) + m.z * (az - oz);
        const Vector sb = (m.x * (bx - ox) + m.y * (by - oy)) + m.z * (bz - oz);
        const Vector sc = (m.x * (cx - ox) + m.y * (cy - oy)) + m.z * (cz - oz);
        store(trace.second[0], half, sa);
        store(trace.second[1], half, sb);
        store(trace.second[2], half, sc);

        const Vector x1 = bx - ax, y1 = by - ay, z1 = bz - az, x2 = cx - ax, y2 = cy - ay, z2 = cz - az;
        const Vector nx = y1 * z2 - z1 * y2, ny = z1 * x2 - x1 * z2, nz = x1 * y2 - y1 * x2;
        const Vector ra = (nx * (one[0][0] - ax) + ny * (one[0][1] - ay)) + nz * (one[0][2] - az);
        const Vector rb = (nx * (one[1][0] - ax) + ny * (one[1][1] - ay)) + nz * (one[1][2] - az);
        const Vector rc = (nx * (one[2][0] - ax) + ny * (one[2][1] - ay)) + nz * (one[2][2] - az);
        store(trace.first[0], half, ra);
        store(trace.first[1], half, rb);
        store(trace.first[2], half, rc);

        Mask beyond{};
        find_beyond(sa, sb, sc, bound, beyond);
        find_beyond(ra, rb, rc, bound, beyond);
        beyond &= Mask{1, 2, 4, 8};
        disjoint |= static_cast<std::uint32_t>(beyond[0] | beyond[1] | beyond[2] | beyond[3]) << (half * width);
    }
    return disjoint;
}

}  // namespace

std::vector<TriangleBlock> make_blocks(const Mesh& mesh, std::span<const std::uint32_t> order) {
    std::vector<TriangleBlock> blocks;
    blocks.reserve((order.size() + lane_count - 1) / lane_count);
    for (std::size_t begin = 0; begin < order.size(); begin += lane_count) {
        TriangleBlock& block = blocks.emplace_back();
        block.count = static_cast<std::uint32_t>(std::min(lane_count, order.size() - begin));
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            block.indices[lane] = order[begin + std::min<std::size_t>(lane, block.count - 1)];
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const Vec3& v = mesh.vertices()[mesh.triangles()[block.indices[lane]][corner]];
                for (std::size_t k = 0; k < 3; ++k) {
                    block.local.corners[corner][k][lane] = v[static_cast<Eigen::Index>(k)];
                }
            }
        }
    }
    return blocks;
}

void pose_lanes(const Mat3& R, const Vec3& d, const TriangleLanes& local, TriangleLanes& posed) noexcept {
    dispatch<pose_wide>(R, d, local, posed);
}

void divide_lanes(const Vec3& unit, TriangleLanes& posed) noexcept {
    for (auto& corner : posed.corners) {
        for (std::size_t k = 0; k < 3; ++k) {
            for (double& x : corner[k]) x /= unit[static_cast<Eigen::Index>(k)];
        }
    }
}

std::uint32_t filter_planes(const std::array<Point, 3>& one, const TriangleLanes& eight, double bound,
                            LaneTrace& trace) noexcept {
    return dispatch<filter_wide>(one, eight, bound, trace);
}

}  // namespace ecods::exact
