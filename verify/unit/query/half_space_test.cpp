// Half spaces: known answers, boxes, lines, pairs of half spaces, and worlds with a ground.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "ecods/trace.hpp"
#include "ecods/world.hpp"
#include "oracle/half_space.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::half_space_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::shared_ptr<const Mesh>& cube() {
    static const auto mesh = scenes::cube(0.5);
    return mesh;
}

const HalfSpace& ground() {
    static const HalfSpace half_space(Vec3::UnitZ(), 0);
    return half_space;
}

TEST(HalfSpace, ACubeOnTheGround) {
    const MeshShape surface(cube());
    const Solid solid(cube());
    const auto at_height = [&](double z) { return Posed<MeshShape>(surface, at(0, 0, z)); };
    const Posed<HalfSpace> floor(ground(), Pose{});
    EXPECT_TRUE(intersects(at_height(0.5), floor));
    EXPECT_FALSE(intersects(at_height(std::nextafter(0.5, 1)), floor));
    EXPECT_EQ(relation(at_height(0.5), floor), Relation::touching);
    EXPECT_EQ(relation(at_height(0.25), floor), Relation::crossing);
    EXPECT_EQ(relation({solid, at(0, 0, 0.25)}, floor), Relation::overlapping);
    EXPECT_EQ(relation(at_height(-0.5), floor), Relation::inside);
    EXPECT_EQ(relation(at_height(2), floor), Relation::apart);
    EXPECT_EQ(signed_distance(at_height(2), floor).distance, 1.5);
    EXPECT_EQ(signed_distance(at_height(-2), floor).distance, -2.5);
    EXPECT_EQ(signed_distance(at_height(std::nextafter(0.5, 0)), floor).distance, std::nextafter(0.5, 0) - 0.5);
    EXPECT_TRUE(within(at_height(2), floor, 1.5));
    EXPECT_FALSE(within(at_height(2), floor, std::nextafter(1.5, 0)));

    const ClosestPoints points = closest(at_height(2), floor);
    EXPECT_EQ(points.distance, 1.5);
    EXPECT_EQ(points.kind, ClosestKind::vertex_face);
    EXPECT_EQ(points.point_a[2], 1.5);
    EXPECT_EQ(points.point_b, Vec3(points.point_a[0], points.point_a[1], 0));

    const auto contact = cast(at_height(2), Vec3(1, 2, -3), floor);
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->time, 0.5);
    EXPECT_FALSE(cast(at_height(2), Vec3(1, 2, -3), floor, std::nextafter(0.5, 0)));
    EXPECT_TRUE(cast(at_height(2), Vec3(1, 2, -3), floor, 0.5));
    EXPECT_FALSE(cast(at_height(2), Vec3(1, 2, 3), floor));
    EXPECT_FALSE(cast(at_height(2), Vec3(1, 2, 0), floor));
    EXPECT_EQ(cast(at_height(0.5), Vec3(0, 0, 1), floor)->time, 0);
}

// A solid of which a triangle without area sticks out is the set without it.
TEST(HalfSpace, TrianglesWithoutAreaAreNotOfSolids) {
    std::vector<Vec3> vertices(cube()->vertices().begin(), cube()->vertices().end());
    std::vector<Triangle> triangles = {{0, 8, 0}};
    triangles.insert(triangles.end(), cube()->triangles().begin(), cube()->triangles().end());
    vertices.emplace_back(0, 0, -3);
    const auto mesh = Mesh::create(std::move(vertices), std::move(triangles));
    const MeshShape surface(mesh);
    const Solid solid(mesh);
    EXPECT_EQ(signed_distance({surface, at(0, 0, 4)}, {ground(), Pose{}}).distance, 1);
    EXPECT_EQ(signed_distance({solid, at(0, 0, 4)}, {ground(), Pose{}}).distance, 3.5);
    EXPECT_EQ(relation({solid, at(0, 0, 0)}, {ground(), Pose{}}), Relation::overlapping);
    EXPECT_EQ(relation({surface, at(0, 0, 0)}, {ground(), Pose{}}), Relation::crossing);
    Pose thin;
    thin.R(0, 0) = 0;
    EXPECT_EQ(relation({solid, thin}, {ground(), Pose{}}), Relation::touching);
    const ClosestPoints points = closest({solid, at(0, 0, 4)}, {ground(), Pose{}});
    const Triangle& named = mesh->triangles()[points.a.triangle];
    EXPECT_GT(points.a.triangle, 0u);
    EXPECT_EQ(mesh->vertices()[named[points.a.corner]][2], -0.5);
}

// A shear turns the plane's normal otherwise than the vectors in it.
TEST(HalfSpace, PosesThatAreNoRotations) {
    Pose shear;
    shear.R(0, 2) = 1;  // (x + z, y, z): the plane z = 0 stays
    const MeshShape surface(cube());
    EXPECT_EQ(signed_distance({surface, at(0, 0, 2)}, {ground(), shear}).distance, 1.5);
    Pose mirror;
    mirror.R(2, 2) = -2;  // z >= 0
    EXPECT_EQ(signed_distance({surface, at(0, 0, -2)}, {ground(), mirror}).distance, 1.5);
    const HalfSpace shifted(Vec3(0, 0, 4), 4);  // z <= 1, and z >= -2 mirrored
    EXPECT_EQ(signed_distance({surface, at(0, 0, -4)}, {shifted, mirror}).distance, 1.5);
    Pose flat;
    flat.R(2, 2) = 0;
    EXPECT_THROW((void)intersects({surface, Pose{}}, {ground(), flat}), SingularPose);
    EXPECT_THROW((void)ground().box(flat), SingularPose);
}

// Squares of the normal underflow.
TEST(HalfSpace, ShortNormalsAndLargeDistances) {
    const MeshShape surface(cube());
    const HalfSpace short_normal(Vec3(0, 0, 1e-200), 0);
    const Posed<MeshShape> far(surface, at(0, 0, 5e29));
    EXPECT_EQ(distance(far, {short_normal, Pose{}}), 5e29);
    EXPECT_TRUE(within(far, {short_normal, Pose{}}, 1e30));
    EXPECT_FALSE(within(far, {short_normal, Pose{}}, 4e29));
    Pose tiny;
    tiny.R *= 1e-100;
    EXPECT_TRUE(within(far, {ground(), tiny}, 1e30));
    const Rounded ball(std::make_shared<MeshShape>(cube()), 1e30);
    EXPECT_TRUE(intersects({ball, at(0, 0, 5e29)}, {ground(), tiny}));
}

TEST(HalfSpace, BadNumbersAreRefused) {
    EXPECT_INVALID(HalfSpace(Vec3(0, 0, 0), 1), Argument::half_space);
    EXPECT_INVALID(HalfSpace(Vec3(0, std::nan(""), 0), 1), Argument::half_space);
    EXPECT_INVALID(HalfSpace(Vec3(0, 0, infinity), 1), Argument::half_space);
    EXPECT_INVALID(HalfSpace(Vec3(0, 0, 1), infinity), Argument::half_space);
    EXPECT_NO_THROW(HalfSpace(Vec3(0, 0, 0x1p-1074), -0x1p1023));
    const MeshShape surface(cube());
    const Posed<HalfSpace> floor(ground(), Pose{});
    EXPECT_INVALID(within({surface, Pose{}}, floor, -1), Argument::distance);
    EXPECT_INVALID(cast({surface, Pose{}}, Vec3(0, 0, infinity), floor), Argument::motion);
    EXPECT_INVALID(cast({surface, Pose{}}, Vec3(0, 0, 1), floor, std::nan("")), Argument::time);
    Pose turned;
    turned.R = Eigen::AngleAxisd(0.1, Vec3::UnitX()).toRotationMatrix();
    EXPECT_INVALID(cast(Moving<MeshShape>(surface, Pose{}, Pose{}), Moving<HalfSpace>(ground(), Pose{}, turned)),
                   Question::cast_moving);
}

TEST(HalfSpace, BoxesEndWhereThePlaneIsAcrossAnAxis) {
    EXPECT_EQ(ground().box(at(1, 2, 3)).max, Vec3(infinity, infinity, 3));
    EXPECT_EQ(ground().box(at(1, 2, 3)).min, Vec3(-infinity, -infinity, -infinity));
    const HalfSpace wall(Vec3(-3, 0, 0), 1);  // x >= -1/3
    const double end = wall.box({}).min[0];
    EXPECT_LT(end, -1.0 / 3);
    EXPECT_GE(end, std::nextafter(-1.0 / 3, -1));
    EXPECT_EQ(HalfSpace(Vec3(1, 1e-300, 0), 0).box({}).max, Vec3(infinity, infinity, infinity));
}

// ---- lines

TEST(HalfSpace, Lines) {
    const auto hits = [&](const auto& line) { return ground().all_hits(line, Pose{}, {}); };
    const auto down = hits(Ray{Vec3(1, 2, 3), Vec3(0, 0, -2)});
    ASSERT_EQ(down.size(), 1u);
    EXPECT_EQ(down[0].kind, HitKind::front);
    EXPECT_EQ(down[0].parameter, 1.5);
    EXPECT_EQ(down[0].point, Vec3(1, 2, 0));
    EXPECT_EQ(down[0].feature, (Feature{Feature::Kind::face, 0, 0}));

    const auto up = hits(Segment{Vec3(0, 0, -1), Vec3(0, 0, 3)});
    ASSERT_EQ(up.size(), 2u);
    EXPECT_EQ(up[0].kind, HitKind::inside);
    EXPECT_EQ(up[0].parameter, 0);
    EXPECT_EQ(up[1].kind, HitKind::back);
    EXPECT_EQ(up[1].parameter, 0.25);
    EXPECT_EQ(up[1].rank, 1u);

    EXPECT_TRUE(hits(Ray{Vec3(0, 0, 1), Vec3(1, 0, 0)}).empty());
    EXPECT_TRUE(hits(Ray{Vec3(0, 0, 1), Vec3(1, 0, 1)}).empty());
    EXPECT_TRUE(hits(Ray{Vec3(0, 0, 1), Vec3(0, 0, -1), std::nextafter(1.0, 0.0)}).empty());
    EXPECT_EQ(hits(Ray{Vec3(0, 0, 1), Vec3(0, 0, -1), 1}).size(), 1u);
    EXPECT_EQ(hits(Ray{Vec3(0, 0, -1), Vec3(0, 1, 0)}).size(), 1u);

    const auto in_plane = hits(Ray{Vec3(1, -0.0, 0), Vec3(2, 0, 0)});
    ASSERT_EQ(in_plane.size(), 1u);
    EXPECT_EQ(in_plane[0].kind, HitKind::along);
    EXPECT_EQ(in_plane[0].leave_parameter, infinity);
    EXPECT_EQ(in_plane[0].leave_point, Vec3(infinity, 0, 0));
    const auto part = hits(Ray{Vec3(1, 0, 0), Vec3(2, 0, 0), 3});
    EXPECT_EQ(part.at(0).leave_point, Vec3(7, 0, 0));
    EXPECT_EQ(hits(Segment{Vec3(1, 0, 0), Vec3(1, 0, 0)}).at(0).kind, HitKind::face);
    EXPECT_EQ(hits(Segment{Vec3(1, 0, 0), Vec3(1, 5, 0)}).at(0).leave_point, Vec3(1, 5, 0));
    EXPECT_EQ(hits(Segment{Vec3(1, 0, 0), Vec3(1, 5, 2)}).at(0).kind, HitKind::back);
    EXPECT_EQ(hits(Segment{Vec3(1, 0, 0), Vec3(1, 5, -2)}).at(0).kind, HitKind::front);
}

// ---- two half spaces

TEST(HalfSpace, Pairs) {
    const auto with = [&](const HalfSpace& a, const HalfSpace& b) {
        return std::pair(Posed(a, Pose{}), Posed(b, Pose{}));
    };
    const HalfSpace up(Vec3(0, 0, 2), 2), down(Vec3(0, 0, -3), -9), low(Vec3(0, 0, 1), -4), tilted(Vec3(0, 1, 5), 0);
    const auto [a, b] = with(up, down);  // z <= 1, z >= 3
    EXPECT_FALSE(intersects(a, b));
    EXPECT_EQ(distance(a, b), 2);
    EXPECT_EQ(distance(b, a), 2);
    EXPECT_TRUE(within(a, b, 2));
    EXPECT_FALSE(within(a, b, std::nextafter(2.0, 0.0)));
    EXPECT_EQ(relation(a, b), Relation::apart);
    const auto [c, d] = with(up, low);
    EXPECT_EQ(relation(c, d), Relation::contains);
    EXPECT_EQ(relation(d, c), Relation::inside);
    const HalfSpace twice(Vec3(0, 0, 4), 4);
    EXPECT_EQ(relation(c, Posed(twice, Pose{})), Relation::equal);
    const auto [e, f] = with(up, tilted);
    EXPECT_EQ(relation(e, f), Relation::overlapping);
    EXPECT_EQ(distance(e, f), 0);
    const HalfSpace meets(Vec3(0, 0, -3), -3);
    EXPECT_EQ(relation(a, Posed(meets, Pose{})), Relation::touching);
    // Twice a double is a double. Three times 0.1 is not 0.3, so the last two planes meet somewhere, far away.
    const HalfSpace p(Vec3(0.1, 0.7, 0), 0), q(Vec3(-0.2, -1.4, 0), -1), r(Vec3(-0.3, -2.1, 0), -1);
    EXPECT_FALSE(intersects(Posed(p, Pose{}), Posed(q, Pose{})));
    EXPECT_TRUE(intersects(Posed(p, Pose{}), Posed(r, Pose{})));
}

// ---- worlds

constexpr BroadPhaseKind kinds[] = {BroadPhaseKind::automatic, BroadPhaseKind::kept_candidates,
                                    BroadPhaseKind::sweep_and_prune, BroadPhaseKind::brute_force};

// Bodies and half spaces jump about. After every frame the lists are those of the oracle, for every broad phase.
TEST(HalfSpaceWorld, ListsAsTheOracle) {
    for (const BroadPhaseKind kind : kinds) {
        scenes::Random random(11);
        World world({.broad_phase = kind});
        world.set_clearance(0.5);
        world.set_relations(true);
        std::vector<BodyId> bodies, planes;
        std::vector<std::shared_ptr<const HalfSpace>> half_spaces;
        for (int i = 0; i < 24; ++i) bodies.push_back(world.create_body(cube(), at(3 * random.direction())));
        for (const Vec3& n : {Vec3(0, 0, 1), Vec3(1, 2, -1), Vec3(0, 0, -1), Vec3(-1, 0, 0)}) {
            half_spaces.push_back(std::make_shared<HalfSpace>(n, -2));
            planes.push_back(world.create_body(half_spaces.back(), Pose{}));
        }
        for (int frame = 0; frame < 30; ++frame) {
            for (const BodyId body : bodies) {
                if (random.below(3) != 0) continue;
                Pose pose = random.below(2) == 0 ? Pose{} : random.turned();
                pose.t = Vec3(random.below(9) - 4.0, random.below(9) - 4.0, 0.5 * (random.below(17) - 8.0));
                world.set_pose(body, pose);
            }
            if (frame % 5 == 0) {
                world.set_pose(planes[random.below(4)], at(random.uniform(-1, 1), 0, 0.5 * (random.below(5) - 2.0)));
            }
            world.update();
            std::vector<BodyPair> colliding, close;
            for (std::size_t p = 0; p < planes.size(); ++p) {
                const oracle::ExactHeights heights(
                    {half_spaces[p]->normal(), half_spaces[p]->offset(), world.pose(planes[p])});
                for (const BodyId body : bodies) {
                    const auto lowest = lowest_corner(heights, *cube(), world.pose(body));
                    const BodyPair pair{std::min(body, planes[p]), std::max(body, planes[p])};
                    if (sgn(lowest.height) <= 0) colliding.push_back(pair);
                    if (sgn(lowest.height) <= 0 || compare(heights.distance(lowest.height), 0.5) <= 0) {
                        close.push_back(pair);
                    }
                }
            }
            std::ranges::sort(colliding);
            std::ranges::sort(close);
            const auto of_planes = [&](std::span<const BodyPair> list) {
                std::vector<BodyPair> result;
                for (const BodyPair& pair : list) {
                    const bool a = std::ranges::count(planes, pair.a) > 0, b = std::ranges::count(planes, pair.b) > 0;
                    if (a != b) result.push_back(pair);
                }
                return result;
            };
            ASSERT_EQ(of_planes(world.colliding_pairs()), colliding) << frame;
            ASSERT_EQ(of_planes(world.close_pairs()), close) << frame;
            ASSERT_NO_THROW(world.check_invariants());
        }
    }
}

TEST(HalfSpaceWorld, QuestionsAboutABody) {
    World world;
    const BodyId floor = world.create_body(std::make_shared<HalfSpace>(ground()), Pose{});
    const BodyId box = world.create_body(cube(), at(0, 0, 3));
    world.update();
    EXPECT_EQ(world.distance(box, floor), 2.5);
    EXPECT_EQ(world.distance(floor, box), 2.5);
    const ClosestPoints points = world.closest(floor, box);
    EXPECT_EQ(points.a, (Feature{Feature::Kind::face, 0, 0}));
    EXPECT_EQ(points.b.kind, Feature::Kind::vertex);
    EXPECT_EQ(world.nearest(box)->body, floor);
    EXPECT_EQ(world.closest_pair()->distance, 2.5);
    EXPECT_EQ(world.cast(box, Vec3(0, 0, -5))->contact.time, 0.5);
    EXPECT_EQ(world.cast(floor, Vec3(0, 0, 5))->contact.time, 0.5);
    EXPECT_EQ(world.first_hit(Ray{Vec3(9, 9, 9), Vec3(0, 0, -1)})->body, floor);
    const std::vector<BodyId> movers{box};
    const std::vector<Pose> ends{at(0, 0, -2)};
    const auto meetings = world.meetings(movers, ends);
    ASSERT_EQ(meetings.size(), 1u);
    EXPECT_EQ(meetings[0].contact.time, 0.5);
    EXPECT_THROW((void)world.intersections(box, floor), NotSupported);
    const SignedDistance down = world.signed_distance(box, floor), up = world.signed_distance(floor, box);
    EXPECT_EQ(down.distance, 2.5);
    EXPECT_EQ(down.direction, Vec3(0, 0, -1));
    EXPECT_EQ(down.point_a[2], 2.5);
    EXPECT_EQ(up.direction, Vec3(0, 0, 1));
    EXPECT_EQ(up.a, down.b);
    EXPECT_EQ(up.point_a, down.point_b);
    EXPECT_EQ(world.signed_distance({sphere(1), at(0, 0, 0.5)}, floor).distance, -0.5);
    Pose flat;
    flat.R(2, 2) = 0;
    try {
        world.set_pose(floor, flat);
        ADD_FAILURE() << "not refused";
    } catch (const SingularPose& error) {
        EXPECT_EQ(error.body, floor);
        EXPECT_STREQ(error.what(), "body 1.0: its pose is singular");
    }
    try {
        world.create_body(std::make_shared<HalfSpace>(ground()), flat);
        ADD_FAILURE() << "not refused";
    } catch (const SingularPose& error) {
        EXPECT_EQ(error.body, BodyId());
        EXPECT_STREQ(error.what(), "the pose of the first shape is singular");
    }
    EXPECT_EQ(world.pose(floor), Pose{});
}

TEST(HalfSpaceWorld, TracesAreReplayed) {
    std::stringstream text;
    World world;
    world.trace_to(text);
    const BodyId wall = world.create_body(std::make_shared<HalfSpace>(Vec3(0.1, -3, 0x1p-1074), -0.7), at(1, 2, 3));
    const BodyId box = world.create_body(cube(), at(0, 9, 3));
    world.update();
    world.set_pose(box, at(1, 1, 3));
    world.set_shape(wall, std::make_shared<HalfSpace>(ground()));
    world.update();
    world.end_trace();
    EXPECT_NE(text.str().find("half_space 1 0x1.999999999999ap-4 -0x1.8p+1"), std::string::npos) << text.str();
    const ReplayReport report = replay(text);
    EXPECT_FALSE(report.difference);
    EXPECT_EQ(report.update_count, 2u);
    std::stringstream bad("ecods-trace 2\nworld automatic 0\nhalf_space 1 0x0p+0 0x0p+0 0x0p+0 0x0p+0\n");
    EXPECT_THROW(replay(bad), InvalidTrace);
}

}  // namespace
}  // namespace ecods::half_space_test
