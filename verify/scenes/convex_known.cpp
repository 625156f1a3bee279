// The families whose depths and distances are known: integers all through.
#include <algorithm>
#include <cmath>
#include <vector>

#include "scenes/convex_recipes.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/integer_rotation.hpp"
#include "scenes/lattice_hull.hpp"

namespace ecods::scenes::convexity {
namespace {

using hard::coin;
using hard::integer;

struct Ends {
    LatticePoint min{}, max{};
};

Ends random_ends(Random& random) {
    Ends ends;
    for (std::size_t k = 0; k < 3; ++k) {
        ends.min[k] = integer(random, -5, 5);
        ends.max[k] = ends.min[k] + integer(random, 1, 6);
    }
    return ends;
}

// Corners that are integers in the common frame, written in an integer rotation.
PosedMesh rotated(const LatticeMesh& mesh, const IntegerRotation& own, const IntegerRotation& other,
                  const IntegerRotation& space, const Vec3& shift, double scale, Random& random) {
    std::vector<Vec3> vertices;
    for (const LatticePoint& p : mesh.vertices) {
        vertices.push_back(own.R.transpose() * (other.norm * other.norm * Vec3(p[0], p[1], p[2])));
    }
    std::vector<Triangle> triangles = mesh.triangles;
    shuffle(vertices, triangles, random);
    PosedMesh placed{Mesh::create(std::move(vertices), std::move(triangles)), {}};
    placed.pose.R = space.R * own.R * scale;
    placed.pose.t = shift * scale;
    return placed;
}

}  // namespace

ConvexCase aligned_boxes(Random& random) {
    const Ends a = random_ends(random);
    Ends b = random_ends(random);
    if (random.below(4) == 0) b = a;
    LatticeMap map;
    for (int k = 0; k < 3; ++k) map.M.col(k).swap(map.M.col(integer(random, 0, 2)));
    for (int k = 0; k < 3; ++k) {
        map.M.col(k) *= coin(random) ? 1 : -1;
        map.o[k] = integer(random, -20, 20);
    }
    const int exponent = random.below(4) == 0 ? integer(random, -900, 900) : 0;
    LatticeMesh mesh_a = box(a.min, a.max);
    if (random.below(4) == 0) add_zero_area(mesh_a, random);
    ConvexCase made{place(mesh_a, map, exponent, random), place(box(b.min, b.max), map, exponent, random)};
    int depth = 100, square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const int overlap = std::min(a.max[k] - b.min[k], b.max[k] - a.min[k]);
        depth = std::min(depth, overlap);
        square += overlap < 0 ? overlap * overlap : 0;
    }
    made.distance = std::ldexp(std::sqrt(square), exponent);
    if (depth >= 0) made.depth = std::ldexp(depth, exponent);
    return made;
}

// The box [0, 8]^3, and what is above the height 8 - depth, where it has a vertex, an edge or a face. The point `foot`
// of it is as deep below the other sides of the box, so that a ball around the origin is in the set of differences.
ConvexCase integer_rotations(Random& random) {
    const int depth = integer(random, -4, 4), bottom = 8 - depth, margin = std::max(depth, 0);
    const auto across = [&] { return integer(random, margin, 8 - margin); };
    const LatticePoint foot{across(), across(), bottom};
    LatticeMesh b;
    while (b.triangles.empty()) {
        std::vector<LatticePoint> points{foot};
        const int level = integer(random, 0, 2), above = integer(random, 3, 6);
        for (int i = 0; i < level; ++i) {
            points.push_back({foot[0] + integer(random, -4, 4), foot[1] + integer(random, -4, 4), bottom});
        }
        for (int i = 0; i < above; ++i) {
            points.push_back({integer(random, -4, 12), integer(random, -4, 12), bottom + integer(random, 1, 9)});
        }
        b = lattice_hull(points);
    }
    LatticeMesh a = box({0, 0, 0}, {8, 8, 8});
    if (random.below(4) == 0) a = refined(box({0, 0, 0}, {4, 4, 4}));
    const IntegerRotation of_space(random), of_a(random), of_b(random);
    const double scale = std::ldexp(1.0, random.below(4) == 0 ? integer(random, -600, 600) : 0);
    const Vec3 shift(integer(random, -1000, 1000), integer(random, -1000, 1000), integer(random, -1000, 1000));
    ConvexCase made{rotated(a, of_a, of_b, of_space, shift, scale, random),
                    rotated(b, of_b, of_a, of_space, shift, scale, random)};
    const double length = of_a.norm * of_a.norm * of_b.norm * of_b.norm * of_space.norm * scale;
    made.distance = std::max(-depth, 0) * length;
    if (depth >= 0) made.depth = depth * length;
    if (coin(random)) std::swap(made.a, made.b);
    return made;
}

}  // namespace ecods::scenes::convexity
