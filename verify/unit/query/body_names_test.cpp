// Triangles of zero area are not in a solid's set: no answer depends on them, and triangles have their names in the
// mesh all the same.
#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

#include "ecods/hit.hpp"
#include "unit/query/bodies.hpp"

namespace ecods::body_names_test {
namespace {

using namespace bodies;

// The mesh of a box, and the same with segments of zero area from (2.5, 1.5, 1.5) out to (9, 1.5, 1.5) in the places of
// two triangles.
struct WithAntennas {
    explicit WithAntennas(MeshForm form, std::uint32_t first_place, std::uint32_t second_place)
        : first(first_place), second(second_place), plain(make(form, box({0, 0, 0}, {3, 3, 3}))) {
        const Soup all = soup_of_box({0, 0, 0}, {3, 3, 3});
        Soup soup;
        for (std::uint32_t i = 0, next = 0; i < 14; ++i) {
            if (i == first || i == second) {
                soup.add({2.5, 1.5, 1.5}, {9, 1.5, 1.5}, {2.5, 1.5, 1.5});
                continue;
            }
            const Triangle& t = all.triangles[next++];
            soup.add(all.vertices[t[0]], all.vertices[t[1]], all.vertices[t[2]]);
        }
        shape = make(form, soup.mesh());
    }

    std::uint32_t named(std::uint32_t triangle) const {
        for (const std::uint32_t place : {first, second}) triangle += triangle >= place;
        return triangle;
    }
    Feature named(Feature feature) const {
        if (feature.kind != Feature::Kind::none) feature.triangle = named(feature.triangle);
        return feature;
    }

    std::uint32_t first, second;
    ShapePtr plain, shape;
};

void expect_named(const ClosestPoints& got, const ClosestPoints& plain, const WithAntennas& body) {
    EXPECT_EQ(got.distance, plain.distance);
    EXPECT_EQ(got.kind, plain.kind);
    EXPECT_EQ(got.a, body.named(plain.a));
    EXPECT_EQ(got.b, plain.b);
    EXPECT_EQ(got.point_a, plain.point_a);
    EXPECT_EQ(got.point_b, plain.point_b);
}
void expect_named(std::optional<FirstContact> got, std::optional<FirstContact> plain, const WithAntennas& body) {
    if (plain) plain->a = body.named(plain->a);
    EXPECT_EQ(got, plain);
}

template <class Answer>
Answer turned(Answer answer) {
    std::swap(answer.a, answer.b);
    if constexpr (std::is_same_v<Answer, ClosestPoints>) std::swap(answer.point_a, answer.point_b);
    return answer;
}

// Every question that names triangles, of the two bodies as they are and without the segments.
void expect_same(const WithAntennas& body, const Pose& pose, const Posed<MeshShape>& other) {
    QueryMemory memory;
    const Posed<MeshShape> got(*body.shape, pose), plain(*body.plain, pose);
    EXPECT_EQ(relation(got, other, memory), relation(plain, other, memory));
    EXPECT_EQ(relation(other, got, memory), relation(other, plain, memory));
    EXPECT_EQ(intersects(got, other, memory), intersects(plain, other, memory));
    EXPECT_EQ(distance(other, got, memory), distance(other, plain, memory));
    EXPECT_EQ(within(got, other, 0.75, memory), within(plain, other, 0.75, memory));
    expect_named(closest(got, other, memory), closest(plain, other, memory), body);
    expect_named(turned(closest(other, got, memory)), turned(closest(other, plain, memory)), body);
    const auto first_got = cast(other, Vec3(1, 0.5, 0.25), got, 1, memory),
               first = cast(other, Vec3(1, 0.5, 0.25), plain, 1, memory);
    ASSERT_EQ(first_got.has_value(), first.has_value());
    if (first) {
        expect_named(turned(*first_got), turned(*first), body);
    }

    auto pairs = intersecting_triangles(plain, other, memory);
    for (TrianglePair& pair : pairs) pair.a = body.named(pair.a);
    EXPECT_EQ(intersecting_triangles(got, other, memory), pairs);
    const auto all_got = intersections(got, other, memory);
    ASSERT_EQ(all_got.size(), pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_EQ(all_got[i].triangles, pairs[i]);

    const auto near_got = close_triangles(got, other, 1.5, memory), near = close_triangles(plain, other, 1.5, memory);
    ASSERT_EQ(near_got.size(), near.size());
    for (std::size_t i = 0; i < near.size(); ++i) expect_named(near_got[i], near[i], body);
    const auto features_got = close_features(got, other, 1.5, memory),
               features = close_features(plain, other, 1.5, memory);
    ASSERT_EQ(features_got.size(), features.size());
    for (std::size_t i = 0; i < features.size(); ++i) expect_named(features_got[i].closest, features[i].closest, body);

    for (const Vec3& motion : {Vec3(0, 0, 0), Vec3(-9, 0, 0), Vec3(3, 0.5, 0.25)}) {
        expect_named(cast(got, motion, other, 1, memory), cast(plain, motion, other, 1, memory), body);
        Pose to = pose;
        to.t += motion;
        const Moving<MeshShape> still(*other.what, other.pose, other.pose);
        expect_named(cast(Moving<MeshShape>(*body.shape, pose, to), still, 1, memory),
                     cast(Moving<MeshShape>(*body.plain, pose, to), still, 1, memory), body);
    }
}

TEST(BodyNames, AreThoseOfTheMesh) {
    const auto cube = [](MeshForm form, double from, double to) { return make(form, box({from, 1, 1}, {to, 2, 2})); };
    for (const auto& [first, second] : {std::pair(0U, 1U), {0U, 13U}, {3U, 7U}, {12U, 13U}}) {
        for (const MeshForm form : {MeshForm::solid, MeshForm::convex}) {
            const WithAntennas body(form, first, second);
            for (const MeshForm other : all_forms) {
                const double at_antenna = 6;
                for (const auto& [from, to] :
                     {std::pair(at_antenna, 7.0), {2.0, 4.0}, {1.0, 2.0}, {3.0, 4.0}, {0.0, 1.0}}) {
                    const ShapePtr shape = cube(other, from, to);
                    expect_same(body, {}, {*shape, {}});
                    Pose turned;
                    turned.R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
                    turned.t = Vec3(3, 0, 0);
                    expect_same(body, turned, {*shape, {}});
                    Pose flat;
                    flat.R(2, 2) = 0;
                    flat.t = Vec3(0, 0, 1.5);
                    expect_same(body, flat, {*shape, {}});
                    expect_same(body, {}, {*shape, flat});
                }
                expect_same(body, {}, {*make(other, box({-1, -1, -1}, {4, 4, 4})), {}});  // around the solid alone
            }
        }
    }
}

TEST(BodyNames, OnlyTheSurfaceMeetsWhatSticksOut) {
    const WithAntennas body(MeshForm::solid, 0, 5);
    const auto& solid = static_cast<const Solid&>(*body.shape);
    const ShapePtr cube = make(MeshForm::surface, box({6, 1, 1.25}, {7, 2, 2.5}));
    EXPECT_FALSE(intersects({solid, {}}, {*cube, {}}));
    EXPECT_EQ(distance({solid, {}}, {*cube, {}}), 3);
    EXPECT_EQ(relation({solid, {}}, {*cube, {}}), Relation::apart);
    const std::shared_ptr<const MeshShape> surface = surface_of(solid);
    EXPECT_EQ(surface, surface_of(solid));
    EXPECT_EQ(surface->form(), MeshForm::surface);
    EXPECT_EQ(surface->mesh_ptr(), solid.mesh_ptr());
    EXPECT_EQ(surface->tree_bytes(), solid.tree_bytes());
    EXPECT_TRUE(intersects({*surface, {}}, {*cube, {}}));
    EXPECT_EQ(distance({*surface, {}}, {*cube, {}}), 0);
    EXPECT_EQ(relation({*surface, {}}, {*cube, {}}), Relation::crossing);
    // The surface outlives its solid.
    std::shared_ptr<const MeshShape> kept;
    {
        const auto other = std::make_shared<const Solid>(solid.mesh_ptr());
        kept = surface_of(*other);
    }
    EXPECT_TRUE(intersects({*kept, {}}, {*cube, {}}));
    EXPECT_EQ(first_hit(Segment{Vec3(8, 1, 1), Vec3(8, 2, 2)}, {*kept, {}})->triangle(), 0U);
}

TEST(BodyNames, OfHits) {
    for (const auto& [first, second] : {std::pair(0U, 1U), {0U, 13U}, {3U, 7U}, {12U, 13U}}) {
        for (const MeshForm form : {MeshForm::solid, MeshForm::convex}) {
            const WithAntennas body(form, first, second);
            PairWitness witness;
            QueryMemory memory;
            for (const Segment& segment :
                 {Segment{Vec3(8, 1, 1), Vec3(8, 2, 2)}, Segment{Vec3(1, 1, 1), Vec3(9, 1.5, 1.5)},
                  Segment{Vec3(9, 1.5, 1.5), Vec3(-1, 1.5, 1.5)}, Segment{Vec3(4, 4, 2), Vec3(-1, -1, 2)},
                  Segment{Vec3(2, 2, 5), Vec3(2, 2, 1)}, Segment{Vec3(3, 1, 3), Vec3(3, 1, 1)}}) {
                auto hits = all_hits(segment, {*body.plain, {}}, memory);
                for (Hit& hit : hits) hit.feature = body.named(hit.feature);
                const auto got = all_hits(segment, {*body.shape, {}}, memory);
                ASSERT_EQ(got.size(), hits.size());
                for (std::size_t i = 0; i < hits.size(); ++i) {
                    EXPECT_EQ(got[i].feature, hits[i].feature);
                    EXPECT_EQ(got[i].rank, hits[i].rank);
                    EXPECT_EQ(got[i].kind, hits[i].kind);
                    EXPECT_EQ(got[i].parameter, hits[i].parameter);
                }
                for (int round = 0; round < 3; ++round) {
                    const auto hit = first_hit(segment, {*body.shape, {}}, {memory, witness});
                    ASSERT_EQ(hit.has_value(), !hits.empty());
                    if (hit) {
                        EXPECT_EQ(hit->feature, hits[0].feature);
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace ecods::body_names_test
