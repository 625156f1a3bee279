// The table of what each question about one body answers, and what a shape can be made into, by kinds of bodies.
#include <concepts>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "unit/query/kinds.hpp"

namespace ecods::kinds {
namespace {

// Asks a question that has overloads, some of which may not take the body.
#define ASK(...)                                                        \
    [=](const Body& body) {                                             \
        with_type(body, [=](const auto& b) {                            \
            const auto ask = [=](const auto& a) requires requires {     \
                __VA_ARGS__;                                            \
            }                                                           \
            { return __VA_ARGS__; };                                    \
            if constexpr (std::invocable<decltype(ask), decltype(b)>) { \
                std::ignore = ask(b);                                   \
            } else {                                                    \
                throw NoSuchFunction();                                 \
            }                                                           \
        });                                                             \
    }

// Asks a world of the body.
template <class Ask>
auto in_a_world(const Ask& ask) {
    return [=](const Body& body) {
        World world;
        world.create_body(body.shape, body.pose);
        world.update();
        std::ignore = ask(world);
    };
}

TEST(Kinds, OfOneBody) {
    const Ray ray{Vec3(5, 0, 0), Vec3(-1, 0, 0)};
    const Segment segment{Vec3(5, 0, 0), Vec3(-5, 0, 0)};
    const Vec3 point(5, 0, 0);
    const std::vector<Vec3> points{point};
    const Hit hit;
    expect_table_of_one({
        //                              MSCFKRH
        {"Shape::all_hits", "+++++++", ASK(a.what->all_hits(ray, a.pose, Ask()))},
        {"Shape::first_hit", "+++++++", ASK(a.what->first_hit(segment, a.pose, Ask()))},
        {"first_hit", "++++---", ASK(first_hit(ray, a))},
        {"all_hits", "++++---", ASK(all_hits(ray, a))},
        {"sided_hits", "++++---", ASK(sided_hits(ray, a))},
        {"hit_normal", "++++---", ASK(hit_normal(ray, a, hit))},
        {"inside_parts", "-+++---", ASK(inside_parts(ray, a))},
        {"certify_hit", "+xxx---", ASK(certify_hit(segment, a))},
        {"closest of a point", "++++++-", ASK(closest(point, a))},
        {"closest of points", "++++---", ASK(closest(std::span<const Vec3>(points), a))},
        {"signed_distance of a point", "++++++-", ASK(signed_distance(point, a))},
        {"signed_distance of points", "++++---", ASK(signed_distance(std::span<const Vec3>(points), a))},
        {"locate", "-+++++-", ASK(locate(point, a))},
        {"locate of points", "-+++---", ASK(locate(std::span<const Vec3>(points), a))},
        {"surface_of", "-+++---", ASK(surface_of(*a.what))},
        {"rounded", "++++++x", [](const Body& body) { std::ignore = rounded(body.shape, 1); }},
        {"World::first_hit", "+++++++", in_a_world([=](const World& world) { return world.first_hit(ray); })},
        {"World::all_hits", "+++++++", in_a_world([=](const World& world) { return world.all_hits(segment); })},
        {"World::bodies_containing", "+++++++",
         in_a_world([=](const World& world) { return world.bodies_containing(point); })},
        {"World::intersecting_bodies", "+++++++", in_a_world([=](const World& world) {
             return world.intersecting_bodies({sphere(1), Pose()});
         })},
    });
}

// The test holds the rows of the header's table about worlds: which bodies a call asks, and which it leaves out.
TEST(Kinds, BodiesThatAWorldAsks) {
    std::string containing, deep;
    for (const Body& body : bodies_at(Place::left, 0)) {
        World world;
        const BodyId id = world.create_body(body.shape, body.pose);
        const BodiesContaining found = world.bodies_containing(Vec3(1, 0, 0));
        EXPECT_EQ(found.bodies.size() + found.skipped_count, 1U) << body.name;
        if (!found.bodies.empty() && containing.find(body.letter) == std::string::npos) containing += body.letter;
        world.create_body(std::make_shared<const ConvexSolid>(std::vector<Vec3>{Vec3(1, 0, 0)}), Pose());
        const auto depths = world.depths();
        EXPECT_TRUE(depths.empty() || depths.front().bodies.a == id);
        if (!depths.empty() && deep.find(body.letter) == std::string::npos) deep += body.letter;
    }
    EXPECT_EQ(containing, "SCFKR");
    EXPECT_EQ(deep, "CFK");
}

}  // namespace
}  // namespace ecods::kinds
