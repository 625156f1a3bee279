// Bodies as sets: surfaces, solids and convex solids in each other, of which one knows by construction how they are to
// each other.
#include "unit/query/bodies.hpp"

#include <gtest/gtest.h>

#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::bodies {
namespace {

constexpr auto apart = Relation::apart, touching = Relation::touching, crossing = Relation::crossing,
               overlapping = Relation::overlapping, inside = Relation::inside, contains = Relation::contains,
               equal = Relation::equal;

bool is_surface(MeshForm form) {
    return form == MeshForm::surface;
}

// Calls `look(form of a, form of b)` for all of them.
template <class Look>
void for_all_forms(const Look& look) {
    for (const MeshForm of_a : all_forms) {
        for (const MeshForm of_b : all_forms) {
            SCOPED_TRACE(testing::Message() << "forms " << static_cast<int>(of_a) << ", " << static_cast<int>(of_b));
            look(of_a, of_b);
        }
    }
}

const Vec3 low(0, 0, 0), high(3, 3, 3);

TEST(Bodies, ABoxInABox) {
    for_all_forms([](MeshForm outer, MeshForm inner) {
        const ShapePtr a = make(outer, box(low, high)), b = make(inner, box({1, 1, 1}, {2, 2, 2}, 2));
        const Truth truth = is_surface(outer) ? Truth{.relation = apart, .distance = 1} : contained_truth(contains);
        expect_bodies(*a, *b, truth);
    });
}

TEST(Bodies, EqualBoxes) {
    for_all_forms([](MeshForm first, MeshForm second) {
        const ShapePtr a = make(first, box(low, high)), b = make(second, box(low, high, 2));
        const Relation relation = is_surface(first) || is_surface(second) ? touching : equal;
        expect_bodies(*a, *b, {.relation = relation, .distance = 0});
        expect_bodies(*a, *a, {.relation = is_surface(first) ? touching : equal, .distance = 0});
    });
}

TEST(Bodies, ABoxThatTouchesFromInside) {
    for_all_forms([](MeshForm outer, MeshForm inner) {
        const ShapePtr a = make(outer, box(low, high)), b = make(inner, box({0, 1, 1}, {1, 2, 2}));
        expect_bodies(*a, *b, {.relation = is_surface(outer) ? touching : contains, .distance = 0});
    });
}

TEST(Bodies, BoxesThatCross) {
    for_all_forms([](MeshForm first, MeshForm second) {
        const ShapePtr a = make(first, box(low, high)), b = make(second, box({1, 1, 1}, {4, 2, 2}));
        const Relation relation = is_surface(first) || is_surface(second) ? crossing : overlapping;
        expect_bodies(*a, *b, {.relation = relation, .distance = 0});
    });
}

TEST(Bodies, BoxesApartAndTouching) {
    for_all_forms([](MeshForm first, MeshForm second) {
        const ShapePtr a = make(first, box(low, high));
        expect_bodies(*a, *make(second, box({5, 1, 1}, {6, 2, 2})), {.relation = apart, .distance = 2});
        expect_bodies(*a, *make(second, box({3, 1, 1}, {6, 2, 2})), {.relation = touching, .distance = 0});
        expect_bodies(*a, *make(second, box({3, 3, 3}, {4, 4, 4})), {.relation = touching, .distance = 0});
    });
}

// A room with a cavity from 2 to 7, in which is an island from 4 to 5.
Soup room_with_an_island() {
    Soup soup = soup_of_box({0, 0, 0}, {9, 9, 9});
    soup.add_box({2, 2, 2}, {7, 7, 7});
    soup.add_box({4, 4, 4}, {5, 5, 5});
    return soup;
}

TEST(Bodies, ThingsInARoomWithAnIsland) {
    const ShapePtr room = solid_of(room_with_an_island());
    for (const MeshForm form : all_forms) {
        const auto expect = [&](const Vec3& from, const Vec3& to, const Truth& truth) {
            expect_bodies(*room, *make(form, box(from, to)), truth);
        };
        expect({2.5, 2.5, 2.5}, {3, 3, 3}, {.relation = apart, .distance = 0.5});  // in the cavity
        expect({2.5, 4, 4}, {4, 5, 5}, {.relation = touching, .distance = 0});     // on the island
        expect({1, 1, 1}, {1.5, 1.5, 1.5}, contained_truth(contains));             // in a wall
        expect({4.25, 4.25, 4.25}, {4.5, 4.5, 4.75}, contained_truth(contains));   // in the island
        // Around the room, and around the cavity inside the walls: solids hold parts of the room.
        const bool has_inside = form != MeshForm::surface;
        expect({-1, -1, -1}, {10, 10, 10},
               has_inside ? contained_truth(inside) : Truth{.relation = apart, .distance = 1});
        expect({1, 1, 1}, {8, 8, 8}, contained_truth(has_inside ? overlapping : contains));
        // Around the island, in the cavity.
        expect({3, 3, 3}, {6, 6, 6},
               has_inside ? contained_truth(overlapping) : Truth{.relation = apart, .distance = 1});
    }
    // A room in a room's wall: its shells are both there, and the island's cavity is around the other's.
    Soup thin = soup_of_box({0.5, 0.5, 0.5}, {8.5, 8.5, 8.5});
    thin.add_box({1, 1, 1}, {8, 8, 8});
    expect_bodies(*room, *solid_of(thin), contained_truth(contains));
    expect_bodies(*room, *solid_of(soup_of_box({2, 2, 2}, {7, 7, 7})), {.relation = overlapping, .distance = 0});
}

// Two boxes of eight vertices each, and their corners named by index.
MeshPtr two_indexed_boxes(double first, double second) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (const double x : {first, second}) {
        const auto cube = scenes::cube(0.25);
        const auto from = static_cast<std::uint32_t>(vertices.size());
        for (const Vec3& v : cube->vertices()) vertices.push_back(v + Vec3(x, 0, 0));
        for (const Triangle& t : cube->triangles()) triangles.push_back({from + t[0], from + t[1], from + t[2]});
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

// The first triangle of the piece that is inside is named, whichever piece that is.
TEST(Bodies, OnePieceOfTwoIsInside) {
    for (const MeshForm of_room : {MeshForm::solid, MeshForm::convex}) {
        const ShapePtr room = make(of_room, box({-1, -1, -1}, {1, 1, 1}));
        for (const MeshForm form : {MeshForm::surface, MeshForm::solid}) {
            const bool has_inside = form != MeshForm::surface;
            const ShapePtr second = make(form, two_indexed_boxes(5, 0)), first = make(form, two_indexed_boxes(0, 5));
            for (const auto& [pieces, triangle] : {std::pair(second, 12U), {first, 0U}}) {
                expect_bodies(*pieces, *room, contained_truth(has_inside ? overlapping : crossing));
                const Feature expected{Feature::Kind::vertex, triangle, 0};
                EXPECT_EQ(closest({*pieces, {}}, {*room, {}}).a, expected);
                const ClosestPoints points = closest({*room, {}}, {*pieces, {}});
                EXPECT_EQ(points.b, expected);
                const auto& solid = static_cast<const Solid&>(*room);
                EXPECT_EQ(locate(points.point_a, {solid, {}}).side, Side::inside);
                EXPECT_EQ(cast({*pieces, {}}, Vec3(9, 9, 9), {*room, {}})->a, expected);
            }
            expect_bodies(*make(form, two_indexed_boxes(5, -5)), *room, {.relation = apart, .distance = 3.75});
        }
    }
}

// All pieces are in the room's box: the first in the cavity, the second in a wall.
TEST(Bodies, OnePieceIsInTheCavityAndOneInTheWall) {
    Soup pieces = soup_of_box({2.5, 2.5, 2.5}, {3, 3, 3});
    pieces.add_box({1, 1, 1}, {1.5, 1.5, 1.5});
    const ShapePtr room = solid_of(room_with_an_island()), surface = surface_from(pieces), solid = solid_of(pieces);
    expect_bodies(*surface, *room, contained_truth(crossing));
    expect_bodies(*solid, *room, contained_truth(overlapping));
    EXPECT_EQ(closest({*surface, {}}, {*room, {}}).a, (Feature{Feature::Kind::vertex, 12, 0}));
}

// Sixty triangles with corners of their own about a cube, and one in it.
TEST(Bodies, OneOfManyTrianglesIsInside) {
    const ShapePtr cube = make(MeshForm::solid, box({-1, -1, -1}, {1, 1, 1}));
    const ShapePtr convex = make(MeshForm::convex, box({-1, -1, -1}, {1, 1, 1}, 2));
    for (const std::uint32_t which : {0U, 1U, 37U, 60U}) {
        scenes::Random random(which);
        Soup soup;
        for (std::uint32_t i = 0; i <= 60; ++i) {
            const Vec3 center = i == which ? Vec3(0.25, 0.5, -0.25) : Vec3(3 * random.direction());
            soup.add(center + 0.25 * random.direction(), center + 0.25 * random.direction(), center);
        }
        const ShapePtr surface = surface_from(soup);
        for (const ShapePtr& solid : {cube, convex}) {
            expect_bodies(*surface, *solid, contained_truth(crossing));
            EXPECT_EQ(closest({*surface, {}}, {*solid, {}}).a, (Feature{Feature::Kind::vertex, which, 0}));
        }
    }
}

TEST(Bodies, TrianglesOfAnyKindInside) {
    const auto expect = [](const Soup& soup) {
        for (const MeshForm form : {MeshForm::solid, MeshForm::convex}) {
            const ShapePtr cube = make(form, box(low, high));
            expect_bodies(*surface_from(soup), *cube, contained_truth(inside));
        }
    };
    Soup triangle, segment, point, joined;
    triangle.add({1, 1, 1}, {2, 1, 1}, {1, 2, 1.5});
    expect(triangle);
    segment.add({1, 1, 1}, {2, 2, 1.5}, {1, 1, 1});
    expect(segment);
    point.add({1, 2, 1}, {1, 2, 1}, {1, 2, 1});
    expect(point);
    joined.add({1, 1, 1}, {2, 1, 1}, {1, 2, 1.5});
    joined.add({2, 1, 1}, {2.5, 1, 1}, {2, 1.5, 2.5});  // over a corner
    expect(joined);
    Soup across = triangle;
    across.add({1, 2, 1.5}, {1, 2, 3}, {1.5, 2.5, 3});  // from there to a face
    expect_bodies(*surface_from(across), *make(MeshForm::solid, box(low, high)), {.relation = inside, .distance = 0});
}

// Two solids of which each has a part inside the other: that of the first is named.
TEST(Bodies, EachHasAPartInside) {
    Soup first = soup_of_box({0, 0, 0}, {3, 3, 3}), second = soup_of_box({1, 1, 1}, {2, 2, 2});
    first.add_box({11, 1, 1}, {12, 2, 2});
    second.add_box({10, 0, 0}, {13, 3, 3});
    const ShapePtr a = solid_of(first), b = solid_of(second);
    expect_bodies(*a, *b, contained_truth(overlapping));
    EXPECT_EQ(closest({*a, {}}, {*b, {}}).a, (Feature{Feature::Kind::vertex, 12, 0}));
    EXPECT_EQ(closest({*b, {}}, {*a, {}}).a, (Feature{Feature::Kind::vertex, 0, 0}));
    EXPECT_EQ(closest({*b, {}}, {*a, {}}).b, no_feature);
    EXPECT_EQ(cast({*b, {}}, Vec3(1, 0, 0), {*a, {}})->a, (Feature{Feature::Kind::vertex, 0, 0}));
}

}  // namespace
}  // namespace ecods::bodies
