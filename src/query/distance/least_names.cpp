#include "query/distance/least_names.hpp"

#include <algorithm>
#include <tuple>

#include "base/assert.hpp"
#include "base/double_key.hpp"

namespace ecods {

LeastNames::LeastNames(const Mesh& mesh, std::vector<std::uint32_t> triangles) : mesh_(mesh) {
    std::ranges::sort(triangles);
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());

    vertices_.reserve(3 * triangles.size());
    edges_.reserve(3 * triangles.size());
    for (const std::uint32_t triangle : triangles) {
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            vertices_.push_back({place_of(triangle, corner), triangle, corner});
        }
    }
    std::ranges::sort(vertices_, {}, [](const Vertex& v) { return std::tuple(v.place, v.triangle, v.corner); });
    const auto is_same_place = [](const Vertex& v, const Vertex& w) { return v.place == w.place; };
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end(), is_same_place), vertices_.end());

    for (const std::uint32_t triangle : triangles) {
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            edges_.push_back({ends_of(triangle, corner), triangle, corner});
        }
    }
    std::ranges::sort(edges_, {}, [](const Edge& e) { return std::tuple(e.ends, e.triangle, e.corner); });
    const auto has_same_ends = [](const Edge& e, const Edge& f) { return e.ends == f.ends; };
    edges_.erase(std::unique(edges_.begin(), edges_.end(), has_same_ends), edges_.end());
}

Feature LeastNames::operator()(const Feature& feature) const {
    if (feature.kind == Feature::Kind::face) return feature;
    if (feature.kind == Feature::Kind::vertex) {
        const Vertex& vertex = vertices_[vertex_of(feature.triangle, feature.corner)];
        return {feature.kind, vertex.triangle, vertex.corner};
    }
    const auto edge = std::ranges::lower_bound(edges_, ends_of(feature.triangle, feature.corner), {}, &Edge::ends);
    ECODS_ASSERT(edge != edges_.end());
    return {feature.kind, edge->triangle, edge->corner};
}

LeastNames::Place LeastNames::place_of(std::uint32_t triangle, std::uint32_t corner) const {
    const Vec3& v = mesh_.vertices()[mesh_.triangles()[triangle][corner]];
    return {key_of(v[0]), key_of(v[1]), key_of(v[2])};
}

std::uint32_t LeastNames::vertex_of(std::uint32_t triangle, std::uint32_t corner) const {
    const auto vertex = std::ranges::lower_bound(vertices_, place_of(triangle, corner), {}, &Vertex::place);
    ECODS_ASSERT(vertex != vertices_.end());
    return static_cast<std::uint32_t>(vertex - vertices_.begin());
}

std::array<std::uint32_t, 2> LeastNames::ends_of(std::uint32_t triangle, std::uint32_t corner) const {
    const std::uint32_t from = vertex_of(triangle, corner), to = vertex_of(triangle, corner == 2 ? 0 : corner + 1);
    return {std::min(from, to), std::max(from, to)};
}

}  // namespace ecods
