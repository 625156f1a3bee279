// Flat convex solids beside the oracle: small sets of the lattice against each other, solids and half spaces, in both
// orders.
#include <gtest/gtest.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/hit.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "oracle/half_space.hpp"
#include "oracle/linear_program.hpp"
#include "oracle/solid.hpp"
#include "scenes/lattice_hull.hpp"
#include "scenes/pose_at.hpp"
#include "unit/query/expect_right.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

using scenes::Random;
using Exact = std::array<mpq_class, 3>;

// Each set of the families in convex_cases.hpp, and of these the flat ones.
bool has_flat(const scenes::ConvexCase& made) {
    return ConvexSolid(made.a.mesh).dimension() < 3 || ConvexSolid(made.b.mesh).dimension() < 3;
}

TEST(FlatJudged, EveryFamilyAsTheOracle) {
    std::map<std::string, int> kinds;
    QueryMemory memory;
    PairWitness witness;
    const auto only = [](std::string_view family) { return family == "flat sets" ? 1500 : 0; };
    scenes::for_each_case(scenes::convex_families(), 11, only, [&](const scenes::ConvexCase& made) {
        ASSERT_TRUE(has_flat(made));
        const judge::Judged<scenes::ConvexCase> judged(made);
        expect_right(made, judged, memory, witness, kinds);
        expect_none(judged.truth.ask_bounds(memory));
    });
    for (const char* kind :
         {"apart, vertex-vertex", "apart, vertex-edge", "apart, vertex-face", "apart, edge-edge", "deep, face of a",
          "deep, face of b", "deep, edges", "touching, face of a", "touching, face of b", "touching, edges"}) {
        EXPECT_GE(kinds[kind], 5) << kind;
    }
}

TEST(FlatJudged, EverywhereAsTheOracle) {
    const auto only = [](std::string_view family) { return family == "flat sets" ? 40 : 0; };
    scenes::for_each_case(scenes::convex_families(), 12, only, [&](const scenes::ConvexCase& made) {
        expect_right_everywhere(judge::Judged<scenes::ConvexCase>(made).truth);
    });
}

std::vector<Exact> posed_corners(const ConvexSolid& solid, const Pose& pose) {
    std::vector<Exact> points;
    for (const Vec3& v : solid.mesh().vertices()) points.push_back(oracle::exact_posed(v, pose));
    return points;
}

mpq_class determinant(const Exact& p, const Exact& q, const Exact& r, const Exact& s) {
    std::array<Exact, 3> rows;
    for (std::size_t k = 0; k < 3; ++k) {
        rows[0][k] = q[k] - p[k];
        rows[1][k] = r[k] - p[k];
        rows[2][k] = s[k] - p[k];
    }
    const auto& [x, y, z] = rows;
    return x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) + x[2] * (y[0] * z[1] - y[1] * z[0]);
}

bool are_in_one_plane(const std::vector<Exact>& a, const std::vector<Exact>& b) {
    std::vector<Exact> all = a;
    all.insert(all.end(), b.begin(), b.end());
    for (std::size_t i = 1; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            for (std::size_t k = j + 1; k < all.size(); ++k) {
                if (sgn(determinant(all[0], all[i], all[j], all[k])) != 0) return false;
            }
        }
    }
    return true;
}

// A point is in the relative interior of a hull if it is a combination of all points with positive weights. The largest
// t, at most 1, for which one point is a combination of each set with weights of at least t: negative or none if the
// hulls share no point, 0 if their relative interiors share none. The variables are 1 - t and what each weight exceeds
// t by.
Relation relation_of_hulls(const std::vector<Exact>& a, const std::vector<Exact>& b) {
    std::vector<oracle::Equation> equations;
    const std::size_t count = 1 + a.size() + b.size();
    const auto weighted = [&](const auto& of_a, const auto& of_b, const mpq_class& result) {
        oracle::Equation equation(count + 1);
        mpq_class sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += equation[1 + i] = of_a(a[i]);
        for (std::size_t i = 0; i < b.size(); ++i) sum += equation[1 + a.size() + i] = of_b(b[i]);
        equation[0] = -sum;
        equation[count] = result - sum;
        equations.push_back(equation);
    };
    const auto one = [](const Exact&) { return mpq_class(1); };
    const auto none = [](const Exact&) { return mpq_class(0); };
    for (std::size_t k = 0; k < 3; ++k) {
        weighted([&](const Exact& p) { return p[k]; }, [&](const Exact& q) { return mpq_class(-q[k]); }, 0);
    }
    weighted(one, none, 1);
    weighted(none, one, 1);
    const auto least = oracle::least_first_variable(equations);
    if (!least || *least > 1) return Relation::apart;
    return *least < 1 && !are_in_one_plane(a, b) ? Relation::crossing : Relation::touching;
}

// Distinct points of a small lattice.
std::vector<Vec3> some_points(int count, int size, bool is_in_plane, Random& random) {
    std::vector<Vec3> points;
    const auto any = [&] { return random.below(2 * static_cast<std::uint32_t>(size) + 1) - static_cast<double>(size); };
    while (static_cast<int>(points.size()) < count) points.push_back(Vec3(any(), any(), is_in_plane ? 0 : any()));
    return points;
}

// A set of dimension 0 to 2, in any plane of the lattice.
ConvexSolid flat_set(Random& random) {
    const int count = 1 + static_cast<int>(random.below(6));
    std::vector<Vec3> points = some_points(count, 2, count > 3, random);
    const double a = random.below(3) - 1.0, b = random.below(3) - 1.0;
    const auto first = static_cast<Eigen::Index>(random.below(3));
    for (Vec3& p : points) {
        if (count > 3) p.z() = a * p.x() + b * p.y();
        p = Vec3(p[first], p[(first + 1) % 3], p[(first + 2) % 3]).eval();
    }
    return ConvexSolid(std::span<const Vec3>(points));
}

Pose lattice_pose(Random& random) {
    Pose pose;
    pose.t = some_points(1, 2, false, random)[0];
    do {
        for (int k = 0; k < 3; ++k) pose.R.col(k) = some_points(1, 1, false, random)[0];
    } while (std::abs(pose.R.determinant()) < 0.5);
    return random.below(2) == 0 ? pose : at(pose.t);
}

TEST(FlatJudged, RelationsOfFlatSets) {
    Random random(5);
    std::map<Relation, int> often;
    for (int i = 0; i < 6000; ++i) {
        SCOPED_TRACE(i);
        const ConvexSolid a = flat_set(random), b = flat_set(random);
        ASSERT_LT(a.dimension(), 3);
        const Pose at_a = lattice_pose(random), at_b = lattice_pose(random);
        const Relation expected = relation_of_hulls(posed_corners(a, at_a), posed_corners(b, at_b));
        ++often[expected];
        ASSERT_EQ(relation(Posed<MeshShape>(a, at_a), Posed<MeshShape>(b, at_b)), expected);
        ASSERT_EQ(relation(Posed<MeshShape>(b, at_b), Posed<MeshShape>(a, at_a)), expected);
        ASSERT_EQ(intersects(Posed<MeshShape>(a, at_a), Posed<MeshShape>(b, at_b)), expected != Relation::apart);
        const auto deep = depth({a, at_a}, {b, at_b});
        ASSERT_EQ(deep.has_value(), expected != Relation::apart);
        ASSERT_EQ(deep && deep->depth == 0, expected == Relation::touching);
        // The first triangle of the other set alone, as a surface.
        const auto corners = b.mesh().triangles()[0];
        const MeshShape surface(Mesh::create(
            {b.mesh().vertices()[corners[0]], b.mesh().vertices()[corners[1]], b.mesh().vertices()[corners[2]]},
            {{0, 1, 2}}));
        std::vector<Exact> triangle;
        for (const std::uint32_t v : corners) {
            const Exact p = oracle::exact_posed(b.mesh().vertices()[v], at_b);
            if (std::ranges::find(triangle, p) == triangle.end()) triangle.push_back(p);
        }
        ASSERT_EQ(relation(Posed<MeshShape>(a, at_a), Posed<MeshShape>(surface, at_b)),
                  relation_of_hulls(posed_corners(a, at_a), triangle));
    }
    EXPECT_GE(often[Relation::apart], 500);
    EXPECT_GE(often[Relation::touching], 300);
    EXPECT_GE(often[Relation::crossing], 200);
}

oracle::Soup soup(const MeshShape& shape, const Pose& pose) {
    return {shape.mesh().vertices(), shape.mesh().triangles(), pose};
}

TEST(FlatJudged, RelationsToSolids) {
    Random random(6);
    std::map<Relation, int> often;
    for (int i = 0; i < 3000; ++i) {
        SCOPED_TRACE(i);
        const ConvexSolid flat = flat_set(random);
        const ConvexSolid hull(scenes::to_mesh(scenes::random_lattice_hull(3, 9, random), 1));
        const Solid general(hull.mesh_ptr());
        const Pose at_a = lattice_pose(random), at_b = lattice_pose(random);
        const Relation expected = oracle::surface_relation(soup(flat, at_a), soup(hull, at_b));
        ++often[expected];
        for (const MeshShape* const solid :
             {static_cast<const MeshShape*>(&hull), static_cast<const MeshShape*>(&general)}) {
            const Posed<MeshShape> a(flat, at_a), b(*solid, at_b);
            ASSERT_EQ(relation(a, b), expected);
            ASSERT_EQ(relation(b, a), swapped(expected));
            ASSERT_EQ(intersects(b, a), expected != Relation::apart);
            ASSERT_EQ(distance(a, b), distance(Posed<MeshShape>(hull, at_b), Posed<MeshShape>(flat, at_a)));
            ASSERT_EQ(distance(a, b) == 0, expected != Relation::apart);
        }
        const auto deep = depth({flat, at_a}, {hull, at_b});
        ASSERT_EQ(deep && deep->depth == 0, expected == Relation::touching);
    }
    for (const Relation relation : {Relation::apart, Relation::touching, Relation::crossing, Relation::inside}) {
        EXPECT_GE(often[relation], 20) << relation;
    }
}

TEST(FlatJudged, HalfSpaces) {
    Random random(7);
    std::map<Relation, int> often;
    for (int i = 0; i < 1500; ++i) {
        SCOPED_TRACE(i);
        const ConvexSolid flat = flat_set(random);
        Vec3 normal = some_points(1, 2, false, random)[0];
        if (normal.isZero(0)) normal.x() = 1;
        const HalfSpace half_space(normal, random.below(5) - 2.0);
        const Pose at_a = lattice_pose(random), at_b = lattice_pose(random);
        const oracle::ExactHeights heights({normal, half_space.offset(), at_b});
        const mpq_class low = oracle::lowest_corner(heights, flat.mesh(), at_a).height,
                        high = oracle::greatest_height(heights, flat.mesh(), at_a);
        const Relation expected = sgn(low) > 0     ? Relation::apart
                                  : sgn(low) == 0  ? Relation::touching
                                  : sgn(high) <= 0 ? Relation::inside
                                                   : Relation::crossing;
        ++often[expected];
        const Posed<MeshShape> a(flat, at_a);
        const Posed<HalfSpace> b(half_space, at_b);
        ASSERT_EQ(relation(a, b), expected);
        ASSERT_EQ(intersects(a, b), expected != Relation::apart);
        const double size = oracle::nearest(heights.distance(low));
        ASSERT_EQ(signed_distance(a, b).distance, sgn(low) < 0 ? -size : size);
    }
    for (const Relation relation : {Relation::apart, Relation::touching, Relation::crossing, Relation::inside}) {
        EXPECT_GE(often[relation], 30);
    }
}

// A point as a body, and the same as an argument.
TEST(FlatJudged, Points) {
    Random random(8);
    for (int i = 0; i < 3000; ++i) {
        SCOPED_TRACE(i);
        const ConvexSolid flat = flat_set(random);
        const Pose pose = lattice_pose(random);
        const Vec3 p = some_points(1, 3, false, random)[0];
        const ConvexSolid alone{std::span<const Vec3>(&p, 1)};
        const Posed<MeshShape> body(flat, pose), point(alone, Pose());
        const double d = signed_distance(p, body);
        ASSERT_EQ(d, distance(body, point));
        ASSERT_EQ(closest(p, body).distance, d);
        ASSERT_EQ(locate(p, {flat, pose}).side, d == 0 ? Side::on : Side::outside);
        const auto hit = first_hit(Ray{p, Vec3(1, 2, -1)}, body);
        ASSERT_EQ(hit.has_value() && hit->parameter == 0, d == 0);
    }
}

}  // namespace
}  // namespace ecods
