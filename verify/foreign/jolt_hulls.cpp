// Convex hulls (Jolt, UnitTests/Geometry/ConvexHullBuilderTest.cpp).
#include <cmath>

#include "ecods/error.hpp"
#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"
#include "scenes/random.hpp"

namespace ecods::foreign::jolt_hulls {
namespace {

int dimension_of(const std::vector<Vec3>& points) {
    return hull_of(points).dimension();
}

void ask_flat(Expectations& expect) {
    expect.from("TestDegenerate");
    std::vector<Vec3> points{{1, 2, 3}};
    for (int k = 0; k < 3; ++k) {
        expect.is(dimension_of(points), k);
        points.push_back(points[0] + 0.5e-3 * Vec3::Unit(k));
    }
    // The source calls these four degenerate: they are nearer than its tolerance of 1e-3. Their volume is 1.25e-10 / 6,
    // not 0: a tetrahedron.
    expect.is(dimension_of(points), 3);
    std::vector<Vec3> line;
    for (int i = 0; i < 11; ++i) line.emplace_back(0.1 * i, 0, 0);
    expect.is(dimension_of(line), 1);

    // The source makes polygons of these.
    expect.from("Test2DHull");
    expect.is(dimension_of({{-1, 0, -1}, {1, 0, -1}, {-1, 0, 1}}), 2);
    std::vector<Vec3> grid;
    for (int i = 0; i < 100; ++i) grid.emplace_back(0.1 * (i / 10), 0, 0.2 * (i % 10));
    expect.is(dimension_of(grid), 2);
    std::vector<Vec3> disc;
    for (int i = 0; i < 100; ++i) {
        disc.emplace_back(2 * (i / 10) * std::cos(pi / 5 * (i % 10)), 2 * (i / 10) * std::sin(pi / 5 * (i % 10)), 0);
    }
    expect.is(dimension_of(disc), 2);
}

// All points are in the hull; the source allows some to be 1.2e-3 outside.
void check_hull(Expectations& expect, const std::vector<Vec3>& points) {
    const ConvexSolid hull = hull_of(points);
    for (const Vec3& p : points) expect.is(locate(p, {hull, Pose{}}).side != Side::outside, true);
    expect.is(hull.mesh().triangles().size(), 2 * hull.mesh().vertices().size() - 4);
}

void ask_grid(Expectations& expect) {
    expect.from("Test3DHull");
    std::vector<Vec3> points;
    for (int i = 0; i < 1000; ++i) {
        const float x = 0.1f * static_cast<float>(i / 100), y = 1.0f + 0.2f * static_cast<float>(i / 10 % 10),
                    z = 2.0f * 0.3f * static_cast<float>(i % 10);
        points.emplace_back(x, y, z);
    }
    const auto hull = convex_hull(points);
    expect.is(hull->vertices().size(), std::size_t{8});
    expect.is(hull->triangles().size(), std::size_t{12});  // two for each of the six faces
    for (const std::size_t corner : {0u, 9u, 90u, 99u, 900u, 909u, 990u, 999u}) {
        expect.is(std::ranges::find(hull->vertices(), points[corner]) != hull->vertices().end(), true);
    }
    check_hull(expect, points);
}

// Points, points near them, points on lines between them, and points near those.
void ask_random(Expectations& expect) {
    expect.from("TestRandomHull");
    scenes::Random random(0x1ee7c0de);
    for (int i = 0; i < 10; ++i) {
        const double start = random.uniform(0.1, 0.5), range = random.uniform(0.1, 2);
        const Vec3 scale(random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1));
        std::vector<Vec3> points;
        const auto near = [&](const Vec3& p) {
            points.push_back(p);
            points.push_back(p + 1e-3 * random.uniform(0, 2) * random.direction());
        };
        for (int k = 0; k < 50; ++k) {
            const Vec3 p = (random.uniform(start, start + range) * random.direction()).cwiseProduct(scale);
            near(p);
            const double part = random.uniform(0, 1);
            near(part * p + (1 - part) * points[random.below(static_cast<std::uint32_t>(points.size()))]);
        }
        check_hull(expect, points);
    }
}

constexpr float two_faces[][3] = {
    {-0.020472288f, -0.195635557f, 0.308015466f}, {0.136248738f, 0.633286834f, 0.135366619f},
    {0.286418647f, -0.228475571f, 0.308084548f},  {-0.267285109f, 1.024676085f, 0.308042824f},
    {0.396568149f, -0.971658647f, 0.308055162f},  {0.321081549f, -1.024676085f, 0.308036327f},
    {0.034643859f, -0.404506862f, 0.308015764f},  {0.189224690f, -0.252762139f, 0.308060408f}};
constexpr float nearly_coplanar[][3] = {
    {0.917345762f, 0.157111734f, 1.650970459f},   {-0.098074198f, 0.157116055f, 0.664742708f},
    {1.777100325f, 0.157112047f, 1.238879442f},   {2.114324570f, 0.157112464f, 0.780688763f},
    {1.926570415f, 0.157114446f, 0.240761161f},   {-1.045998096f, 0.157108605f, 1.548911095f},
    {-1.820045233f, 0.157106474f, 1.050360918f},  {-1.918573976f, 0.157108605f, 0.039246202f},
    {0.042619467f, 0.157113969f, -1.405336142f},  {0.575986624f, 0.157114401f, -1.370834589f},
    {1.402592659f, 0.157115221f, -0.834864557f},  {1.110557318f, 0.157113969f, -1.336267948f},
    {1.689781666f, 0.157115355f, -0.308773756f},  {2.205337524f, 0.157113209f, -0.281754494f},
    {-1.346967936f, 0.157110974f, -0.978962541f}, {-2.085033417f, 0.157106936f, -0.506602883f},
    {-0.981224537f, 0.157110706f, -1.445893764f}, {-0.481085658f, 0.157112658f, -1.426232934f}};

template <class Points>
std::vector<Vec3> points_of(const Points& points) {
    std::vector<Vec3> result;
    for (const auto& p : points) result.emplace_back(p[0], p[1], p[2]);
    return result;
}

}  // namespace

void ask(Expectations& expect) {
    ask_flat(expect);
    ask_grid(expect);
    ask_random(expect);
    expect.from("TestHullEdgeCases");
    check_hull(expect, points_of(two_faces));
    check_hull(expect, points_of(nearly_coplanar));
}

}  // namespace ecods::foreign::jolt_hulls
