#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ecods/convex_solid.hpp"
#include "environment/each_environment.hpp"
#include "oracle/convex.hpp"
#include "scenes/convex_cases.hpp"
#include "scenes/random.hpp"

namespace ecods {
namespace {

// Every bit of an answer.
using Bits = std::vector<std::uint64_t>;

void add(Bits& bits, const Vec3& v) {
    for (int k = 0; k < 3; ++k) bits.push_back(std::bit_cast<std::uint64_t>(v[k]));
}

Bits bits_of(double distance, const std::optional<ClosestPoints>& closest) {
    Bits bits{std::bit_cast<std::uint64_t>(distance), closest.has_value()};
    if (!closest) return bits;
    bits.push_back(std::bit_cast<std::uint64_t>(closest->distance));
    bits.push_back(static_cast<std::uint64_t>(closest->kind));
    for (const Feature& f : {closest->a, closest->b}) {
        bits.push_back(static_cast<std::uint64_t>(f.kind));
        bits.push_back(f.triangle);
        bits.push_back(f.corner);
    }
    add(bits, closest->point_a);
    add(bits, closest->point_b);
    return bits;
}

Bits expected_bits(const oracle::ConvexPair& pair) {
    const auto closest = pair.closest();
    if (!closest) return {std::bit_cast<std::uint64_t>(0.0), 0};
    const auto feature = [](const oracle::NamedFeature& f) {
        return Feature{static_cast<Feature::Kind>(f.dimension), f.triangle, f.corner};
    };
    const double distance = oracle::nearest(closest->distance);
    return bits_of(distance,
                   ClosestPoints{distance, static_cast<ClosestKind>(closest->kind), feature(closest->a),
                                 feature(closest->b), closest->point_a.nearest(), closest->point_b.nearest()});
}

constexpr int cases = 25;  // of a family

TEST(SolidDistanceFamilies, AsTheOracle) {
    QueryMemory memory;
    PairWitness left;  // of whatever pair came before
    for (const scenes::ConvexFamily family : scenes::convex_families()) {
        scenes::Random random(7);
        for (int i = 0; i < cases; ++i) {
            SCOPED_TRACE(testing::Message() << scenes::name(family) << ' ' << i);
            const scenes::ConvexCase made = scenes::make_convex_case(family, random);
            const ConvexSolid a(made.a.mesh), b(made.b.mesh);
            const Posed<ConvexSolid> x(a, made.a.pose), y(b, made.b.pose);
            const auto expected =
                expected_bits(oracle::ConvexPair(*made.a.mesh, made.a.pose, *made.b.mesh, made.b.pose));
            const auto other = expected_bits(oracle::ConvexPair(*made.b.mesh, made.b.pose, *made.a.mesh, made.a.pose));
            if (made.distance) {
                EXPECT_EQ(std::bit_cast<double>(expected[0]), *made.distance);
            }
            const auto ask = [&] {
                PairWitness witness = left;
                std::vector<Bits> all{
                    bits_of(solid_distance(x, y, memory), solid_closest(x, y, memory)),
                    bits_of(solid_distance(y, x, memory, witness), solid_closest(y, x, memory, left))};
                witness = {static_cast<std::uint32_t>(i), 1};
                all.push_back(bits_of(solid_distance(x, y, memory, witness), solid_closest(x, y, memory, witness)));
                return all;
            };
            environment::in_each_environment(ask, [&](const std::vector<Bits>& answers, const std::string& where) {
                EXPECT_EQ(answers[0], expected) << where;
                EXPECT_EQ(answers[1], other) << where;
                EXPECT_EQ(answers[2], expected) << where;
            });
        }
    }
}

// A vertex beside, over or beyond the end of an edge or the side of a face, as the rounding of a pose has it.
TEST(SolidDistanceFamilies, AtTheBordersOfFeatures) {
    QueryMemory memory;
    scenes::Random random(9);
    const auto hull = [](std::vector<Vec3> points) {
        return std::make_shared<const Mesh>(convex_hull(std::span<const Vec3>(points)));
    };
    const auto box = hull({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}});
    const auto spike = hull({{0, 0, 0}, {1, 2, 3}, {-1, 2, 3}, {1, 3, 2}, {-1, 3, 2}, {0, 6, 6}});
    const auto wedge = hull({{-1, 0, 0}, {1, 0, 0}, {-1, 2, 3}, {1, 2, 3}, {-1, 3, 2}, {1, 3, 2}});
    const ConvexSolid a(box);
    for (const auto& mesh : {spike, wedge}) {
        const ConvexSolid b(mesh);
        for (const Vec3& offset : {Vec3(2, 3, 3), Vec3(1, 2, 3), Vec3(2, 2, 3), Vec3(3, 3, 3), Vec3(1, 3, 3),
                                   Vec3(2, 2 + 0x1p-30, 2 + 0x1p-30), Vec3(1, 2, 2 + 0x1p-40)}) {
            for (int i = 0; i < 12; ++i) {
                SCOPED_TRACE(testing::Message() << offset.transpose() << ", " << i);
                Pose p, q;
                p.R = q.R = random.rotation().toRotationMatrix();
                q.t = p.R * offset;
                if (i % 3 == 1) q.R = q.R * Eigen::AngleAxisd(1, Vec3::UnitX()).toRotationMatrix();
                const Posed<ConvexSolid> x(a, p), y(b, q);
                EXPECT_EQ(bits_of(solid_distance(x, y, memory), solid_closest(x, y, memory)),
                          expected_bits(oracle::ConvexPair(*box, p, *mesh, q)));
                EXPECT_EQ(bits_of(solid_distance(y, x, memory), solid_closest(y, x, memory)),
                          expected_bits(oracle::ConvexPair(*mesh, q, *box, p)));
            }
        }
    }
}

}  // namespace
}  // namespace ecods
