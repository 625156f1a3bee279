// MeshEdges groups the sides of a proper mesh's triangles into edges.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "query/solid/proper_mesh.hpp"

namespace ecods {

// A SideRef names a side of a triangle: from corner `corner` to the next corner.
struct SideRef {
    std::uint32_t triangle;
    std::uint32_t corner;

    friend constexpr auto operator<=>(const SideRef&, const SideRef&) = default;
};

// Returns the corners of the side's triangle: first the two ends of the side, then the opposite corner.
inline std::array<std::uint32_t, 3> corners_from(std::span<const Triangle> triangles, const SideRef& side) noexcept {
    const Triangle& t = triangles[side.triangle];
    return {t[side.corner], t[(side.corner + 1) % 3], t[(side.corner + 2) % 3]};
}

class MeshEdges {
  public:
    MeshEdges() = default;

    // Groups the sides of the triangles that have an area. Throws InvalidMesh if there are too many sides for 32-bit
    // indices. Cost: some passes over the triangles.
    explicit MeshEdges(const ProperMesh& proper);

    std::size_t count() const noexcept { return first_.empty() ? 0 : first_.size() - 1; }

    // Returns the sides that are edge `i`, ascending.
    std::span<const SideRef> sides(std::size_t i) const noexcept {
        return std::span(sides_).subspan(first_[i], first_[i + 1] - first_[i]);
    }

    // Returns the edge of a side. The side's triangle must have an area.
    std::uint32_t edge_of(const SideRef& side) const noexcept { return edge_of_[side.triangle][side.corner]; }

  private:
    std::vector<std::array<std::uint32_t, 3>> edge_of_;  // by triangle and corner
    std::vector<std::uint32_t> first_;  // by edge: index of its first side in sides_; then sides_.size()
    std::vector<SideRef> sides_;
};

// Throws NotSolid, with the indices of `given`, unless the triangles with an area are closed. An edge with an even
// number of sides cancels. The other edges are closed exactly if, on every line through a point, the point is an end of
// an even number of them: a union, modulo two, of finitely many segments of a line is empty if it has no ends.
void check_closed(const Mesh& given, const ProperMesh& proper, const MeshEdges& edges);

}  // namespace ecods
