#include "scenes/solid_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "scenes/hard_pair_parts.hpp"
#include "scenes/kuhn_tetrahedra.hpp"
#include "scenes/shapes.hpp"

namespace ecods::scenes {
namespace {

using hard::coin;
using hard::full;
using hard::integer;

int random_exponent(Random& random) {
    constexpr int exponents[] = {0, 0, 0, 0, -1, 20, -60, 300, -300, 900, -1010};
    return exponents[random.below(std::size(exponents))];
}

// Both images under one map.
SolidCase placed(LatticeMesh a, LatticeMesh b, std::optional<Relation> relation, Random& random) {
    if (random.below(4) == 0) add_zero_area(a, random);
    if (random.below(4) == 0) add_zero_area(b, random);
    const LatticeMap map = random_map(random);
    const int exponent = random_exponent(random);
    return {place(a, map, exponent, random), place(b, map, exponent, random), relation, {}};
}

Cells random_cells(int size, Random& random) {
    Cells cells;
    const std::uint32_t share = 1 + random.below(4);
    for (int x = 0; x < size; ++x) {
        for (int y = 0; y < size; ++y) {
            for (int z = 0; z < size; ++z) {
                if (random.below(5) < share) cells.push_back({x, y, z});
            }
        }
    }
    if (cells.empty()) cells.push_back({0, 0, 0});
    return cells;
}

std::pair<Cells, Cells> related_cells(Random& random) {
    const std::uint32_t draw = random.below(20);  // what is hard is local, and large sets cost
    const int size = draw < 16 ? 2 : draw < 19 ? 3 : 4;
    Cells a = random_cells(size, random), b = random_cells(size, random);
    const std::uint32_t choice = random.below(7);
    Cells chosen;
    if (choice == 0) return {a, shifted(b, {integer(random, -3, 3), integer(random, -3, 3), integer(random, -3, 3)})};
    if (choice == 1) return {a, a};
    if (choice == 2) std::ranges::set_union(a, b, std::back_inserter(chosen));
    if (choice == 3) std::ranges::set_difference(b, a, std::back_inserter(chosen));
    if (choice == 4) std::ranges::set_intersection(a, b, std::back_inserter(chosen));
    if (choice == 5) {  // one cell more or less
        const LatticePoint cell{integer(random, 0, size - 1), integer(random, 0, size - 1), integer(random, 0, size)};
        chosen = a;
        if (std::erase(chosen, cell) == 0) chosen.push_back(cell);
        chosen = sorted(chosen);
    }
    return {a, chosen.empty() ? b : chosen};
}

LatticeMesh random_boundary(const Cells& cells, Random& random) {
    return boundary(cells, coin(random), random);
}

SolidCase make_polycubes(Random& random) {
    auto [a, b] = related_cells(random);
    if (coin(random)) std::swap(a, b);
    LatticeMesh mesh_a = random_boundary(a, random), mesh_b = random_boundary(b, random);
    if (random.below(4) == 0) add_zero_area(mesh_a, random);
    if (random.below(4) == 0) add_zero_area(mesh_b, random);
    const LatticeMap map = random_map(random);
    const int exponent = random_exponent(random);
    SolidCase made{place(mesh_a, map, exponent, random), place(mesh_b, map, exponent, random), relation(a, b), {}};
    for (int i = 0; i < 6; ++i) {
        const LatticePoint doubled{integer(random, -1, 9), integer(random, -1, 9), integer(random, -1, 9)};
        const Vec3 point = map.M * (Vec3(doubled[0], doubled[1], doubled[2]) / 2) + map.o;
        made.points.push_back({point * std::ldexp(1.0, exponent), side_of(doubled, a)});
    }
    return made;
}

SolidCase make_common_pose(Random& random) {
    const auto [a, b] = related_cells(random);
    Pose pose;
    if (coin(random)) pose = hard::random_pose(random);
    for (int i = 0; i < 9 && coin(random); ++i) pose.R.data()[i] = full(random, -2, 2);
    pose.R *= std::ldexp(1.0, random_exponent(random) / 2);
    return {place_at(random_boundary(a, random), pose, random),
            place_at(random_boundary(b, random), pose, random),
            relation(a, b),
            {}};
}

// Layer i is what lies between the cubes of radius i and i + 1.
using Layers = std::set<int>;

LatticeMesh shells(const Layers& layers) {
    LatticeMesh mesh;
    for (int r = 1; r <= 8; ++r) {
        if (layers.contains(r - 1) != layers.contains(r)) mesh.add(box({-r, -r, -r}, {r, r, r}));
    }
    return mesh;
}

SolidCase make_shells(Random& random) {
    std::array<Layers, 2> layers;
    const int first = integer(random, 1, 6);
    for (int i = 0; i < 7; ++i) {
        const std::uint32_t bits = random.below(4);
        for (std::uint32_t s = 0; s < 2; ++s) {
            if ((bits >> s & 1) != 0 || i == first) layers[s].insert(i);
        }
    }
    if (coin(random)) {
        layers[1].erase(first);
        if (layers[1].empty()) layers[1].insert(first + 1);
        if (coin(random)) std::erase_if(layers[0], [&](int i) { return layers[1].contains(i); });
        if (layers[0].empty()) layers[0].insert(0);
    }
    const auto& [a, b] = layers;
    const auto meets = [&](int by) { return std::ranges::any_of(a, [&](int i) { return b.contains(i + by); }); };
    const Relation relation = a == b                        ? Relation::equal
                              : std::ranges::includes(b, a) ? Relation::inside
                              : std::ranges::includes(a, b) ? Relation::contains
                              : meets(0)                    ? Relation::overlapping
                              : meets(1) || meets(-1)       ? Relation::touching
                                                            : Relation::apart;
    return placed(shells(a), shells(b), relation, random);
}

struct Ends {
    LatticePoint min{}, max{};
};

Ends random_ends(Random& random) {
    Ends ends;
    for (std::size_t k = 0; k < 3; ++k) {
        ends.min[k] = integer(random, 0, 4);
        ends.max[k] = integer(random, ends.min[k] + 1, 6);
    }
    return ends;
}

SolidCase make_boxes(Random& random) {
    const Ends a = random_ends(random);
    Ends b = random_ends(random);
    for (std::size_t k = 0; k < 3; ++k) {  // flush sides
        if (coin(random)) b.min[k] = std::min(a.min[k], b.max[k] - 1);
        if (coin(random)) b.max[k] = std::max(a.max[k], b.min[k] + 1);
    }
    bool is_in_a = true, is_in_b = true, share_interior = true, share_point = true;
    for (std::size_t k = 0; k < 3; ++k) {
        is_in_a = is_in_a && a.min[k] <= b.min[k] && b.max[k] <= a.max[k];
        is_in_b = is_in_b && b.min[k] <= a.min[k] && a.max[k] <= b.max[k];
        share_interior = share_interior && std::max(a.min[k], b.min[k]) < std::min(a.max[k], b.max[k]);
        share_point = share_point && std::max(a.min[k], b.min[k]) <= std::min(a.max[k], b.max[k]);
    }
    const Relation relation = is_in_a && is_in_b ? Relation::equal
                              : is_in_b          ? Relation::inside
                              : is_in_a          ? Relation::contains
                              : share_interior   ? Relation::overlapping
                              : share_point      ? Relation::touching
                                                 : Relation::apart;
    return placed(box(a.min, a.max), box(b.min, b.max), relation, random);
}

SolidCase make_kuhn(Random& random) {
    const int size = integer(random, 1, 2);
    Tetrahedra a = random_tetrahedra(size, random), b = random_tetrahedra(size, random);
    const std::uint32_t choice = random.below(3);
    if (choice == 0) b.insert(a.begin(), a.end());
    if (choice == 1) std::erase_if(b, [&](const Tetrahedron& t) { return a.contains(t) && b.size() > 1; });
    if (coin(random)) std::swap(a, b);
    return placed(boundary(a, {1, 1, 1}, {}), boundary(b, {1, 1, 1}, {}), relation(a, b), random);
}

SolidCase make_kuhn_mixed(Random& random) {
    std::array<LatticeMesh, 2> meshes;
    for (LatticeMesh& mesh : meshes) {
        LatticePoint scale{}, by{};
        const int size = integer(random, 1, 3);
        for (std::size_t k = 0; k < 3; ++k) {
            scale[k] = coin(random) ? size : -size;
            by[k] = integer(random, 0, 4);
        }
        mesh = boundary(random_tetrahedra(integer(random, 1, 2), random), scale, by);
    }
    return placed(std::move(meshes[0]), std::move(meshes[1]), std::nullopt, random);
}

SolidCase make_contacts(Random& random) {
    const auto& all = fixed_contacts();
    const LatticePair& pair = all[random.below(static_cast<std::uint32_t>(all.size()))];
    return placed(pair.a, pair.b, pair.relation, random);
}

bool is_flat(const std::array<LatticePoint, 4>& c) {
    const auto edge = [&](std::size_t i) { return Vec3(c[i][0] - c[0][0], c[i][1] - c[0][1], c[i][2] - c[0][2]); };
    return edge(1).cross(edge(2)).dot(edge(3)) == 0;
}

std::array<LatticePoint, 4> random_corners(Random& random) {
    std::array<LatticePoint, 4> corners{};
    do {
        for (LatticePoint& corner : corners) {
            for (int& x : corner) x = 6 * integer(random, -2, 2);
        }
    } while (is_flat(corners));
    return corners;
}

SolidCase make_tetrahedra(Random& random) {
    const auto a = random_corners(random);
    auto b = random_corners(random);
    do {
        for (LatticePoint& corner : b) {
            // A point of a: a corner, a point of an edge or of a face, or one inside.
            std::array<int, 4> weights{};
            for (int left = 6; left > 0;) {
                const int part = random.below(3) == 0 ? left : integer(random, 1, left);
                weights[random.below(4)] += part;
                left -= part;
            }
            if (coin(random)) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                corner[k] = 0;
                for (std::size_t i = 0; i < 4; ++i) corner[k] += weights[i] * a[i][k] / 6;
            }
        }
    } while (is_flat(b));
    return placed(tetrahedron(a), tetrahedron(b), std::nullopt, random);
}

std::shared_ptr<const Mesh> random_body(Random& random) {
    const std::uint32_t choice = random.below(3);
    return choice == 0 ? cube(full(random, 0.2, 1)) : choice == 1 ? sphere(5, 3) : torus(4, 3, 0.375);
}

SolidCase make_bodies(Random& random) {
    Pose a = hard::random_pose(random), b = hard::random_pose(random);
    b.t = a.t + full(random, 0, 1.75) * random.direction();
    if (coin(random)) b.R = a.R;
    b.R *= full(random, 0.1, 1.5);
    return {{random_body(random), a}, {random_body(random), b}, std::nullopt, {}};
}

PosedMesh far_flung(Random& random) {
    const LatticeMesh mesh = tetrahedron(random_corners(random));
    std::vector<Vec3> vertices(4);
    const int range = coin(random) ? 3 : 300;
    for (Vec3& v : vertices) {
        for (int k = 0; k < 3; ++k) v[k] = std::ldexp(full(random, -1, 1), integer(random, -range, range));
    }
    Pose pose;
    if (coin(random)) pose = hard::random_pose(random);
    return {Mesh::create(std::move(vertices), mesh.triangles), pose};
}

// Segments of one solid go anywhere, also through the other one.
SolidCase make_antennas(Random& random) {
    const auto [a, b] = related_cells(random);
    LatticeMesh mesh = random_boundary(a, random);
    for (std::uint32_t i = 0, count = 1 + random.below(3); i < count; ++i) {
        const auto point = [&] {
            return LatticePoint{integer(random, -1, 4), integer(random, -1, 4), integer(random, -1, 4)};
        };
        const LatticePoint p = point();
        mesh.add(p, p, point());
    }
    SolidCase made = placed(std::move(mesh), random_boundary(b, random), relation(a, b), random);
    if (coin(random)) {
        std::swap(made.a, made.b);
        made.relation = relation(b, a);
    }
    return made;
}

SolidCase make_singular(Random& random) {
    const auto [a, b] = related_cells(random);
    const LatticeMap flat = singular_map(random);
    const std::uint32_t choice = random.below(3);
    const LatticeMap other = choice == 0 ? flat : choice == 1 ? singular_map(random) : random_map(random);
    const auto in_pose = [&](const Cells& cells, const LatticeMap& map) {
        return place_at(random_boundary(cells, random), Pose{map.M, map.o}, random);
    };
    SolidCase made{in_pose(a, flat), in_pose(b, other), std::nullopt, {}};
    if (coin(random)) made.b.pose.t = made.a.pose.t;
    if (coin(random)) std::swap(made.a, made.b);
    return made;
}

SolidCase make_nudged(Random& random) {
    SolidCase made = coin(random)           ? make_contacts(random)
                     : random.below(3) == 0 ? make_common_pose(random)
                                            : make_boxes(random);
    Pose& pose = coin(random) ? made.a.pose : made.b.pose;
    double& number =
        coin(random) ? pose.t[integer(random, 0, 2)] : pose.R(integer(random, 0, 2), integer(random, 0, 2));
    number = std::nextafter(number,
                            coin(random) ? std::numeric_limits<double>::max() : std::numeric_limits<double>::lowest());
    made.relation.reset();
    return made;
}

SolidCase make_exponents(Random& random) {
    return {far_flung(random), far_flung(random), std::nullopt, {}};
}

constexpr Family<SolidCase> table[] = {
    // Known: sets of cells in a grid of 2 to 4, biased to subsets, complements and neighbours
    {"polycubes", make_polycubes},
    {"shells", make_shells},            // known: cubes in cubes in cubes, some layers of them filled
    {"boxes", make_boxes},              // known: two boxes with ends among a few integers, so that sides are flush
    {"kuhn", make_kuhn},                // known: sets of the tetrahedra into which the diagonals cut the cells
    {"contacts", make_contacts},        // known: one of fixed_contacts()
    {"common pose", make_common_pose},  // known: polycubes in one pose of any numbers
    {"singular", make_singular},        // a pose without an inverse; known if both have it and nothing is inside
    // One of the above, a number of a pose or a coordinate of it moved by one ulp: solids for most
    {"nudged", make_nudged},
    {"kuhn mixed", make_kuhn_mixed},  // two lattices with their own mirroring and size
    {"tetrahedra", make_tetrahedra},  // small ones, corners of one on faces, edges and corners of the other
    {"bodies", make_bodies},          // boxes, spheres and tori in random poses
    {"exponents", make_exponents},    // tetrahedra of coordinates of any exponents
    {"antennas", make_antennas},      // known: polycubes, out of one of which stick segments of zero area
};

}  // namespace

Families<SolidCase> solid_families() {
    return table;
}

}  // namespace ecods::scenes
