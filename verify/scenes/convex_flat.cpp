// Polygons, segments and points of the lattice, as meshes that are cut in many ways.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "scenes/convex_recipes.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/lattice_hull.hpp"

namespace ecods::scenes::convexity {
namespace {

using hard::coin;
using hard::integer;

using Point2 = std::array<int, 2>;

int turn(const Point2& p, const Point2& q, const Point2& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

// The corners of the hull of distinct points, by the sides that have all others on the left; none if all are on a line.
std::vector<Point2> hull_of(const std::vector<Point2>& points) {
    const auto length = [](const Point2& p, const Point2& q) {
        return (q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]);
    };
    std::vector<Point2> corners{*std::ranges::min_element(points)};
    do {
        const Point2 at = corners.back();
        Point2 next = at;
        for (const Point2& p : points) {
            const int side = turn(at, next, p);
            if (next == at || side < 0 || (side == 0 && length(at, p) > length(at, next))) next = p;
        }
        corners.push_back(next);
    } while (corners.back() != corners.front() && corners.size() <= points.size());
    corners.pop_back();
    return corners.size() < 3 ? std::vector<Point2>() : corners;
}

LatticeMesh polygon(Random& random) {
    for (;;) {
        std::vector<Point2> points;
        const int size = integer(random, 1, 3), count = integer(random, 3, 9);
        for (int i = 0; i < count; ++i) {
            const Point2 p{integer(random, -size, size), integer(random, -size, size)};
            if (std::ranges::find(points, p) == points.end()) points.push_back(p);
        }
        std::vector<Point2> corners = hull_of(points);
        if (corners.empty()) continue;
        std::ranges::rotate(corners, corners.begin() + random.below(static_cast<std::uint32_t>(corners.size())));
        LatticeMesh mesh;
        const auto at = [](const Point2& p) { return LatticePoint{p[0], p[1], 0}; };
        for (std::size_t i = 2; i < corners.size(); ++i) mesh.add(at(corners[0]), at(corners[i - 1]), at(corners[i]));
        return mesh;
    }
}

// Unit squares with random diagonals: there are vertices inside the polygon and its sides.
LatticeMesh grid(Random& random) {
    LatticeMesh mesh;
    const int width = integer(random, 1, 3), height = integer(random, 1, 3);
    for (int x = 0; x < width; ++x) {
        for (int y = 0; y < height; ++y) {
            const std::array<LatticePoint, 4> square{{{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}}};
            const std::size_t from = coin(random) ? 1 : 0;
            mesh.add(square[from], square[from + 1], square[from + 2]);
            mesh.add(square[from], square[from + 2], square[(from + 3) % 4]);
        }
    }
    return mesh;
}

// Pieces that overlap or share an end, each a triangle that names an end twice or has its three corners in a row.
LatticeMesh segment(Random& random) {
    const LatticePoint step{integer(random, 1, 2), integer(random, -1, 1), 0};
    const auto at = [&](int i) { return LatticePoint{i * step[0], i * step[1], 0}; };
    LatticeMesh mesh;
    switch (random.below(3)) {
        case 0:
            mesh.add(at(-1), at(1), at(1));
            break;
        case 1:
            mesh.add(at(1), at(2), at(1));
            mesh.add(at(1), at(-1), at(0));
            break;
        default:
            mesh.add(at(0), at(0), at(0));
            mesh.add(at(-1), at(1), at(0));
            mesh.add(at(2), at(0), at(2));
    }
    return mesh;
}

LatticeMesh flat(Random& random) {
    switch (random.below(6)) {
        case 0: {
            LatticeMesh point;
            point.add({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
            return point;
        }
        case 1:
            return segment(random);
        case 2:
            return grid(random);
        case 3: {
            LatticeMesh mesh = polygon(random);
            add_zero_area(mesh, random);
            return mesh;
        }
        case 4:
            return refined(polygon(random));
        default:
            return polygon(random);
    }
}

// A bijection of the lattice: other planes.
LatticeMesh slanted(LatticeMesh mesh, Random& random) {
    const int a = integer(random, -1, 1), b = integer(random, -1, 1);
    const auto first = static_cast<std::ptrdiff_t>(random.below(3));
    for (LatticePoint& p : mesh.vertices) {
        p[2] += a * p[0] + b * p[1];
        std::ranges::rotate(p, p.begin() + first);
    }
    return mesh;
}

LatticeMesh shifted(LatticeMesh mesh, const LatticePoint& by) {
    for (LatticePoint& p : mesh.vertices) {
        for (std::size_t k = 0; k < 3; ++k) p[k] += by[k];
    }
    return mesh;
}

}  // namespace

// Two flat sets in one plane, two in any planes, or one and a hull; under one map of the lattice or in poses that
// round.
ConvexCase flat_sets(Random& random) {
    LatticeMesh a = flat(random), b;
    const int far = integer(random, 0, 3);
    const auto any = [&] { return integer(random, -far, far); };
    const std::uint32_t choice = random.below(3);
    if (choice == 0) {
        b = shifted(flat(random), {any(), any(), random.below(4) == 0 ? any() : 0});
    } else if (choice == 1) {
        a = slanted(std::move(a), random);
        b = shifted(slanted(flat(random), random), {any(), any(), any()});
    } else {
        a = slanted(std::move(a), random);
        b = shifted(random_lattice_hull(integer(random, 1, 2), integer(random, 4, 8), random), {any(), any(), any()});
    }
    if (coin(random)) std::swap(a, b);
    if (random.below(4) == 0) {
        ConvexCase made{place_at(a, hard::random_pose(random), random), place_at(b, hard::random_pose(random), random)};
        made.b.pose.t = made.a.pose.t + hard::full(random, 0, 2) * random.direction();
        return made;
    }
    const LatticeMap map = random_map(random);
    constexpr std::array exponents{0, 0, 0, 0, -1, 20, -60, 300};
    const int exponent = exponents[random.below(exponents.size())];
    return {place(a, map, exponent, random), place(b, map, exponent, random)};
}

}  // namespace ecods::scenes::convexity
