// What two triangles share, and triangles and a tetrahedron (CGAL, Intersections_3/test/Intersections_3:
// triangle_3_triangle_3_intersection.cpp and triangle_other.cpp).
#include <array>
#include <cstddef>

#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"

namespace ecods::foreign::cgal {
namespace {

// How many corners what they share has: 0 for nothing, 1 for a point, 2 for a segment, more for a polygon.
struct InSpace {
    double a[9], b[9];
    std::size_t corners;
};
constexpr InSpace in_space[] = {
    {{0, 0, 0, 0, 1, 0, 1, 0, 0}, {0.1, 0.1, 1, 0.2, 0.1, 1, 0.25, 0.25, -1}, 2},
    {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 1, 0, 0, 0, 0, 1}, 2},
    {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0.1, 0, 0, 0.9, 0, 0, 0, 0, 1}, 2},
    {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 0.9, 0, 0, 0, 0, 1}, 2},
    {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {-0.1, 0, 0, 0.9, 0, 0, 0, 0, 1}, 2},
    {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 0.9, 0, 1, 0, 0, 1}, 1},
    {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0.1, 0, 0, 0.9, 0, 1, 0, 0, 1}, 1},
    {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0.1, 0.1, 0, 0.9, 0, 1, 0, 0, 1}, 1},
    {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 1, 1, 0, 1, 0, 1, 1}, 0},
    {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 1, 1, 0, 2, 0, 1, 1}, 0},
    {{0, 0, 0, 0, 1, 1, 0, 1, 0}, {-1, -1, 0, 0, -1, 0, -1, 0, 0}, 0},
};

// The same of the plane z = 0.
struct InPlane {
    double a[6], b[6];
    std::size_t corners;
};
constexpr InPlane in_plane[] = {
    {{0, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 1, 0}, 3},
    {{0, 0, 0, 1, 1, 0}, {0, 0, 0, 2, 2, 0}, 3},
    {{0, 0, 0, 1, 1, 0}, {0.25, 0.25, 0, 0.25, 0.25, 0}, 3},
    {{0, 0, 0, 1, 1, 0}, {0.5, 0.5, 0, 0.25, 0.25, 0}, 3},
    {{0, 0, 0, 1, 1, 0}, {0.25, 0.25, 0.25, 0.3, 0.3, 0.25}, 3},
    {{0, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 0.1, 0.1}, 3},
    {{0, 0, 0, 1, 1, 0}, {0, 0, 0, 0.9, 0.1, 0.1}, 3},
    {{0, 0, 0, 1, 1, 0}, {0, 0.1, 0, 0.9, 0.1, 0.1}, 3},
    {{0, 0, 0, 1, 1, 0}, {0, -1, 0.25, 0.25, 1, -1}, 3},
    {{0, 0, 0, 1, 1, 0}, {0, -1, 0, 0.25, 1, -1}, 3},
    {{0, 0, 0, 1, 1, 0}, {-1, -1, 0.25, 0.25, 0.25, -1}, 3},
    {{0, 0, 0.5, 1, 1, 0}, {-1, -1, 0.5, 0.5, 2, -1}, 3},
    {{0, 0, 0, 1, 1, 0}, {0, 0, -0.25, 0, 0, -0.25}, 1},
    {{0, 0, 0.1, 1, 1, 0.1}, {0, 0, -0.25, 0, 0, -0.25}, 1},
    {{0, 0, 0, 1, 1, 0}, {0, 0.1, -0.25, 0.1, -0.25, -0.1}, 1},
    {{0, 0, 0, 1, 1, 0}, {0, 0, 0, 1, -1, 0}, 2},
    {{0, 0, 0, 1, 1, 0}, {0, 0.1, 0, 0.9, -1, 0}, 2},
    {{0, 0, 0, 1, 1, 0}, {0, 0, 0, 0.9, -1, 0}, 2},
    {{0, 0, 0, 1, 1, 0}, {0, -0.1, 0, 0.9, -1, 0}, 2},
    {{-10, 0, 10, 0, 0, -3}, {-8, 0, 12, 0, 1, 5}, 2},
    {{0, 0, 1, 0, 0.5, 1.5}, {0, 1, 1, 1, 0.5, -0.5}, 6},
    {{0, 0, 1, 0, 0.5, 1}, {0, 1, 1, 1, 0.5, 0}, 4},
    {{0, 0, 1, 0, 0, 1}, {-0.1, 0.1, -0.1, 0.2, 0.5, 0.8}, 4},
    {{0, 0, 0, 1, 1, 0}, {-0.1, -0.1, -0.1, -0.9, -1, -0.1}, 0},
};

MeshShape triangle_of(const double (&t)[9]) {
    return triangle({t[0], t[1], t[2]}, {t[3], t[4], t[5]}, {t[6], t[7], t[8]});
}
MeshShape triangle_of(const double (&t)[6]) {
    return triangle({t[0], t[1], 0}, {t[2], t[3], 0}, {t[4], t[5], 0});
}

std::size_t shared_corners(const MeshShape& a, const MeshShape& b) {
    const auto shared = intersections({a, Pose{}}, {b, Pose{}});
    return shared.empty() ? 0 : shared[0].shared.corner_count;
}

template <class Rows>
void ask_shared(Expectations& expect, const Rows& rows) {
    for (const auto& row : rows) {
        const MeshShape a = triangle_of(row.a), b = triangle_of(row.b);
        expect.is(shared_corners(a, b), row.corners);
        expect.is(shared_corners(b, a), row.corners);
    }
}

// Triangles that meet the tetrahedron of the origin and the ends of the axes.
constexpr double in_tetrahedron[][9] = {
    {-1, -1, .5, -1, 2, .5, 2, -1, .5}, {0, 0, .5, .5, 0, .5, 0, .5, .5}, {1, 1, .5, .5, 0, .5, 0, .5, .5},
    {.2, .3, .5, 1, 1, 1, 2, 1, 1},     {-1, 0, 1, -1, 1, 0, 1, 0, -1},
};

// A thin one, from a mesh of the field, that is pierced.
constexpr double thin[4][3] = {{1.0962000000000001, 0.97450000000000003, -1.6817},
                               {0.70588000000000006, 0.83156000000000008, -1.3078650000000001},
                               {0.33200527798677881, 1.6713309295164104, -1.377130651507015},
                               {0.29692468967934992, 1.6547952284888936, -1.4200807988528463}};
constexpr double piercing[9] = {0.49939962361893036, 1.2953416022081787, -1.3461184494882023,
                                0.48104952476832690, 1.2841482485875793, -1.3695576366961846,
                                0.53749717115046513, 1.4500343543104133, -1.4988251058616823};

void ask_tetrahedra(Expectations& expect) {
    expect.from("triangles and a tetrahedron");
    const auto meet = [](const MeshShape& t, const ConvexSolid& solid) {
        return relation({t, Pose{}}, {solid, Pose{}}) != Relation::apart;
    };
    const ConvexSolid corner = hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    for (const auto& t : in_tetrahedron) expect.is(meet(triangle_of(t), corner), true);
    std::vector<Vec3> points;
    for (const auto& p : thin) points.emplace_back(p[0], p[1], p[2]);
    expect.is(meet(triangle_of(piercing), hull_of(points)), true);
}

}  // namespace

void ask(Expectations& expect) {
    expect.from("what triangles of two planes share");
    ask_shared(expect, in_space);
    expect.from("what triangles of one plane share");
    ask_shared(expect, in_plane);
    ask_tetrahedra(expect);
}

}  // namespace ecods::foreign::cgal
