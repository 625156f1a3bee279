// Boxes, prisms, height fields and clouds: known answers, and volumes in rational numbers.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "ecods/builders.hpp"
#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"

namespace ecods {
namespace {

using scenes::Random;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Six times the volume that the triangles enclose; positive if they are turned outwards.
mpq_class volume_of(const Mesh& mesh) {
    mpq_class sum = 0;
    const auto v = mesh.vertices();
    for (const Triangle& t : mesh.triangles()) {
        const auto x = [&](std::size_t corner, int axis) { return mpq_class(v[t[corner]][axis]); };
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            sum += x(0, k) * (x(1, i) * x(2, j) - x(1, j) * x(2, i));
        }
    }
    return sum;
}

std::size_t index_of(const std::vector<Vec2>& polygon) {
    try {
        static_cast<void>(prism(polygon, 1));
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.argument, Argument::polygon);
        return error.index.value();
    }
    ADD_FAILURE();
    return 0;
}

TEST(Box, IsExact) {
    for (const Vec3& sizes : {Vec3(1, 2, 3), Vec3(0.1, 0.7, 1e-300), Vec3(0x1p500, 0x1p-500, 1), Vec3(0x1p1023, 1, 1),
                              Vec3(0x1p-1073, 0x1p-1021, 3 * 0x1p-1022)}) {
        const auto solid = box(sizes);
        EXPECT_EQ(volume_of(solid->mesh()), 6 * mpq_class(sizes[0]) * mpq_class(sizes[1]) * mpq_class(sizes[2]));
        EXPECT_EQ(solid->mesh().vertices().size(), 8u);
        for (const Vec3& v : solid->mesh().vertices()) {
            for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(2 * std::abs(v[axis]), sizes[axis]);
        }
    }
    for (const double bad : {0.0, -1.0, infinity, std::nan(""), 0x1p-1074, 3 * 0x1p-1074}) {
        EXPECT_INVALID(box({1, bad, 1}), Argument::size);
    }
    const auto cube = box({1, 1, 1});
    EXPECT_EQ(distance({cube, Pose{}}, {cube, {.t = {4, 0, 0}}}), 3);
    EXPECT_EQ(depth({cube, Pose{}}, {cube, {.t = {0.75, 0, 0}}})->depth, 0.25);
}

TEST(Prism, IsExact) {
    const std::vector<Vec2> triangle{{0, 0}, {3, 0}, {0, 0.1}};
    EXPECT_EQ(volume_of(prism(triangle, 5)->mesh()), 6 * (3 * mpq_class(0.1) / 2) * 5);
    const std::vector<Vec2> clockwise(triangle.rbegin(), triangle.rend());
    EXPECT_EQ(volume_of(prism(clockwise, 5)->mesh()), volume_of(prism(triangle, 5)->mesh()));
    // Points in sides, and points again.
    const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}, {0, 2}, {0, 1}, {0, 0}};
    const auto solid = prism(square, 2);
    EXPECT_EQ(solid->mesh().vertices().size(), 8u);
    EXPECT_EQ(volume_of(solid->mesh()), 6 * 8);
    EXPECT_EQ(locate({1, 1, 1}, {solid, Pose{}}).side, Side::on);
    EXPECT_EQ(locate({1, 1, -0.5}, {solid, Pose{}}).side, Side::inside);
}

// Regular polygons, begun anywhere and in both senses, are convex; as stars, or with a point pushed in, they are not.
TEST(Prism, RefusesWhatIsNotConvex) {
    Random random(1);
    for (const std::size_t sides : {5u, 7u, 12u}) {
        for (std::size_t first = 0; first < sides; ++first) {
            std::vector<Vec2> regular, star;
            for (std::size_t k = 0; k < sides; ++k) {
                const auto at = [&](std::size_t i) {
                    const double angle = 2 * M_PI * static_cast<double>(i % sides) / static_cast<double>(sides);
                    return Vec2(std::cos(angle), std::sin(angle));
                };
                regular.push_back(at(first + k));
                star.push_back(at(5 * (first + k) % 12 == 0 ? 5 * (first + k) : 2 * (first + k)));
            }
            EXPECT_NO_THROW(static_cast<void>(prism(regular, 1)));
            if (sides % 2 == 1) {
                EXPECT_GE(index_of(star), 1u);
            }
            std::vector<Vec2> dented = regular;
            const std::size_t pushed = random.below(static_cast<std::uint32_t>(sides));
            dented[pushed] *= 0.2;
            const std::size_t named = index_of(dented);
            // It is the point, or one beside it: which turn is the odd one depends on where the polygon begins.
            EXPECT_TRUE(named == pushed || named == (pushed + 1) % sides || named == (pushed + 2) % sides) << named;
            if (pushed > 1) {
                EXPECT_EQ(named, pushed);
            }
        }
    }
    EXPECT_EQ(index_of({{0, 0}, {4, 0}, {4, 4}, {2, 3}, {0, 4}}), 3u);
    EXPECT_EQ(index_of({{0, 0}, {3, 0}, {2, 0}, {2, 2}, {0, 2}}), 3u);  // goes back on a side
    EXPECT_GE(index_of({{0, 0}, {2, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}), 1u);
    EXPECT_GE(index_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}}), 1u);  // twice around
    EXPECT_INVALID(prism(std::vector<Vec2>{}, 1), NotSolid::Reason::no_interior);
    EXPECT_INVALID(prism(std::vector<Vec2>{{0, 0}, {1, 1}, {3, 3}, {2, 2}}, 1), NotSolid::Reason::no_interior);
    const std::vector<Vec2> triangle{{0, 0}, {1, 0}, {0, 1}};
    EXPECT_INVALID(prism(triangle, 0), Argument::size);
    try {
        static_cast<void>(prism(std::vector<Vec2>{{0, 0}, {1, 0}, {0, infinity}}, 1));
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.argument, Argument::point);
        EXPECT_EQ(error.index, 2u);
        EXPECT_EQ(error.part, "(1)");
    }
}

TEST(HeightField, IsTheSurfaceAndTheSolidBelow) {
    Random random(2);
    for (const std::size_t columns : {2u, 3u, 4u, 7u}) {
        for (const std::size_t rows : {2u, 3u, 4u, 6u}) {
            SCOPED_TRACE(std::to_string(columns) + " x " + std::to_string(rows));
            std::vector<double> heights;
            for (std::size_t k = 0; k < columns * rows; ++k) heights.push_back(random.uniform(-1, 1));
            const Vec2 spacing(0.1, 3);
            const auto surface = height_field(heights, columns, spacing);
            const auto v = surface->mesh().vertices();
            ASSERT_EQ(v.size(), heights.size());
            for (std::size_t k = 0; k < v.size(); ++k) {
                const auto i = static_cast<double>(k % columns), j = static_cast<double>(k / columns);
                EXPECT_EQ(v[k], Vec3(0.1 * i, 3 * j, heights[k]));
            }
            ASSERT_EQ(surface->mesh().triangles().size(), 2 * (columns - 1) * (rows - 1));
            const auto solid = height_field(heights, columns, spacing, -1.5);
            EXPECT_TRUE(std::ranges::equal(v, solid->mesh().vertices().first(v.size())));
            const auto t = surface->mesh().triangles();
            EXPECT_TRUE(std::ranges::equal(t, solid->mesh().triangles().first(t.size())));
            // The prisms below the triangles.
            mpq_class sum = 0;
            for (const Triangle& each : t) {
                const auto x = [&](std::size_t corner, int axis) { return mpq_class(v[each[corner]][axis]); };
                const mpq_class area =
                    (x(1, 0) - x(0, 0)) * (x(2, 1) - x(0, 1)) - (x(2, 0) - x(0, 0)) * (x(1, 1) - x(0, 1));
                EXPECT_GT(area, 0);
                sum += area * (x(0, 2) + x(1, 2) + x(2, 2) + mpq_class(4.5));
            }
            EXPECT_EQ(volume_of(solid->mesh()), sum);
            EXPECT_EQ(locate({0.05, 1, -1.25}, {solid, Pose{}}).side, Side::inside);
            EXPECT_EQ(locate({0.05, 1, -1.5}, {solid, Pose{}}).side, Side::on);
            EXPECT_EQ(locate({0.05, 1, 1.5}, {solid, Pose{}}).side, Side::outside);
        }
    }
}

TEST(HeightField, RefusesWhatIsNoGrid) {
    const std::vector<double> six(6, 1.0);
    EXPECT_INVALID(height_field(six, 0, Vec2(1, 1)), Argument::count);
    EXPECT_INVALID(height_field(six, 1, Vec2(1, 1)), Argument::count);
    EXPECT_INVALID(height_field(six, 4, Vec2(1, 1)), Argument::count);
    EXPECT_INVALID(height_field(six, 6, Vec2(1, 1)), Argument::count);
    EXPECT_INVALID(height_field({}, 2, Vec2(1, 1)), Argument::count);
    EXPECT_INVALID(height_field(six, 2, Vec2(1, 0)), Argument::size);
    EXPECT_INVALID(height_field(six, 2, Vec2(infinity, 1)), Argument::size);
    EXPECT_INVALID(height_field(six, 2, Vec2(1, 0x1p1023)), Argument::size);
    EXPECT_NO_THROW(static_cast<void>(height_field(six, 2, Vec2(1, 0x1p1022))));
    EXPECT_NO_THROW(static_cast<void>(height_field(six, 2, Vec2(0x1p-1074, 0x1p-1074), 0.5)));
    EXPECT_INVALID(height_field(six, 2, Vec2(1, 1), std::nan("")), Argument::size);
    std::vector<double> low = six;
    low[4] = 0.25;
    EXPECT_NO_THROW(static_cast<void>(height_field(low, 2, Vec2(1, 1), 0.125)));
    try {
        static_cast<void>(height_field(low, 2, Vec2(1, 1), 0.25));
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.part, "base");
        EXPECT_EQ(error.index, 4u);
    }
    low[3] = std::nan("");
    try {
        static_cast<void>(height_field(low, 2, Vec2(1, 1), 0));
        FAIL();
    } catch (const InvalidMesh& error) {
        EXPECT_EQ(error.vertex, 3u);
        EXPECT_EQ(error.axis, 2);
    }
}

TEST(PointCloud, IsItsPoints) {
    const std::vector<Vec3> points{{0, 0, 0}, {5, 0, 0}, {0, 3, 4}, {0, 0, 0}};
    const auto cloud = point_cloud(points);
    EXPECT_EQ(cloud->mesh().triangles().size(), 4u);
    EXPECT_EQ(cloud->mesh().triangles()[2], (Triangle{2, 2, 2}));
    const auto cube = box({2, 2, 2});
    const Posed<MeshShape> posed{cloud, Pose{}};
    const ClosestPoints closest_to = closest(posed, {cube, {.t = {5, 3, 0}}});
    EXPECT_EQ(closest_to.distance, 2);
    EXPECT_EQ(closest_to.point_a, Vec3(5, 0, 0));
    EXPECT_EQ(closest_to.a.triangle, 1u);
    EXPECT_TRUE(intersects(posed, {cube, {.t = {0, 3, 5}}}));
    EXPECT_FALSE(intersects(posed, {cube, {.t = {2.5, 0, 0}}}));
    EXPECT_INVALID(point_cloud({}), InvalidMesh::Reason::empty);
    EXPECT_INVALID(point_cloud(std::vector<Vec3>{{0, 0, 0}, {0, infinity, 0}}), InvalidMesh::Reason::vertex);
}

}  // namespace
}  // namespace ecods
