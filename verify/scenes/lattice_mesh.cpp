#include "scenes/lattice_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include "scenes/hard_pair_parts.hpp"

namespace ecods::scenes {
namespace {

using hard::coin;
using hard::full;
using hard::integer;

template <class T>
void shuffle_list(std::vector<T>& list, Random& random) {
    for (std::size_t i = list.size(); i > 1; --i) {
        std::swap(list[i - 1], list[random.below(static_cast<std::uint32_t>(i))]);
    }
}

bool is_mapped_exactly(const LatticePoint& p) {
    return std::ranges::all_of(p, [](int x) { return std::abs(x) <= lattice_max; });
}

// Unit faces that look the same way, in one plane across `axis`, by their least corners in the plane.
using Faces = std::set<std::array<int, 2>>;

// The greatest rectangle from there on, or one that ends before at random.
std::array<int, 2> rectangle_at(const Faces& faces, const std::array<int, 2>& least, Random& random) {
    std::array<int, 2> size{1, 1};
    while (random.below(4) != 0 && faces.contains({least[0] + size[0], least[1]})) ++size[0];
    const auto has_row = [&] {
        for (int i = 0; i < size[0]; ++i) {
            if (!faces.contains({least[0] + i, least[1] + size[1]})) return false;
        }
        return true;
    };
    while (random.below(4) != 0 && has_row()) ++size[1];
    return size;
}

void add_rectangle(LatticeMesh& mesh, std::size_t axis, int level, const std::array<int, 2>& least,
                   const std::array<int, 2>& size, Random& random) {
    const auto at = [&](int i, int j) {
        LatticePoint p{};
        p[axis] = level;
        p[(axis + 1) % 3] = least[0] + i;
        p[(axis + 2) % 3] = least[1] + j;
        return p;
    };
    const LatticePoint p = at(0, 0), q = at(size[0], 0), r = at(size[0], size[1]), s = at(0, size[1]);
    if (size[0] > 1 && size[1] > 1 && coin(random)) {  // around a point inside
        const LatticePoint m = at(integer(random, 1, size[0] - 1), integer(random, 1, size[1] - 1));
        mesh.add(p, q, m), mesh.add(q, r, m), mesh.add(r, s, m), mesh.add(s, p, m);
    } else if (coin(random)) {
        mesh.add(p, q, r), mesh.add(p, r, s);
    } else {
        mesh.add(p, q, s), mesh.add(q, r, s);
    }
}

}  // namespace

std::uint32_t LatticeMesh::add(const LatticePoint& vertex) {
    const auto at = std::ranges::find(vertices, vertex);
    if (at != vertices.end()) return static_cast<std::uint32_t>(at - vertices.begin());
    vertices.push_back(vertex);
    return static_cast<std::uint32_t>(vertices.size() - 1);
}

void LatticeMesh::add(const LatticePoint& p, const LatticePoint& q, const LatticePoint& r) {
    const std::uint32_t i = add(p), j = add(q), k = add(r);
    triangles.push_back({i, j, k});
}

void LatticeMesh::add(const LatticeMesh& other) {
    for (const Triangle& t : other.triangles) add(other.vertices[t[0]], other.vertices[t[1]], other.vertices[t[2]]);
}

LatticeMesh box(const LatticePoint& min, const LatticePoint& max) {
    LatticeMesh mesh;
    const auto at = [&](int corner) {
        return LatticePoint{(corner & 1) != 0 ? max[0] : min[0], (corner & 2) != 0 ? max[1] : min[1],
                            (corner & 4) != 0 ? max[2] : min[2]};
    };
    constexpr int faces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    for (const auto& f : faces) {
        mesh.add(at(f[0]), at(f[1]), at(f[2]));
        mesh.add(at(f[0]), at(f[2]), at(f[3]));
    }
    return mesh;
}

LatticeMesh tetrahedron(const std::array<LatticePoint, 4>& c) {
    LatticeMesh mesh;
    mesh.add(c[0], c[1], c[2]), mesh.add(c[0], c[1], c[3]), mesh.add(c[0], c[2], c[3]), mesh.add(c[1], c[2], c[3]);
    return mesh;
}

LatticeMesh boundary(const Cells& cells, bool merges_faces, Random& random) {
    LatticeMesh mesh;
    std::set<std::array<int, 3>> planes;  // axis, level, and whether it looks upwards
    for (int axis = 0; axis < 3; ++axis) {
        for (const LatticePoint& cell : cells) {
            const int level = cell[static_cast<std::size_t>(axis)];
            planes.insert({axis, level, 0});
            planes.insert({axis, level + 1, 1});
        }
    }
    for (const auto& [number, level, is_up] : planes) {
        const auto axis = static_cast<std::size_t>(number);
        Faces faces;
        for (const LatticePoint& cell : cells) {
            if (cell[axis] + is_up != level) continue;
            LatticePoint beyond = cell;
            beyond[axis] += is_up != 0 ? 1 : -1;
            if (!contains(cells, beyond)) faces.insert({cell[(axis + 1) % 3], cell[(axis + 2) % 3]});
        }
        while (!faces.empty()) {
            const std::array<int, 2> least =
                *std::next(faces.begin(), random.below(static_cast<std::uint32_t>(faces.size())));
            const std::array<int, 2> size =
                merges_faces ? rectangle_at(faces, least, random) : std::array<int, 2>{1, 1};
            add_rectangle(mesh, axis, level, least, size, random);
            for (int i = 0; i < size[0]; ++i) {
                for (int j = 0; j < size[1]; ++j) faces.erase({least[0] + i, least[1] + j});
            }
        }
    }
    return mesh;
}

void shuffle(std::vector<Vec3>& vertices, std::vector<Triangle>& triangles, Random& random) {
    shuffle_list(triangles, random);
    for (Triangle& triangle : triangles) {
        std::rotate(triangle.begin(), triangle.begin() + random.below(3), triangle.end());
        if (coin(random)) std::swap(triangle[0], triangle[1]);
    }
    if (random.below(4) == 0) {
        std::vector<Vec3> own;
        for (Triangle& triangle : triangles) {
            for (std::uint32_t& vertex : triangle) {
                own.push_back(vertices[vertex]);
                vertex = static_cast<std::uint32_t>(own.size() - 1);
            }
        }
        vertices = std::move(own);
    }
    if (random.below(4) != 0) return;
    for (Vec3& v : vertices) {
        for (int k = 0; k < 3; ++k) {
            if (v[k] == 0 && coin(random)) v[k] = -v[k];
        }
    }
}

void add_zero_area(LatticeMesh& mesh, Random& random) {
    const int count = integer(random, 1, 4);
    for (int i = 0; i < count; ++i) {
        const auto any = [&] { return random.below(static_cast<std::uint32_t>(mesh.vertices.size())); };
        const std::uint32_t p = any(), q = any();
        const std::uint32_t choice = random.below(4);
        if (choice == 0) {
            mesh.triangles.push_back({p, p, p});
        } else if (choice == 1) {
            mesh.triangles.push_back({p, q, q});
        } else {
            const LatticePoint u = mesh.vertices[p], v = mesh.vertices[q];
            const LatticePoint beyond{2 * v[0] - u[0], 2 * v[1] - u[1], 2 * v[2] - u[2]};
            if (is_mapped_exactly(beyond)) mesh.add(u, v, beyond);
        }
    }
}

LatticeMap random_map(Random& random) {
    LatticeMap map;
    const std::uint32_t choice = random.below(4);
    while (true) {
        for (int i = 0; i < 9; ++i) {
            map.M.data()[i] = choice < 2 ? integer(random, -3, 3) : std::floor(full(random, -1, 1) * 0x1p40) * 0x1p-40;
        }
        if (choice == 0) {
            map.M = Mat3::Identity();
            for (int k = 0; k < 3; ++k) map.M.col(k).swap(map.M.col(integer(random, 0, 2)));
            for (int k = 0; k < 3; ++k) map.M.col(k) *= coin(random) ? 1 : -1;
        }
        if (std::abs(map.M.determinant()) > 0x1p-10) break;
    }
    if (choice == 3) {
        for (int k = 0; k < 3; ++k) map.M.col(k) *= std::ldexp(1.0, -integer(random, 0, 4));
    }
    for (int k = 0; k < 3; ++k) map.o[k] = integer(random, -20, 20);
    return map;
}

LatticeMap singular_map(Random& random) {
    LatticeMap map = random_map(random);
    const int k = integer(random, 0, 2), l = (k + 1) % 3;
    map.M.col(k) = integer(random, -2, 2) * map.M.col(l);
    if (random.below(4) == 0) map.M.col((k + 2) % 3) = integer(random, -1, 1) * map.M.col(l);
    return map;
}

PosedMesh place(const LatticeMesh& mesh, const LatticeMap& map, int exponent, Random& random) {
    if (!std::ranges::all_of(mesh.vertices, is_mapped_exactly)) throw std::logic_error("a point beyond lattice_max");
    const Vec3 origin(integer(random, -3, 3), integer(random, -3, 3), integer(random, -3, 3));
    const double scale = std::ldexp(1.0, exponent), own = std::ldexp(1.0, integer(random, -3, 3));
    std::vector<Vec3> vertices;
    Pose pose;
    const std::uint32_t choice = random.below(3);
    if (choice == 0) {
        for (const LatticePoint& x : mesh.vertices) vertices.push_back(map(x) * scale);
    } else if (choice == 1) {
        for (const LatticePoint& x : mesh.vertices) vertices.push_back((Vec3(x[0], x[1], x[2]) - origin) * own);
        pose.R = map.M * (scale / own);
        pose.t = (map.M * origin + map.o) * scale;
    } else {
        Mat3 P = Mat3::Identity();
        P.col(0).swap(P.col(integer(random, 0, 2)));
        P.col(1).swap(P.col(integer(random, 1, 2)));
        for (int k = 0; k < 3; ++k) P.col(k) *= coin(random) ? 1 : -1;
        pose.R = P * own;
        pose.t = map.M * origin * scale;
        for (const LatticePoint& x : mesh.vertices) {
            vertices.push_back(P.transpose() * (map(x) * scale - pose.t) / own);
        }
    }
    std::vector<Triangle> triangles = mesh.triangles;
    shuffle(vertices, triangles, random);
    return {Mesh::create(std::move(vertices), std::move(triangles)), pose};
}

PosedMesh place_at(const LatticeMesh& mesh, const Pose& pose, Random& random) {
    std::vector<Vec3> vertices;
    for (const LatticePoint& x : mesh.vertices) vertices.push_back(Vec3(x[0], x[1], x[2]));
    std::vector<Triangle> triangles = mesh.triangles;
    shuffle(vertices, triangles, random);
    return {Mesh::create(std::move(vertices), std::move(triangles)), pose};
}

}  // namespace ecods::scenes
