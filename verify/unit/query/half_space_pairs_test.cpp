// Two half spaces that move: known answers, and what holds just before and after the time.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "ecods/solid.hpp"
#include "ecods/world.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::half_space_pairs_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const HalfSpace& ground() {
    static const HalfSpace half_space(Vec3::UnitZ(), 0);
    return half_space;
}

// The ceiling is z >= 3. Products with powers of two are exact, so the half spaces meet just after the time, not
// before.
TEST(HalfSpace, CastsOfPairs) {
    const HalfSpace ceiling(Vec3(0, 0, -2), -6), wall(Vec3::UnitX(), 0);
    const Posed<HalfSpace> floor(ground(), Pose{}), above(ceiling, Pose{});
    const auto up = cast(floor, Vec3(9, 0, 4), above);
    ASSERT_TRUE(up);
    EXPECT_EQ(
        *up, (FirstContact{0.75, ClosestKind::intersecting, {Feature::Kind::face, 0, 0}, {Feature::Kind::face, 0, 0}}));
    EXPECT_FALSE(cast(floor, Vec3(9, 0, 4), above, std::nextafter(0.75, 0)));
    EXPECT_FALSE(cast(floor, Vec3(9, 0, 2), above));
    EXPECT_FALSE(cast(floor, Vec3(9, 9, 0), above));
    EXPECT_FALSE(cast(floor, Vec3(0, 0, -4), above));
    EXPECT_EQ(cast(above, Vec3(0, 0, -4), floor)->time, 0.75);
    EXPECT_EQ(cast(floor, Vec3(0, 0, -4), {wall, Pose{}})->time, 0) << "they meet";
    EXPECT_EQ(cast(floor, Vec3(0, 0, -4), floor)->time, 0);
    EXPECT_INVALID(cast(floor, Vec3(0, infinity, 0), above), Argument::motion);
    EXPECT_INVALID(cast(floor, Vec3(0, 0, 1), above, -1), Argument::time);

    const auto moving = [](const HalfSpace& what, double z) { return Moving<HalfSpace>(what, Pose{}, at(0, 0, z)); };
    EXPECT_EQ(cast(moving(ground(), 4), moving(ceiling, -4))->time, 0.375);
    EXPECT_EQ(cast(moving(ceiling, -8), moving(ground(), -2))->time, 0.5);
    EXPECT_FALSE(cast(moving(ground(), 4), moving(ceiling, 2)));
    Pose turned = at(0, 0, 4);
    turned.R(0, 0) = -1;
    EXPECT_THROW((void)cast(Moving<HalfSpace>(ground(), Pose{}, turned), moving(ceiling, 0)), NotSupported);
    EXPECT_EQ(cast(Moving<HalfSpace>(ground(), Pose{}, turned), moving(wall, 0))->time, 0);

    scenes::Random random(31);
    for (int i = 0; i < 200; ++i) {
        const double scale = std::ldexp(1.0, static_cast<int>(random.below(5)));
        const HalfSpace upper(Vec3(0, 0, -random.uniform(0.1, 3)), -random.uniform(0.1, 3));
        Pose pose;
        pose.R(2, 2) = random.uniform(0.5, 2);
        const Posed<HalfSpace> a(ground(), Pose{}), b(upper, pose);
        const auto contact = cast(a, Vec3(1, 1, scale), b);
        if (!contact) {
            EXPECT_GT(distance(a, b), scale);
            continue;
        }
        const auto do_meet_at = [&](double time) { return intersects({ground(), at(0, 0, time * scale)}, b); };
        EXPECT_TRUE(do_meet_at(std::nextafter(contact->time, 2)));
        EXPECT_FALSE(do_meet_at(std::nextafter(contact->time, 0)));
    }
}

TEST(HalfSpaceWorld, TwoHalfSpacesMove) {
    World world;
    const BodyId floor = world.create_body(std::make_shared<HalfSpace>(ground()), Pose{});
    const BodyId ceiling = world.create_body(std::make_shared<HalfSpace>(Vec3(0, 0, -1), -4), Pose{});
    const BodyId box = world.create_body(scenes::cube(0.5), at(0, 0, 2));
    EXPECT_EQ(world.cast(floor, Vec3(0, 0, 8)), (BodyContact{box, world.cast(floor, Vec3(0, 0, 8))->contact}));
    world.set_pair_enabled(floor, box, false);
    EXPECT_EQ(world.cast(floor, Vec3(0, 0, 8))->body, ceiling);
    EXPECT_EQ(world.cast(floor, Vec3(0, 0, 8))->contact.time, 0.5);
    const std::vector<BodyId> movers{floor, box};
    const std::vector<Pose> ends{at(0, 0, 8), at(0, 0, 6)};
    const auto meetings = world.meetings(movers, ends);
    ASSERT_EQ(meetings.size(), 2u);
    EXPECT_EQ(meetings[0].bodies, (BodyPair{ceiling, box}));
    EXPECT_EQ(meetings[0].contact.time, 0.375);
    EXPECT_EQ(meetings[1].bodies, (BodyPair{floor, ceiling}));
    EXPECT_EQ(meetings[1].contact.time, 0.5);
}

}  // namespace
}  // namespace ecods::half_space_pairs_test
