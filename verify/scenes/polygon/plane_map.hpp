// A map of the plane is made by a closed walk: edges that meet at their ends alone, and the faces between them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scenes/polygon/cut_ears.hpp"

namespace ecods::scenes {

// Half-edges 2 i and 2 i + 1 are one edge there and back.
struct HalfEdge {
    std::uint32_t from = 0;  // a place
    std::uint32_t name = 0;  // of a corner in that place
    std::uint32_t next = 0;  // around the face to the left
    std::uint32_t face = 0;
    int winding = 0;         // how often the walk goes along it, less how often the other way
    bool is_walked = false;  // one way or the other
    bool is_outer = false;   // along the box, which is to its right
};

// A walk and the box around it, cut into half-edges wherever a corner is, and the faces around which they go. Edges
// that cross elsewhere are not looked for: they show when faces are cut into triangles.
class PlaneMap {
  public:
    // None if edges pass through so many corners that the map would be more than 16 times as large as the walk. Some
    // three corners of the walk are not on one line.
    static std::optional<PlaneMap> create(const PlaneWalk& walk);

    const std::vector<HalfEdge>& half_edges() const noexcept { return half_edges_; }
    const Vec2& point(std::uint32_t half_edge) const { return places_[half_edges_[half_edge].from]; }

    // For each face a half-edge; the first is outside of the box.
    const std::vector<std::uint32_t>& faces() const noexcept { return faces_; }

    // How often the walk goes round each face; none if there is no answer, because edges cross.
    std::optional<std::vector<int>> windings() const;

    // The walk round a face; its corners are named by their half-edges.
    PlaneWalk walk_round(std::uint32_t face) const;

  private:
    struct Edge;
    PlaneMap() = default;
    void find_places(const PlaneWalk& walk);
    bool add_split(std::uint32_t from, std::uint32_t to, Edge edge, const class PointTree& tree, std::size_t size_max,
                   std::vector<Edge>& edges) const;
    void add_half_edges(std::vector<Edge>& edges);
    void link();
    void find_faces();

    std::vector<Vec2> places_;             // ascending by x, then y; the box's corners included
    std::vector<std::uint32_t> place_of_;  // by corner of the walk
    std::vector<HalfEdge> half_edges_;
    std::vector<std::uint32_t> faces_;
};

}  // namespace ecods::scenes
