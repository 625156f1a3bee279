// The closest point of a segment, a triangle and a tetrahedron to a point (FCL, test/test_fcl_simple.cpp).
#include <bit>
#include <cmath>

#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"

namespace ecods::foreign::fcl_projections {
namespace {

// `square` is of the distance. The corners that the closest point is between, as bits, and its weights of them.
struct Projection {
    double p[3];
    double square;
    unsigned corners;
};
constexpr Projection onto_segment[] = {{{1, 0, 0}, 0, 3}, {{-1, 0, 0}, 1, 1}, {{3, 0, 0}, 1, 2}};
constexpr Projection onto_triangle[] = {{{1, 1, 1}, 4 / 3., 7}, {{0, 0, 1.5}, 0.25, 1}, {{1.5, 0, 0}, 0.25, 4},
                                        {{0, 1.5, 0}, 0.25, 2}, {{1, 1, 0}, 0.5, 6},    {{1, 0, 1}, 0.5, 5},
                                        {{0, 1, 1}, 0.5, 3}};
constexpr Projection onto_tetrahedron[] = {
    {{0, 0, 0}, 1 / 3., 7},       {{0, 1, 1}, 1 / 3., 11},      {{1, 1, 0}, 1 / 3., 14},
    {{1, 0, 1}, 1 / 3., 13},      {{1.5, 1.5, 1.5}, 0.75, 8},   {{1.5, -0.5, -0.5}, 0.75, 4},
    {{-0.5, -0.5, 1.5}, 0.75, 1}, {{-0.5, 1.5, -0.5}, 0.75, 2}, {{0.5, -0.5, 0.5}, 0.25, 5},
    {{0.5, 1.5, 0.5}, 0.25, 10},  {{1.5, 0.5, 0.5}, 0.25, 12},  {{-0.5, 0.5, 0.5}, 0.25, 3},
    {{0.5, 0.5, 1.5}, 0.25, 9},   {{0.5, 0.5, -0.5}, 0.25, 6}};

unsigned corners_of(const Mesh& mesh, const Feature& feature) {
    const Triangle& t = mesh.triangles()[feature.triangle];
    const std::uint32_t c = feature.corner;
    if (feature.kind == Feature::Kind::vertex) return 1u << t[c];
    if (feature.kind == Feature::Kind::edge) return 1u << t[c] | 1u << t[(c + 1) % 3];
    return 1u << t[0] | 1u << t[1] | 1u << t[2];
}

void check(Expectations& expect, const std::vector<Vec3>& corners, const std::vector<Triangle>& faces,
           std::span<const Projection> rows) {
    const MeshShape shape(Mesh::create(corners, faces));
    for (const Projection& row : rows) {
        const MeshShape p = point({row.p[0], row.p[1], row.p[2]});
        const ClosestPoints closest = ecods::closest({p, Pose{}}, {shape, Pose{}});
        expect.near(closest.distance, std::sqrt(row.square), 0x1p-50);
        if (closest.kind == ClosestKind::intersecting) continue;  // features are of triangles then
        expect.is(corners_of(shape.mesh(), closest.b), row.corners);
        // Of every row the weights are equal.
        Vec3 mean = Vec3::Zero();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if ((row.corners >> i & 1) != 0) mean += corners[i] / std::popcount(row.corners);
        }
        for (int k = 0; k < 3; ++k) expect.near(closest.point_b[k], mean[k], 0x1p-50);
    }
}

}  // namespace

void ask(Expectations& expect) {
    expect.from("projection_test_line");
    check(expect, {{0, 0, 0}, {2, 0, 0}}, {{0, 1, 1}}, onto_segment);
    expect.from("projection_test_triangle");
    const std::vector<Vec3> corners{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}};
    check(expect, {corners[0], corners[1], corners[2]}, {{0, 1, 2}}, onto_triangle);
    expect.from("projection_test_tetrahedron");
    check(expect, corners, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}, onto_tetrahedron);
    const ConvexSolid solid = hull_of(corners);
    expect.is(locate({0.5, 0.5, 0.5}, {solid, Pose{}}).side == Side::inside, true);
}

}  // namespace ecods::foreign::fcl_projections
