#include <utility>

#include "scenes/solid_cases.hpp"

namespace ecods::scenes {
namespace {

using P = LatticePoint;

LatticeMesh octahedron(int r) {
    LatticeMesh mesh;
    for (const int x : {-r, r}) {
        for (const int y : {-r, r}) {
            for (const int z : {-r, r}) mesh.add({x, 0, 0}, {0, y, 0}, {0, 0, z});
        }
    }
    return mesh;
}

// The convex hull of a triangle and the same one further along.
LatticeMesh prism(const P& p, const P& q, const P& r, const P& along) {
    const auto moved = [&](const P& x) { return P{x[0] + along[0], x[1] + along[1], x[2] + along[2]}; };
    LatticeMesh mesh;
    mesh.add(p, q, r);
    mesh.add(moved(p), moved(q), moved(r));
    for (const auto& [from, to] : {std::pair(p, q), std::pair(q, r), std::pair(r, p)}) {
        mesh.add(from, to, moved(to));
        mesh.add(from, moved(to), moved(from));
    }
    return mesh;
}

LatticeMesh both(LatticeMesh first, const LatticeMesh& second) {
    first.add(second);
    return first;
}

LatticeMesh cube(int r) {
    return box({-r, -r, -r}, {r, r, r});
}

// Four triangles a face, around its centre.
LatticeMesh cube_of_pyramids(int r) {
    LatticeMesh mesh;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int level : {-r, r}) {
            const auto at = [&](int u, int v) {
                P p{};
                p[axis] = level, p[(axis + 1) % 3] = u, p[(axis + 2) % 3] = v;
                return p;
            };
            const P corners[] = {at(-r, -r), at(r, -r), at(r, r), at(-r, r)};
            for (std::size_t i = 0; i < 4; ++i) mesh.add(corners[i], corners[(i + 1) % 4], at(1, 0));
        }
    }
    return mesh;
}

// Two cubes that share an edge, as one solid, with four triangles at that edge.
LatticeMesh two_cubes() {
    return both(box({0, 0, 0}, {2, 2, 2}), box({2, 2, 0}, {4, 4, 2}));
}

std::vector<LatticePair> convex_contacts() {
    using enum Relation;
    const LatticeMesh roof = prism({-1, 0, 2}, {-1, 1, 4}, {-1, -1, 4}, {2, 0, 0});
    return {
        {"an octahedron inscribed in a cube", octahedron(2), cube(2), inside},
        {"an octahedron whose faces hold the cube's corners", cube(1), octahedron(3), inside},
        {"an octahedron through a cube's faces", octahedron(3), cube(2), overlapping},
        {"an octahedron just in reach of a cube's face", octahedron(2), box({2, -2, -2}, {6, 2, 2}), touching},
        {"a convex edge in a face", roof, cube(2), touching},
        {"a convex edge in a face, from inside", prism({-1, 0, 2}, {-1, 1, 0}, {-1, -1, 0}, {2, 0, 0}), cube(2),
         inside},
        {"a convex edge through a face", prism({-1, 0, 1}, {-1, 1, 4}, {-1, -1, 4}, {2, 0, 0}), cube(2), overlapping},
        {"a convex edge on an edge", prism({2, -1, 2}, {3, -1, 4}, {4, -1, 3}, {0, 2, 0}), cube(2), touching},
        {"a wedge on an edge, one face flush", prism({2, -1, 2}, {4, -1, 2}, {4, -1, 4}, {0, 2, 0}), cube(2), touching},
        {"a wedge around an edge", prism({2, -1, 2}, {0, -1, 1}, {1, -1, 0}, {0, 2, 0}), cube(2), inside},
        {"a wedge across an edge", prism({2, -1, 2}, {0, -1, 3}, {3, -1, 0}, {0, 2, 0}), cube(2), overlapping},
        {"a corner in a corner", tetrahedron({P{2, 2, 2}, P{0, 2, 2}, P{2, 0, 2}, P{2, 2, 0}}), cube(2), inside},
        {"a corner on a corner", tetrahedron({P{2, 2, 2}, P{4, 2, 3}, P{2, 4, 3}, P{3, 3, 5}}), cube(2), touching},
        {"a corner on an edge", tetrahedron({P{2, 0, 2}, P{5, 0, 3}, P{4, 1, 5}, P{4, -1, 5}}), cube(2), touching},
        {"a corner on a face", tetrahedron({P{0, 0, 2}, P{1, 0, 4}, P{-1, 1, 4}, P{-1, -1, 4}}), cube(2), touching},
        {"a corner on a face, from inside", tetrahedron({P{0, 0, 2}, P{1, 0, 0}, P{-1, 1, 0}, P{-1, -1, 0}}), cube(2),
         inside},
        {"edges that cross at a point", prism({-2, 0, 2}, {-2, 1, 4}, {-2, -1, 4}, {4, 0, 0}),
         prism({0, -2, 2}, {1, -2, 0}, {-1, -2, 0}, {0, 4, 0}), touching},
        {"edges that pass each other", prism({-2, 0, 3}, {-2, 1, 5}, {-2, -1, 5}, {4, 0, 0}),
         prism({0, -2, 2}, {1, -2, 0}, {-1, -2, 0}, {0, 4, 0}), apart},
        {"one corner common, all edges in the other's faces' planes", cube(1), box({1, 1, 1}, {3, 3, 3}), touching},
        {"tetrahedra over one face", tetrahedron({P{0, 0, 0}, P{2, 0, 0}, P{0, 2, 0}, P{0, 0, 2}}),
         tetrahedron({P{0, 0, 0}, P{2, 0, 0}, P{0, 2, 0}, P{0, 0, -2}}), touching},
        {"tetrahedra on one side of one face", tetrahedron({P{0, 0, 0}, P{2, 0, 0}, P{0, 2, 0}, P{0, 0, 2}}),
         tetrahedron({P{0, 0, 0}, P{2, 0, 0}, P{0, 2, 0}, P{1, 1, 2}}), overlapping},
    };
}

std::vector<LatticePair> flush_contacts() {
    using enum Relation;
    return {
        {"walls that share 5 cm", box({0, 0, 0}, {30, 2, 25}), box({25, 0, 0}, {60, 2, 25}), overlapping},
        {"a block on a slab", box({0, 0, 2}, {2, 2, 4}), box({-3, -3, 0}, {5, 5, 2}), touching},
        {"a block on a slab, over its rim", box({0, 0, 2}, {9, 2, 4}), box({-3, -3, 0}, {5, 5, 2}), touching},
        {"a slab in a thicker one, flush below", box({0, 0, 0}, {6, 6, 1}), box({-1, -1, 0}, {7, 7, 2}), inside},
        {"a slab in a thicker one, flush on five sides", box({0, 0, 0}, {6, 6, 1}), box({0, 0, 0}, {6, 6, 2}), inside},
        {"a pipe through a wall", box({-1, -1, -5}, {1, 1, 5}), box({-4, -4, -1}, {4, 4, 1}), overlapping},
        {"a pipe in a wall", box({-3, -1, -1}, {3, 1, 1}), box({-4, -4, -2}, {4, 4, 2}), inside},
        {"equal cubes of other triangles", cube(2), cube_of_pyramids(2), equal},
        {"cubes of other triangles, one side longer", cube_of_pyramids(2), box({-2, -2, -2}, {2, 2, 3}), inside},
        {"boxes that share an edge", box({0, 0, 0}, {2, 2, 2}), box({2, 2, 0}, {4, 4, 2}), touching},
        {"boxes that share part of an edge", box({0, 0, 0}, {2, 2, 2}), box({2, 2, 1}, {4, 4, 5}), touching},
        {"boxes that share part of a face", box({0, 0, 0}, {2, 2, 2}), box({2, 1, 1}, {4, 5, 5}), touching},
        {"two cubes at an edge, and one that fills a notch", two_cubes(), box({2, 0, 0}, {4, 2, 2}), touching},
        {"two cubes at an edge, and one that fills a notch and more", two_cubes(), box({2, 0, 0}, {4, 3, 2}),
         overlapping},
        {"two cubes at an edge, and one of them", box({0, 0, 0}, {2, 2, 2}), two_cubes(), inside},
        {"two cubes at an edge, and what holds both", two_cubes(), box({0, 0, 0}, {4, 4, 2}), inside},
        {"two cubes at an edge, and others there", two_cubes(),
         both(box({0, 2, 0}, {2, 4, 2}), box({2, 0, 0}, {4, 2, 2})), touching},
    };
}

std::vector<LatticePair> shell_contacts() {
    using enum Relation;
    const LatticeMesh shell = both(cube(4), cube(2));
    return {
        {"a cube in a cavity", cube(1), shell, apart},
        {"a cube that fills a cavity", cube(2), shell, touching},
        {"a cube in a cavity, on its floor", box({-1, -1, -2}, {1, 1, 0}), shell, touching},
        {"an octahedron inscribed in a cavity", octahedron(2), shell, touching},
        {"an octahedron beyond a cavity", octahedron(3), shell, overlapping},
        {"a cube with a shell's outside", cube(4), shell, contains},
        {"a cube around a shell", cube(5), shell, contains},
        {"a shell in a shell's layer", both(cube(4), cube(3)), shell, inside},
        {"a shell in a shell's cavity", both(cube(2), cube(1)), shell, touching},
        {"a cube in a layer", box({2, -1, -1}, {4, 1, 1}), shell, inside},
        {"a cube in a layer, touching neither side", box({3, -1, -1}, {3 + 1, 1, 1}), both(cube(6), cube(2)), inside},
        {"a cube beyond a layer", box({1, -1, -1}, {4, 1, 1}), shell, overlapping},
        {"shells of three, one layer moved in", both(both(cube(6), cube(4)), cube(2)),
         both(both(cube(6), cube(4)), cube(3)), inside},
        {"a cube away from two others", cube(1), both(box({3, 0, 0}, {4, 1, 1}), box({-4, 0, 0}, {-3, 1, 1})), apart},
    };
}

}  // namespace

const std::vector<LatticePair>& fixed_contacts() {
    static const std::vector<LatticePair> all = [] {
        std::vector<LatticePair> list = convex_contacts();
        for (auto* make : {flush_contacts, shell_contacts}) {
            for (LatticePair& pair : make()) list.push_back(std::move(pair));
        }
        return list;
    }();
    return all;
}

}  // namespace ecods::scenes
