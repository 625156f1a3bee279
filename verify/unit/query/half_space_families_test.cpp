// Bodies and half spaces of many families beside the oracle, which solves for points and forms no normal.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "ecods/solid.hpp"
#include "environment/each_environment.hpp"
#include "oracle/half_space.hpp"
#include "oracle/hits.hpp"
#include "unit/query/half_space_cases.hpp"

namespace ecods::half_space_families_test {
namespace {

using namespace half_space_cases;

// All answers of the library about a case.
struct Answers {
    bool intersects;
    Relation relation;
    double distance;
    SignedDistance signed_one;
    std::vector<bool> within;
    ClosestPoints closest;
    std::optional<FirstContact> cast, moving;
};

// Distances to ask `within` about: the rounded one and its neighbours.
std::vector<double> limits(double distance) {
    const double up = std::numeric_limits<double>::infinity();
    return {0.0, std::nextafter(distance, 0.0), distance, std::nextafter(distance, up), 2 * distance, up};
}

Answers ask(const Case& c, const std::vector<double>& limits_of_within) {
    const Posed<MeshShape> body(c.shape, c.body);
    const Posed<HalfSpace> half_space(c.half_space, c.at);
    Pose end = c.at;
    end.t = c.half_space_end;
    QueryMemory memory;
    Answers answers{
        intersects(body, half_space, memory),
        relation(body, half_space, memory),
        distance(body, half_space, memory),
        signed_distance(body, half_space, memory),
        {},
        closest(body, half_space, memory),
        cast(body, c.motion, half_space, 1, memory),
        cast(Moving<MeshShape>(c.shape, c.body, c.end), Moving<HalfSpace>(c.half_space, c.at, end), 1, memory)};
    for (const double d : limits_of_within) answers.within.push_back(within(body, half_space, d, memory));
    return answers;
}

void expect_contact(const std::optional<FirstContact>& contact, const std::optional<oracle::FirstCorner>& expected) {
    ASSERT_EQ(contact.has_value(), expected && expected->time <= 1);
    if (!contact) return;
    EXPECT_EQ(contact->time, oracle::nearest_parameter(expected->time));
    EXPECT_EQ(contact->a, (Feature{Feature::Kind::vertex, expected->triangle, expected->corner}));
    EXPECT_EQ(contact->b, (Feature{Feature::Kind::face, 0, 0}));
    EXPECT_EQ(contact->kind, ClosestKind::vertex_face);
}

void expect_at_start(const std::optional<FirstContact>& contact, const Feature& lowest) {
    ASSERT_TRUE(contact);
    EXPECT_EQ(*contact, (FirstContact{0, ClosestKind::contained, lowest, no_feature}));
}

void expect_right(const Case& c, const Answers& answers, const std::vector<double>& limits_of_within) {
    const Mesh& mesh = c.shape->mesh();
    const oracle::HalfSpaceSet set{c.half_space->normal(), c.half_space->offset(), c.at};
    const oracle::ExactHeights heights(set);
    const oracle::LowestCorner lowest = lowest_corner(heights, mesh, c.body);
    const int sign = sgn(lowest.height), top = sgn(greatest_height(heights, mesh, c.body));
    const oracle::ExactRoot distance = heights.distance(lowest.height);
    EXPECT_EQ(answers.intersects, sign <= 0);
    EXPECT_EQ(answers.relation, sign > 0    ? Relation::apart
                                : sign == 0 ? Relation::touching
                                : top <= 0  ? Relation::inside
                                            : Relation::crossing);
    const SignedDistance& signed_one = answers.signed_one;
    EXPECT_EQ(std::signbit(signed_one.distance), sign < 0);
    EXPECT_TRUE(is_nearest(distance, std::abs(signed_one.distance))) << signed_one.distance;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(answers.distance),
              std::bit_cast<std::uint64_t>(sign <= 0 ? 0 : signed_one.distance));
    for (std::size_t i = 0; i < limits_of_within.size(); ++i) {
        EXPECT_EQ(answers.within[i], sign <= 0 || compare(distance, limits_of_within[i]) <= 0) << limits_of_within[i];
    }

    const Feature feature{Feature::Kind::vertex, lowest.triangle, lowest.corner};
    const Vec3& v = mesh.vertices()[lowest.vertex];
    EXPECT_EQ(answers.closest.a, feature);
    EXPECT_EQ(answers.closest.distance, answers.distance);
    EXPECT_EQ(signed_one.a, feature);
    EXPECT_EQ(signed_one.b, (Feature{Feature::Kind::face, 0, 0}));
    EXPECT_EQ(signed_one.point_a, answers.closest.point_a);
    EXPECT_EQ(signed_one.point_b, heights.foot(v, c.body).nearest());
    for (int k = 0; k < 3; ++k) {
        const mpq_class& g = heights.direction()[static_cast<std::size_t>(k)];
        EXPECT_EQ(std::signbit(signed_one.direction[k]), sgn(g) > 0);
        EXPECT_TRUE(is_nearest(heights.share(k), std::abs(signed_one.direction[k]))) << k;
    }
    EXPECT_EQ(answers.closest.point_a, oracle::exact_point(oracle::exact_posed(v, c.body)).nearest());
    EXPECT_EQ(answers.closest.kind, sign <= 0 ? ClosestKind::contained : ClosestKind::vertex_face);
    EXPECT_EQ(answers.closest.b, sign <= 0 ? no_feature : (Feature{Feature::Kind::face, 0, 0}));
    EXPECT_EQ(answers.closest.point_b, sign <= 0 ? answers.closest.point_a : heights.foot(v, c.body).nearest());

    if (sign <= 0) {
        expect_at_start(answers.cast, feature);
        expect_at_start(answers.moving, feature);
        return;
    }
    std::optional<oracle::FirstCorner> first;
    const mpq_class rise = heights.rise(c.motion);
    if (sgn(rise) < 0) first = oracle::FirstCorner{-lowest.height / rise, lowest.triangle, lowest.corner};
    expect_contact(answers.cast, first);
    expect_contact(answers.moving, first_corner(set, c.half_space_end, mesh, c.body, c.end));
}

void expect_right(const Case& c) {
    Case plain = c;
    const std::vector<double> limits_of_within =
        limits(distance({plain.shape, plain.body}, {plain.half_space, plain.at}));
    expect_right(c, ask(c, limits_of_within), limits_of_within);
}

template <class Make>
void expect_family(std::uint32_t seed, int count, const Make& make) {
    Random random(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        expect_right(make(random));
    }
}

TEST(HalfSpaceFamilies, Lattice) {
    expect_family(1, 500, lattice);
}
TEST(HalfSpaceFamilies, General) {
    expect_family(2, 300, general);
}
TEST(HalfSpaceFamilies, NearContact) {
    expect_family(3, 500, near_contact);
}
TEST(HalfSpaceFamilies, Scaled) {
    expect_family(4, 150, [](Random& random) { return scaled(random, lattice(random)); });
    expect_family(5, 100, [](Random& random) { return scaled(random, general(random)); });
}
TEST(HalfSpaceFamilies, Wide) {
    expect_family(6, 100, wide);
}

TEST(HalfSpaceFamilies, InEachEnvironment) {
    Random random(7);
    for (int i = 0; i < 24 && !testing::Test::HasFailure(); ++i) {
        const Case c = i % 4 == 0   ? lattice(random)
                       : i % 4 == 1 ? near_contact(random)
                       : i % 4 == 2 ? scaled(random, lattice(random))
                                    : wide(random);
        const std::vector<double> limits_of_within = limits(distance({c.shape, c.body}, {c.half_space, c.at}));
        environment::in_each_environment([&] { return ask(c, limits_of_within); },
                                         [&](const Answers& answers, const std::string& where) {
                                             SCOPED_TRACE(where);
                                             expect_right(c, answers, limits_of_within);
                                         });
    }
}

}  // namespace
}  // namespace ecods::half_space_families_test
