// Groups the sides of a proper mesh's triangles into edges.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "query/solid/proper_mesh.hpp"

namespace ecods {

// A side of a triangle, from corner `corner` to the next one.
struct SideRef {
    std::uint32_t triangle;
    std::uint32_t corner;

    friend constexpr auto operator<=>(const SideRef&, const SideRef&) = default;
};

// The corners of the side's triangle: first the two ends of the side, then the opposite corner.
inline std::array<std::uint32_t, 3> corners_from(std::span<const Triangle> triangles, const SideRef& side) noexcept {
    const Triangle& t = triangles[side.triangle];
    return {t[side.corner], t[(side.corner + 1) % 3], t[(side.corner + 2) % 3]};
}

class MeshEdges {
  public:
    MeshEdges() = default;

    // Throws InvalidMesh where sides could not be counted in 32 bits. Cost: some passes over the triangles.
    explicit MeshEdges(const ProperMesh& proper);

    std::size_t count() const noexcept { return first_.empty() ? 0 : first_.size() - 1; }

    // The sides that make up edge `i`, ascending.
    std::span<const SideRef> sides(std::size_t i) const noexcept {
        return std::span(sides_).subspan(first_[i], first_[i + 1] - first_[i]);
    }

    // The edge that a side belongs to. The side's triangle has an area.
    std::uint32_t edge_of(const SideRef& side) const noexcept { return edge_of_[side.triangle][side.corner]; }

  private:
    std::vector<std::array<std::uint32_t, 3>> edge_of_;  // by triangle and corner
    std::vector<std::uint32_t> first_;  // by edge: the index of its first side; then the number of all sides
    std::vector<SideRef> sides_;
};

// Throws NotSolid, with the indices of `given`, unless the triangles with area are closed. Edges that an even number
// of sides are cancel. The others are closed exactly when every point is, on every line through it, the end of an even
// number of them: on a line, a union of finitely many segments modulo two without ends is empty.
void check_closed(const Mesh& given, const ProperMesh& proper, const MeshEdges& edges);

}  // namespace ecods
