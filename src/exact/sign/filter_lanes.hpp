// The filter for one triangle against eight at once.
//
// Lane by lane the operations are those of filter.hpp, in the same order, so the answers are, too. The loop over lanes
// is left to the compiler, for each instruction set (base/dispatch.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ecods/mesh.hpp"
#include "exact/sign/filter.hpp"

namespace ecods::exact {

inline constexpr std::size_t lane_count = 8;
using Lanes = std::array<double, lane_count>;

// Eight triangles: coordinates by corner and axis.
struct alignas(64) TriangleLanes {
    std::array<std::array<Lanes, 3>, 3> corners;

    Point at(std::size_t lane, std::size_t corner) const noexcept {
        return {corners[corner][0][lane], corners[corner][1][lane], corners[corner][2][lane]};
    }
};

// Eight triangles of a mesh, next to each other for the processor. The narrow phase makes a mesh's blocks once.
struct TriangleBlock {
    TriangleLanes local;                            // as modelled; lanes that are left over repeat the last triangle
    std::array<std::uint32_t, lane_count> indices;  // in the mesh
    std::uint32_t count;                            // lanes in use, from the first on
};

// The blocks of triangles order[0] to order[7], order[8] to order[15], and so on.
std::vector<TriangleBlock> make_blocks(const Mesh& mesh, std::span<const std::uint32_t> order);

// pose_point for every corner.
void pose_lanes(const Mat3& R, const Vec3& d, const TriangleLanes& local, TriangleLanes& posed) noexcept;

// Every coordinate, divided by the axis' unit.
void divide_lanes(const Vec3& unit, TriangleLanes& posed) noexcept;

// The values of the planes' determinants, by lane; see FilterTrace.
struct alignas(64) LaneTrace {
    std::array<Lanes, 3> first;   // corners of the one triangle against the planes of the eight
    std::array<Lanes, 3> second;  // corners of the eight against the plane of the one

    FilterTrace at(std::size_t lane) const noexcept {
        return {{first[0][lane], first[1][lane], first[2][lane]}, {second[0][lane], second[1][lane], second[2][lane]}};
    }
};

// Fills in the trace, and returns the lanes that are certainly disjoint for all corners of one triangle are on one side
// of the plane of the other, as a bit mask.
std::uint32_t filter_planes(const std::array<Point, 3>& one, const TriangleLanes& eight, double bound,
                            LaneTrace& trace) noexcept;

}  // namespace ecods::exact
