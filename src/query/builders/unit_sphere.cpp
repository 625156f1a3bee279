#include "query/builders/unit_sphere.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "query/builders/fixed_point.hpp"

namespace ecods::builders {
namespace {

using exact::Int128;
using exact::Uint128;
using Point = std::array<std::int64_t, 3>;

// The vertices are (0, +-s, +-l) and the cyclic permutations of these, where l / s is the golden ratio and s^2 + l^2 =
// 1.
UnitSphere icosahedron() {
    constexpr std::int64_t s = 0x0869'6506'd0a9'8690, l = 0x0d9c'4405'a301'f23f;
    return {{{-s, l, 0},
             {s, l, 0},
             {-s, -l, 0},
             {s, -l, 0},
             {0, -s, l},
             {0, s, l},
             {0, -s, -l},
             {0, s, -l},
             {l, 0, -s},
             {l, 0, s},
             {-l, 0, -s},
             {-l, 0, s}},
            {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
             {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
             {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

// Returns the square root of x, rounded down, by Newton's method from above.
Uint128 square_root(Uint128 x) noexcept {
    Uint128 root = Uint128{1} << (exact::bit_width(x) / 2 + 1);
    for (;;) {
        const Uint128 next = (root + x / root) / 2;
        if (next >= root) return root;
        root = next;
    }
}

// Returns the point of the sphere in the direction of p + q.
Point middle(const Point& p, const Point& q) noexcept {
    std::array<Int128, 3> sum;
    Uint128 square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        sum[i] = Int128{p[i]} + q[i];
        square += static_cast<Uint128>(sum[i] * sum[i]);
    }
    const auto length = static_cast<Int128>(square_root(square));
    Point result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = static_cast<std::int64_t>(sum[i] * fixed_one / length);
    return result;
}

UnitSphere subdivide(UnitSphere sphere) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle_of = [&](std::uint32_t a, std::uint32_t b) {
        const auto next = static_cast<std::uint32_t>(sphere.points.size());
        const auto [at, is_new] = middles.emplace(std::minmax(a, b), next);
        if (is_new) sphere.points.push_back(middle(sphere.points[a], sphere.points[b]));
        return at->second;
    };
    std::vector<Triangle> triangles;
    for (const auto& [a, b, c] : sphere.triangles) {
        const std::uint32_t ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
        triangles.insert(triangles.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    sphere.triangles = std::move(triangles);
    return sphere;
}

}  // namespace

UnitSphere subdivide_icosahedron(std::uint32_t subdivisions) {
    UnitSphere sphere = icosahedron();
    for (std::uint32_t i = 0; i < subdivisions; ++i) sphere = subdivide(std::move(sphere));
    return sphere;
}

}  // namespace ecods::builders
