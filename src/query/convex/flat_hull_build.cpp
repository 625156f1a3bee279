#include <algorithm>
#include <tuple>
#include <utility>

#include "query/convex/hull_build.hpp"

namespace ecods::convex {
namespace {

constexpr std::uint32_t no_vertex = ~std::uint32_t{0};

std::tuple<std::uint32_t, std::uint32_t> name_of_edge(const Hull::Edge& edge) noexcept {
    return {edge.name.triangle, edge.name.corner};
}

class FlatBuilder {
  public:
    FlatBuilder(const ProperMesh& proper, const FlatMesh& flat) : proper_(proper), flat_(flat) {}

    Hull build() {
        name_vertices();
        add_edges();
        if (flat_.is_polygon()) add_face();
        add_neighbors(hull_);
        return std::move(hull_);
    }

  private:
    std::uint32_t next_of(std::size_t k) const noexcept { return flat_.cycle[(k + 1) % flat_.cycle.size()]; }

    void name_vertices() {
        const auto triangles = proper_.mesh->triangles();
        vertex_of_.assign(proper_.mesh->vertices().size(), no_vertex);
        constexpr std::uint32_t unnamed = no_vertex - 1;
        for (const std::uint32_t v : flat_.cycle) vertex_of_[v] = unnamed;
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            if (flat_.is_polygon() && !proper_.is_proper(i)) continue;
            for (std::uint32_t corner = 0; corner < 3; ++corner) {
                std::uint32_t& vertex = vertex_of_[triangles[i][corner]];
                if (vertex != unnamed) continue;
                vertex = static_cast<std::uint32_t>(hull_.mesh_vertices.size());
                hull_.mesh_vertices.push_back(triangles[i][corner]);
                hull_.vertex_names.push_back({Feature::Kind::vertex, i, corner});
            }
        }
    }

    void add_edges() {
        const std::uint32_t face = flat_.is_polygon() ? 0 : Hull::no_face;
        for (std::size_t k = 0; k < flat_.sides.size(); ++k) {
            const auto [low, high] = std::minmax(vertex_of_[flat_.cycle[k]], vertex_of_[next_of(k)]);
            const SideRef& side = flat_.sides[k];
            hull_.edges.push_back({{Feature::Kind::edge, side.triangle, side.corner}, {low, high}, {face, face}});
        }
        std::ranges::sort(hull_.edges, {}, &name_of_edge);
    }

    // Adds the polygon's only face: walks around the polygon in the sense of its triangle `face`, from the least
    // vertex.
    void add_face() {
        const auto by_name = [](const SideRef& side) { return std::tuple(side.triangle, side.corner); };
        for (std::size_t k = 0; k < flat_.cycle.size(); ++k) {
            const auto edge = std::ranges::lower_bound(hull_.edges, by_name(flat_.sides[k]), {}, &name_of_edge);
            hull_.face_cycles.push_back(
                {vertex_of_[flat_.cycle[k]], static_cast<std::uint32_t>(edge - hull_.edges.begin())});
        }
        std::ranges::rotate(hull_.face_cycles,
                            std::ranges::min_element(hull_.face_cycles, {}, &Hull::Neighbor::vertex));
        const auto count = static_cast<std::uint32_t>(hull_.face_cycles.size());
        hull_.faces.push_back({{Feature::Kind::face, flat_.face, 0}, 0, count});
    }

    const ProperMesh& proper_;
    const FlatMesh& flat_;
    std::vector<std::uint32_t> vertex_of_;  // by vertex of the mesh: its vertex of the hull
    Hull hull_;
};

}  // namespace

Hull build_flat_hull(const ProperMesh& proper, const FlatMesh& flat) {
    return FlatBuilder(proper, flat).build();
}

}  // namespace ecods::convex
