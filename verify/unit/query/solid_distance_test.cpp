#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "environment/each_environment.hpp"
#include "query/convex/posed_hulls.hpp"
#include "scenes/random.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

// An integer in two's complement, rounded.
template <std::size_t L>
double leading(const std::array<std::uint64_t, L>& limbs) {
    const auto size = exact::magnitude<static_cast<int>(L)>(limbs);
    double result = 0;
    for (std::size_t i = L; i-- > 0;) result = result * 0x1p64 + static_cast<double>(size.limbs[i]);
    return size.negative != 0 ? -result : result;
}

ConvexSolid hull_of(scenes::Random& random, int count, const Vec3& axes = {1, 1, 1}) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.push_back(random.direction().cwiseProduct(axes));
    return ConvexSolid{std::span<const Vec3>(points)};
}

Posed<MeshShape> surface_at(const Posed<ConvexSolid>& body) {
    return {*surface_of(*body.what), body.pose};
}

// The distance of solids by the questions about surfaces and relations.
double expected_distance(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory) {
    return relation(a, b, memory) == Relation::apart ? distance(surface_at(a), surface_at(b), memory) : 0;
}

// Compares with the surfaces' distance and closest points; these are unique but for ties.
void expect_right(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory) {
    const double expected = expected_distance(a, b, memory);
    EXPECT_EQ(distance(a, b, memory), expected);
    EXPECT_EQ(distance(b, a, memory), expected);
    const ClosestPoints points = closest(a, b, memory);
    EXPECT_EQ(points.distance, expected);
    ASSERT_EQ(points.kind<ClosestKind::intersecting, expected> 0);
    if (points.kind >= ClosestKind::intersecting) return;
    // Boxes of one triangle each face, and hulls of triangles alone, have the same features as their meshes, unless
    // points are on a diagonal.
    const ClosestPoints surface = closest(surface_at(a), surface_at(b), memory);
    if (surface.kind == ClosestKind::vertex_vertex || points.kind == ClosestKind::vertex_vertex) {
        EXPECT_EQ(surface.kind, points.kind);
        EXPECT_EQ(surface.a, points.a);
        EXPECT_EQ(surface.b, points.b);
    }
    if (surface.kind == points.kind && surface.a == points.a && surface.b == points.b) {
        EXPECT_EQ(points.point_a, surface.point_a);
        EXPECT_EQ(points.point_b, surface.point_b);
    }
    for (const PairWitness& any : {PairWitness{0, 0}, {3, 2}, {1000, 2}, {PairWitness::none, 5}}) {
        PairWitness witness = any;
        EXPECT_EQ(distance(a, b, {memory, witness}), expected);
        witness = any;
        const ClosestPoints other = closest(a, b, {memory, witness});
        EXPECT_EQ(other.kind, points.kind);
        EXPECT_EQ(other.a, points.a);
        EXPECT_EQ(other.b, points.b);
        EXPECT_EQ(other.point_a, points.point_a);
    }
}

TEST(SolidDistance, OfHulls) {
    scenes::Random random(1);
    QueryMemory memory;
    for (int i = 0; i < 60; ++i) {
        const ConvexSolid a = hull_of(random, 4 + i), b = hull_of(random, 40, {2, 1, 0.01});
        for (int k = 0; k < 10; ++k) {
            Pose p = random.turned(), q = random.turned();
            q.t = random.direction() * random.uniform(0, 5);
            if (k % 3 == 0) q.R.row(0) *= -1;
            expect_right({a, p}, {b, q}, memory);
        }
    }
}

TEST(SolidDistance, NearContact) {
    scenes::Random random(2);
    QueryMemory memory;
    for (int i = 0; i < 40; ++i) {
        const ConvexSolid a = hull_of(random, 32), b = hull_of(random, 32);
        Pose p = random.turned(), q = random.turned();
        const Vec3 way = random.direction();
        for (int round = 0; round < 60; ++round) {
            const double gap = distance({a, p}, {b, q}, memory);
            q.t += gap > 0 ? Vec3(-gap * way) : Vec3(std::ldexp(1.0, -round) * way);
            expect_right({a, p}, {b, q}, memory);
        }
    }
}

// Every one of 5^3 places of a box of a lattice about another one: ties of all kinds.
TEST(SolidDistance, OfBoxesOnALattice) {
    QueryMemory memory;
    const ConvexSolid a(box({0, 0, 0}, {2, 2, 2})), b(box({0, 0, 0}, {1, 2, 3})), c(box({0, 0, 0}, {1, 2, 3}, 3));
    for (int x = -4; x <= 4; ++x) {
        for (int y = -4; y <= 4; ++y) {
            for (int z = -4; z <= 4; ++z) {
                Pose q;
                q.t = Vec3(x, y, z);
                const double expected = std::sqrt(std::pow(std::max({0.0, x - 2.0, -x - 1.0}), 2) +
                                                  std::pow(std::max({0.0, y - 2.0, -y - 2.0}), 2) +
                                                  std::pow(std::max({0.0, z - 2.0, -z - 3.0}), 2));
                for (const ConvexSolid* other : {&b, &c}) {
                    EXPECT_EQ(distance({a, {}}, {*other, q}, memory), expected);
                    EXPECT_EQ(closest({a, {}}, {*other, q}, memory).kind<ClosestKind::intersecting, expected> 0);
                }
                if (expected > 0) expect_right({a, {}}, {b, q}, memory);
            }
        }
    }
}

TEST(SolidDistance, Names) {
    QueryMemory memory;
    const ConvexSolid a(box({0, 0, 0}, {2, 2, 2})), b(box({0, 0, 0}, {1, 1, 1}, 2));
    Pose above;
    above.t = Vec3(0.5, 0.5, 3);
    ClosestPoints points = closest({a, {}}, {b, above}, memory);
    EXPECT_EQ(points.kind, ClosestKind::vertex_face);
    EXPECT_EQ(points.a.kind, Feature::Kind::face);
    EXPECT_EQ(points.point_b, points.point_a + Vec3(0, 0, 1));
    above.t = Vec3(2, 0, 3);  // in line with an edge: two vertices of b are over vertices of none, or on an edge
    points = closest({a, {}}, {b, above}, memory);
    EXPECT_EQ(points.kind, ClosestKind::vertex_vertex);
    above.t = Vec3(2, 0.5, 3);
    points = closest({a, {}}, {b, above}, memory);
    EXPECT_EQ(points.kind, ClosestKind::vertex_edge);
    // Two boards across each other.
    const ConvexSolid c(box({-5, 0, 0}, {5, 1, 1})), d(box({0, -5, 0}, {1, 5, 1}));
    Pose over;
    over.t = Vec3(0, 0, 2);
    points = closest({c, {}}, {d, over}, memory);
    EXPECT_EQ(points.kind, ClosestKind::edge_edge);
    EXPECT_EQ(points.distance, 1);
}

TEST(SolidDistance, AtAnyScale) {
    scenes::Random random(3);
    QueryMemory memory;
    const ConvexSolid a = hull_of(random, 20), b = hull_of(random, 20);
    std::vector<Vec3> small, large;
    for (int i = 0; i < 12; ++i) {
        small.push_back(random.direction() * 0x1p-900);
        large.push_back(random.direction() * 0x1p900);
    }
    const ConvexSolid tiny{std::span<const Vec3>(small)}, huge{std::span<const Vec3>(large)};
    for (const int exponent : {-1060, -900, -500, -101, 101, 500, 900}) {
        Pose p, q;
        p.R = random.rotation().toRotationMatrix() * std::ldexp(1.0, exponent);
        q.R = random.rotation().toRotationMatrix() * std::ldexp(1.0, exponent);
        for (const double far : {0.1, 1.0, 3.0, 100.0}) {
            q.t = random.direction() * far * std::ldexp(1.0, exponent);
            expect_right({a, p}, {b, q}, memory);
            expect_right({a, p}, {a, q}, memory);
            expect_right({tiny, p}, {b, q}, memory);
            expect_right({a, p}, {tiny, q}, memory);
            if (exponent < 100) expect_right({huge, p}, {b, q}, memory);
        }
    }
}

// A positive distance is at least 2^-1074, however little of it there is: boxes of integers times 2^-1074 under a pose
// that divides by 16.
TEST(SolidDistance, BelowTheLeastDouble) {
    QueryMemory memory;
    const double least = std::numeric_limits<double>::denorm_min();
    const ConvexSolid a(box(Vec3(0, 0, 0), 8 * least * Vec3(1, 1, 1)));
    const ConvexSolid b(box(least * Vec3(2, 2, 9), 8 * least * Vec3(1, 1, 2)));
    Pose p;
    p.R *= 0x1p-4;
    EXPECT_EQ(distance({a, p}, {b, p}, memory), least);
    EXPECT_EQ(closest({a, p}, {b, p}, memory).distance, least);
    p.R << 3, 1, 0, -1, 3, 0, 0, 1, 4;
    p.R *= 0x1p-5;
    EXPECT_EQ(distance({a, p}, {b, p}, memory), least);
}

// At a singular pose a solid is the image of its surface. One coordinate of the box is 0 there, so all is known.
TEST(SolidDistance, SingularPoses) {
    QueryMemory memory;
    const ConvexSolid a(box({-1, -1, -1}, {1, 1, 1})), small(box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
    Pose flat, off;
    flat.R(2, 2) = 0;
    const auto expect = [&](const Posed<ConvexSolid>& x, const Posed<ConvexSolid>& y, double expected,
                            ClosestKind kind) {
        for (const auto& [first, second] : {std::pair(&x, &y), {&y, &x}}) {
            PairWitness witness;
            for (int round = 0; round < 3; ++round) {
                const Ask ask(memory, witness);
                EXPECT_EQ(distance(*first, *second, ask), expected);
                EXPECT_EQ(intersects(*first, *second, ask), expected == 0);
                EXPECT_EQ(closest(*first, *second, ask).kind, kind);
                EXPECT_EQ(closest(*first, *second, ask).distance, expected);
            }
        }
    };
    expect({a, flat}, {a, {}}, 0, ClosestKind::intersecting);   // across the cube's middle
    expect({small, flat}, {a, {}}, 0, ClosestKind::contained);  // inside it
    off.t = Vec3(0, 0, 3);
    expect({a, flat}, {a, off}, 2, ClosestKind::vertex_vertex);
    Pose above = flat;
    above.t = Vec3(0, 0, 3);
    expect({a, flat}, {a, above}, 3, ClosestKind::vertex_vertex);  // two squares
    Pose point;
    point.R.setZero();
    expect({a, point}, {a, {}}, 0, ClosestKind::contained);
    expect({a, point}, {a, point}, 0, ClosestKind::intersecting);
    expect({a, point}, {a, off}, 2, ClosestKind::vertex_edge);  // a diagonal of the face, cut into triangles
    expect({a, point}, {a, flat}, 0, ClosestKind::intersecting);
    Pose skewed;
    skewed.R << 1, 2, 3, 4, 5, 6, 7, 8, 9;  // of rank 2
    skewed.t = Vec3(0, 0, 100);
    const double apart = distance({a, skewed}, {a, {}}, memory);
    EXPECT_EQ(apart, distance(surface_at({a, skewed}), surface_at({a, {}}), memory));
    EXPECT_GT(apart, 0);
}

TEST(SolidDistance, OfLargeHulls) {
    scenes::Random random(5);
    QueryMemory memory;
    const ConvexSolid a = hull_of(random, 900), b = hull_of(random, 500, {1, 3, 2});
    for (int i = 0; i < 40; ++i) {
        Pose p = random.turned(), q;
        q.t = random.direction() * random.uniform(1, 6);
        expect_right({a, p}, {b, q}, memory);
    }
}

// Every pose of one pair near contact, deep, far, and of any size, wherever the question is asked.
TEST(SolidDistance, TheSameInEveryEnvironment) {
    scenes::Random random(6);
    QueryMemory memory;
    const ConvexSolid a = hull_of(random, 30), b = hull_of(random, 30), c(box({-1, -1, -1}, {1, 1, 1}, 2));
    for (const int exponent : {0, -1040, -600, 700}) {
        for (int i = 0; i < 6; ++i) {
            Pose p, q;
            p.R = random.rotation().toRotationMatrix() * std::ldexp(1.0, exponent);
            q.R = i % 4 == 0 ? p.R : Mat3(random.rotation().toRotationMatrix() * std::ldexp(1.0, exponent));
            q.t = random.direction() * (i % 3 == 0 ? 2.5 : 1.5) * std::ldexp(1.0, exponent);
            for (const auto& [first, second] : {std::pair(&a, &b), {&c, &c}, {&a, &c}}) {
                Pose near = q;  // some halves of the way from where they meet to where they do not
                for (int k = 0; k < 8; ++k) {
                    const Posed<ConvexSolid> x(*first, p), y(*second, near);
                    const auto ask = [&] {
                        PairWitness witness;
                        const ClosestPoints points = closest(x, y, {memory, witness});
                        std::vector<double> all{distance(x, y, memory), distance(y, x, {memory, witness})};
                        for (const Vec3& point : {points.point_a, points.point_b}) {
                            all.insert(all.end(), {point[0], point[1], point[2]});
                        }
                        for (const std::uint32_t n : {points.a.triangle, points.a.corner, points.b.triangle,
                                                      points.b.corner, static_cast<std::uint32_t>(points.kind)}) {
                            all.push_back(n);
                        }
                        return all;
                    };
                    const auto expected = ask();
                    environment::in_each_environment(ask, [&](const auto& answer, const std::string& where) {
                        EXPECT_EQ(answer, expected) << where << ", 2^" << exponent << ", pose " << i << ", step " << k;
                    });
                    near.t -= near.t * (expected[0] > 0 ? 0.25 : -0.125);
                }
            }
        }
    }
}

// Counted from the first of them, rounded points are where integers are, up to twice the bound.
TEST(PosedHulls, BoundsOfRoundedPoints) {
    using namespace convex;
    scenes::Random random(8);
    QueryMemory memory;
    const ConvexSolid a = hull_of(random, 30), b = hull_of(random, 200, {1, 2, 0.1});
    for (const int exponent : {0, -1030, -700, 99, 600}) {
        Pose p, q;
        p.R = random.rotation().toRotationMatrix() * std::ldexp(1.0, exponent);
        q.R = -random.rotation().toRotationMatrix() * std::ldexp(1.0, exponent);
        q.t = random.direction() * std::ldexp(1.0, exponent);
        const Posed<ConvexSolid> x(a, p), y(b, q);
        PosedHulls hulls(x, y, memory);
        EXPECT_FALSE(hulls.is_mirrored(0));
        EXPECT_TRUE(hulls.is_mirrored(1));
        const Point first = hulls.rounded(0, 0);
        for (const std::size_t side : {0, 1}) {
            for (std::uint32_t v = 0; v < hulls.hull(side).vertex_count(); ++v) {
                const Point at = hulls.rounded(side, v);
                const auto exact =
                    hulls.with_integers(std::array{HullVertex{0, 0}, HullVertex{side, v}}, [](const auto& points) {
                        Point difference;
                        const auto limbs = exact::to_limbs(points);
                        for (std::size_t k = 0; k < 3; ++k) {
                            difference[k] = std::ldexp(leading(limbs[1][k]), points.unit);
                        }
                        return difference;
                    });
                for (std::size_t k = 0; k < 3; ++k) {
                    const double rounded = std::ldexp(at[k] - first[k], hulls.exponent());
                    const double bound = std::ldexp(2.5 * hulls.delta(), hulls.exponent());
                    EXPECT_LE(std::abs(rounded - exact[k]), bound + 0x1p-1073);
                }
            }
        }
        // A climb ends where no other vertex is further, as one sees it that looks at all.
        for (int i = 0; i < 20; ++i) {
            const Vec3 d = random.direction();
            const Point along{d[0], d[1], d[2]};
            const Point best = hulls.rounded(1, hulls.support(1, along));
            for (std::uint32_t v = 0; v < hulls.hull(1).vertex_count(); ++v) {
                const Point other = hulls.rounded(1, v);
                double further = 0;
                for (std::size_t k = 0; k < 3; ++k) further += along[k] * (other[k] - best[k]);
                EXPECT_LE(further, 8 * hulls.delta());
            }
        }
    }
}

}  // namespace
}  // namespace ecods
