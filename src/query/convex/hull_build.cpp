#include "query/convex/hull_build.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/assert.hpp"

namespace ecods::convex {
namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

// A Piece is an edge of the convex set, or a triangle's side that is a part of such an edge. It runs between two
// vertices of the mesh, with one face on its left and one on its right, seen from outside.
struct Piece {
    SideRef name;
    std::uint32_t from, to;
    std::uint32_t left, right;

    std::array<std::uint32_t, 2> between() const noexcept { return {std::min(left, right), std::max(left, right)}; }
};

class Builder {
  public:
    Builder(const Border& border, std::span<const std::uint8_t> is_flat)
        : border_(border),
          triangles_(border.proper->mesh->triangles()),
          points_(border.proper->mesh->vertices()),
          is_flat_(is_flat) {}

    Hull build() {
        join_faces();
        find_pieces();
        join_pieces();
        name_vertices();
        add_edges();
        add_cycles();
        add_neighbors(hull_);
        return std::move(hull_);
    }

  private:
    std::uint32_t root(std::uint32_t i) {
        while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
        return i;
    }

    // Joins triangles that meet in flat edges into faces, by union-find. The root is the least triangle of the face, so
    // faces are found in the order of their names.
    void join_faces() {
        parents_.resize(triangles_.size());
        std::iota(parents_.begin(), parents_.end(), 0);
        for (std::size_t e = 0; e < is_flat_.size(); ++e) {
            if (!is_flat_[e]) continue;
            const auto sides = border_.edges->sides(e);
            const std::uint32_t a = root(sides[0].triangle), b = root(sides[1].triangle);
            parents_[std::max(a, b)] = std::min(a, b);
        }
        face_of_.assign(triangles_.size(), none);
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            if (!border_.proper->is_proper(i)) continue;
            const std::uint32_t first = root(i);
            if (first == i) {
                face_of_[i] = static_cast<std::uint32_t>(hull_.faces.size());
                hull_.faces.push_back({{Feature::Kind::face, border_.origin({i, 0}).triangle, 0}, 0, 0});
            } else {
                face_of_[i] = face_of_[first];
            }
        }
    }

    void find_pieces() {
        for (std::size_t e = 0; e < is_flat_.size(); ++e) {
            if (is_flat_[e]) continue;
            const SideRef &side = border_.edges->sides(e)[0], &other = border_.edges->sides(e)[1];
            Piece piece;
            piece.name = std::min(border_.origin(side), border_.origin(other));
            piece.from = triangles_[side.triangle][side.corner];
            piece.to = triangles_[side.triangle][(side.corner + 1) % 3];
            piece.left = face_of_[side.triangle];
            piece.right = face_of_[other.triangle];
            if (border_.turns_right(side.triangle)) std::swap(piece.left, piece.right);
            pieces_.push_back(piece);
        }
    }

    // Joins all pieces between the same two faces into one edge, because two faces of a convex set share at most one
    // edge. compare_points() finds the ends of this edge: it orders the points of a line along the line.
    void join_pieces() {
        std::ranges::sort(pieces_, {}, [](const Piece& p) { return std::tuple(p.between(), p.name); });
        for (std::size_t i = 0; i < pieces_.size();) {
            Piece edge = pieces_[i];
            if (compare_points(points_[edge.from], points_[edge.to]) > 0) {
                std::swap(edge.from, edge.to);
                std::swap(edge.left, edge.right);
            }
            std::size_t k = i + 1;
            for (; k < pieces_.size() && pieces_[k].between() == pieces_[i].between(); ++k) {
                for (const std::uint32_t end : {pieces_[k].from, pieces_[k].to}) {
                    if (compare_points(points_[end], points_[edge.from]) < 0) edge.from = end;
                    if (compare_points(points_[end], points_[edge.to]) > 0) edge.to = end;
                }
            }
            edges_.push_back(edge);
            i = k;
        }
        std::ranges::sort(edges_, {}, &Piece::name);
    }

    // Names each vertex by its least triangle and corner. A vertex of the set is never inside a side, so each triangle
    // that contains the vertex has it as a corner.
    void name_vertices() {
        vertex_of_.assign(points_.size(), none);
        constexpr std::uint32_t unnamed = none - 1;
        for (const Piece& edge : edges_) vertex_of_[edge.from] = vertex_of_[edge.to] = unnamed;
        const auto named = border_.named->mesh->triangles();
        for (std::uint32_t i = 0; i < named.size(); ++i) {
            if (!border_.named->is_proper(i)) continue;
            for (std::uint32_t corner = 0; corner < 3; ++corner) {
                const std::uint32_t v = named[i][corner];
                if (vertex_of_[v] != unnamed) continue;
                vertex_of_[v] = static_cast<std::uint32_t>(hull_.mesh_vertices.size());
                hull_.mesh_vertices.push_back(v);
                hull_.vertex_names.push_back({Feature::Kind::vertex, i, corner});
            }
        }
    }

    void add_edges() {
        hull_.edges.reserve(edges_.size());
        for (const Piece& edge : edges_) {
            const Feature name{Feature::Kind::edge, edge.name.triangle, edge.name.corner};
            const std::uint32_t from = vertex_of_[edge.from], to = vertex_of_[edge.to];
            if (from < to) {
                hull_.edges.push_back({name, {from, to}, {edge.left, edge.right}});
            } else {
                hull_.edges.push_back({name, {to, from}, {edge.right, edge.left}});
            }
        }
    }

    // Walks around each face, beginning at its least vertex, with the face on the left of every edge.
    void add_cycles() {
        std::uint32_t first = 0;
        for (const Hull::Edge& edge : hull_.edges) {
            for (const std::uint32_t face : edge.faces) ++hull_.faces[face].count;
        }
        for (Hull::Face& face : hull_.faces) {
            face.first = first;
            first += face.count;
        }
        // edges_of lists the edges of each face, in any order. leaves[v] is the edge of the current face that begins at
        // vertex v.
        std::vector<std::uint32_t> edges_of(first), filled(hull_.faces.size(), 0), leaves(hull_.vertex_count(), none);
        for (std::uint32_t e = 0; e < hull_.edges.size(); ++e) {
            for (const std::uint32_t face : hull_.edges[e].faces)
                edges_of[hull_.faces[face].first + filled[face]++] = e;
        }
        hull_.face_cycles.reserve(first);
        for (std::uint32_t i = 0; i < hull_.faces.size(); ++i) {
            const Hull::Face& face = hull_.faces[i];
            std::uint32_t start = none;
            for (std::uint32_t k = face.first; k < face.first + face.count; ++k) {
                const Hull::Edge& edge = hull_.edges[edges_of[k]];
                const std::uint32_t from = edge.ends[edge.faces[0] == i ? 0 : 1];
                leaves[from] = edges_of[k];
                start = std::min(start, from);
            }
            std::uint32_t at = start;
            for (std::uint32_t k = 0; k < face.count; ++k) {
                const Hull::Edge& edge = hull_.edges[leaves[at]];
                hull_.face_cycles.push_back({at, leaves[at]});
                at = edge.ends[edge.faces[0] == i ? 1 : 0];
            }
            ECODS_ASSERT(at == start);
        }
    }

    const Border& border_;
    std::span<const Triangle> triangles_;
    std::span<const Vec3> points_;
    std::span<const std::uint8_t> is_flat_;
    std::vector<std::uint32_t> parents_;  // by triangle: union-find parent
    std::vector<std::uint32_t> face_of_;  // by triangle
    std::vector<Piece> pieces_;
    std::vector<Piece> edges_;
    std::vector<std::uint32_t> vertex_of_;  // by vertex of the mesh
    Hull hull_;
};

}  // namespace

int side_of_plane(const Border& border, std::uint32_t triangle, std::uint32_t vertex) noexcept {
    const auto& [a, b, c] = border.proper->mesh->triangles()[triangle];
    const int sign = border.signs.orient3d(a, b, c, vertex);
    return border.turns_right(triangle) ? -sign : sign;
}

void add_neighbors(Hull& hull) {
    std::vector<std::uint32_t>& first = hull.neighbors_first;
    first.assign(hull.vertex_count() + 1, 0);
    for (const Hull::Edge& edge : hull.edges) {
        for (const std::uint32_t end : edge.ends) ++first[end + 1];
    }
    for (std::size_t v = 0; v + 1 < first.size(); ++v) first[v + 1] += first[v];
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    hull.neighbors.resize(2 * hull.edges.size());
    for (std::uint32_t e = 0; e < hull.edges.size(); ++e) {
        const auto& [a, b] = hull.edges[e].ends;
        hull.neighbors[next[a]++] = {b, e};
        hull.neighbors[next[b]++] = {a, e};
    }
}

Hull build_hull(const Border& border, std::span<const std::uint8_t> is_flat) {
    return Builder(border, is_flat).build();
}

}  // namespace ecods::convex
