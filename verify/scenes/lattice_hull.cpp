#include "scenes/lattice_hull.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "scenes/hard_pair_parts.hpp"

namespace ecods::scenes {
namespace {

using hard::integer;
using Int3 = hard::Int3;

// Differences are below 2^18, so that products of two are below 2^37 and volumes below 2^57.
Int3 wide(const LatticePoint& p) {
    return {p[0], p[1], p[2]};
}

bool is_zero(const Int3& v) {
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

// A plane that has all points on one side, and those that lie in it, ascending.
struct FacePlane {
    Int3 normal;  // outwards
    std::vector<std::uint32_t> points;
};

// The plane through three points, if it is one of the hull, and these are the first three of it that are not in a row:
// so that each plane is found once.
std::optional<FacePlane> face_plane(std::span<const LatticePoint> points, std::uint32_t i, std::uint32_t j,
                                    std::uint32_t k) {
    const Int3 origin = wide(points[i]);
    const Int3 along = hard::minus(wide(points[j]), origin);
    Int3 normal = hard::cross(along, hard::minus(wide(points[k]), origin));
    if (is_zero(normal)) return std::nullopt;
    FacePlane plane;
    int side = 0;
    for (std::uint32_t p = 0; p < points.size(); ++p) {
        const Int3 to = hard::minus(wide(points[p]), origin);
        const std::int64_t height = hard::dot(normal, to);
        if (height == 0) {
            if (p < i || (p > i && p < j)) return std::nullopt;
            if (p > j && p < k && !is_zero(hard::cross(along, to))) return std::nullopt;
            plane.points.push_back(p);
            continue;
        }
        const int own = height > 0 ? 1 : -1;
        if (side == -own) return std::nullopt;
        side = own;
    }
    if (side > 0) {
        for (auto& x : normal) x = -x;
    }
    plane.normal = normal;
    return side == 0 ? std::nullopt : std::optional(plane);
}

// The corners of the polygon counterclockwise seen from outside, by gift wrapping in the plane of two coordinates.
std::vector<std::uint32_t> corners_of(const FacePlane& plane, std::span<const LatticePoint> points) {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        if (std::abs(plane.normal[k]) > std::abs(plane.normal[axis])) axis = k;
    }
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const std::int64_t turn = plane.normal[axis] > 0 ? 1 : -1;
    const auto start = *std::ranges::min_element(plane.points, {}, [&](std::uint32_t p) { return points[p]; });
    std::vector<std::uint32_t> corners{start};
    while (true) {
        const LatticePoint& from = points[corners.back()];
        std::optional<std::uint32_t> best;
        for (const std::uint32_t p : plane.points) {
            if (points[p] == from) continue;
            if (!best) best = p;
            const std::int64_t bu = points[*best][u] - from[u], bv = points[*best][v] - from[v];
            const std::int64_t pu = points[p][u] - from[u], pv = points[p][v] - from[v];
            const std::int64_t side = turn * (bu * pv - bv * pu);
            if (side < 0 || (side == 0 && pu * pu + pv * pv > bu * bu + bv * bv)) best = p;
        }
        if (points[*best] == points[start]) return corners;
        corners.push_back(*best);
    }
}

}  // namespace

LatticeMesh lattice_hull(std::span<const LatticePoint> given) {
    std::vector<LatticePoint> points(given.begin(), given.end());
    std::ranges::sort(points);
    points.erase(std::ranges::unique(points).begin(), points.end());
    LatticeMesh mesh;
    std::map<std::uint32_t, std::uint32_t> vertices;
    const auto vertex = [&](std::uint32_t p) {
        const auto [at, is_new] = vertices.try_emplace(p, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (is_new) mesh.vertices.push_back(points[p]);
        return at->second;
    };
    const auto count = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        for (std::uint32_t j = i + 1; j < count; ++j) {
            for (std::uint32_t k = j + 1; k < count; ++k) {
                const auto plane = face_plane(points, i, j, k);
                if (!plane) continue;
                const auto corners = corners_of(*plane, points);
                for (std::size_t c = 2; c < corners.size(); ++c) {
                    mesh.triangles.push_back({vertex(corners[0]), vertex(corners[c - 1]), vertex(corners[c])});
                }
            }
        }
    }
    return mesh;
}

LatticeMesh refined(const LatticeMesh& mesh) {
    LatticeMesh fine;
    for (const LatticePoint& p : mesh.vertices) fine.vertices.push_back({2 * p[0], 2 * p[1], 2 * p[2]});
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t p, std::uint32_t q) {
        const auto [at, is_new] = middles.try_emplace(std::minmax(p, q), fine.vertices.size());
        if (is_new) {
            const LatticePoint &a = mesh.vertices[p], &b = mesh.vertices[q];
            fine.vertices.push_back({a[0] + b[0], a[1] + b[1], a[2] + b[2]});
        }
        return at->second;
    };
    for (const Triangle& t : mesh.triangles) {
        const std::uint32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
        for (const Triangle& part : {Triangle{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}}) {
            fine.triangles.push_back(part);
        }
    }
    return fine;
}

LatticeMesh random_lattice_hull(int size, int point_count, Random& random) {
    while (true) {
        std::vector<LatticePoint> points(static_cast<std::size_t>(point_count));
        for (LatticePoint& p : points) {
            for (int& x : p) x = integer(random, -size, size);
        }
        LatticeMesh mesh = lattice_hull(points);
        if (!mesh.triangles.empty()) return mesh;
    }
}

LatticeMesh ellipsoid_hull(int point_count, const Vec3& radii, Random& random) {
    while (true) {
        std::vector<LatticePoint> points(static_cast<std::size_t>(point_count));
        for (LatticePoint& p : points) {
            const Vec3 at = random.direction().cwiseProduct(radii) / ellipsoid_unit;
            for (std::size_t k = 0; k < 3; ++k) p[k] = static_cast<int>(std::round(at[static_cast<int>(k)]));
        }
        LatticeMesh mesh = lattice_hull(points);
        if (!mesh.triangles.empty()) return mesh;
    }
}

LatticeMesh prism(int side_count, int radius, int height) {
    std::vector<LatticePoint> points;
    const double step = 6.283185307179586 / side_count;
    for (int i = 0; i < side_count; ++i) {
        const int x = static_cast<int>(std::round(radius * std::cos(step * i)));
        const int y = static_cast<int>(std::round(radius * std::sin(step * i)));
        points.push_back({x, y, 0});
        points.push_back({x, y, height});
    }
    return lattice_hull(points);
}

std::shared_ptr<const Mesh> to_mesh(const LatticeMesh& mesh, double unit) {
    std::vector<Vec3> vertices;
    for (const LatticePoint& p : mesh.vertices) vertices.push_back(Vec3(p[0], p[1], p[2]) * unit);
    return Mesh::create(std::move(vertices), mesh.triangles);
}

}  // namespace ecods::scenes
