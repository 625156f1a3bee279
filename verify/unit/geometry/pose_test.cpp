#include "ecods/pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>

#include "ecods/error.hpp"
#include "geometry/same_bits.hpp"
#include "scenes/expect_invalid.hpp"

namespace ecods::pose_test {
namespace {

TEST(Pose, AnyFinitePoseIsValid) {
    Pose pose;
    pose.R.setZero();
    pose.t = Vec3::Constant(std::numeric_limits<double>::max());
    pose.R(0, 1) = std::numeric_limits<double>::denorm_min();
    EXPECT_NO_THROW(validate(pose));
}

TEST(Pose, EveryEntryIsChecked) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) {
                Pose pose;
                (column == 3 ? pose.t[row] : pose.R(row, column)) = bad;
                try {
                    validate(pose);
                    FAIL() << row << " " << column;
                } catch (const InvalidArgument& error) {
                    const std::string r = std::to_string(row), c = std::to_string(column);
                    EXPECT_EQ(error.argument, Argument::pose);
                    EXPECT_EQ(error.part, column == 3 ? "t(" + r + ")" : "R(" + r + ", " + c + ")");
                }
            }
        }
    }
}

TEST(Pose, SameBitsIsFinerThanEqual) {
    Pose a, b;
    b.t[1] = -0.0;
    EXPECT_TRUE(a == b);
    EXPECT_FALSE(same_bits(a, b));
    EXPECT_TRUE(same_bits(a, a));
    b = a;
    b.R(2, 1) = std::numeric_limits<double>::denorm_min();
    EXPECT_FALSE(same_bits(a, b));
}

TEST(Pose, SameBitsComparesEachEntry) {
    const Pose pose = Pose::from_quaternion(Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5), Vec3(1, 2, 3));
    for (int k = 0; k < 12; ++k) {
        Pose other = pose;
        double& entry = k < 9 ? other.R.data()[k] : other.t[k - 9];
        entry = std::nextafter(entry, 10);
        EXPECT_FALSE(same_bits(pose, other)) << k;
    }
    EXPECT_TRUE(same_bits(pose, Pose(pose)));
}

TEST(Pose, IsMadeOfWhatOthersHave) {
    const Eigen::Quaterniond q(0.5, -0.5, 0.5, 0.5);
    const Vec3 t(1, -2, 3);
    const Pose turned = Pose::from_quaternion(q, t);
    EXPECT_EQ(turned.R, q.toRotationMatrix());
    EXPECT_EQ(turned.t, t);
    // Taken as given.
    const Eigen::Quaterniond twice(1, 1, 0, 0);
    EXPECT_EQ(Pose::from_quaternion(twice, t).R, (Mat3() << 1, 0, 0, 0, -1, -2, 0, 2, -1).finished());

    Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
    isometry.linear() = turned.R;
    isometry.translation() = t;
    EXPECT_EQ(Pose::from_isometry(isometry), turned);
    EXPECT_EQ(Pose::from_matrix(isometry.matrix()), turned);
}

TEST(Pose, TheLastRowOfAMatrixIsChecked) {
    const double tiny = std::numeric_limits<double>::denorm_min(), nan = std::numeric_limits<double>::quiet_NaN();
    for (int column = 0; column < 4; ++column) {
        const double right = column == 3 ? 1 : 0;
        for (const double bad : {right + 1, std::nextafter(right, 2), right == 0 ? -tiny : -1.0, nan}) {
            Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
            matrix(3, column) = bad;
            try {
                Pose::from_matrix(matrix);
                FAIL() << column << " " << bad;
            } catch (const InvalidArgument& error) {
                EXPECT_EQ(error.argument, Argument::pose);
                EXPECT_EQ(error.part, "(3, " + std::to_string(column) + ")");
                EXPECT_NE(std::string(error.what()).find(error.part), std::string::npos);
            }
        }
    }
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix(3, 1) = -0.0;
    EXPECT_EQ(Pose::from_matrix(matrix), Pose());
}

struct Thing {
    int number = 0;
};
struct SpecialThing : Thing {};

Pose moved(double x) {
    Pose pose;
    pose.t[0] = x;
    return pose;
}

// Made of a reference, it refers; a temporary, of which it could not, is refused when it is compiled.
TEST(Posed, RefersToAReference) {
    SpecialThing thing{{3}};
    const Posed<SpecialThing> posed(thing, moved(1));
    const Posed<Thing> as_base(posed);
    thing.number = 4;
    EXPECT_EQ(as_base.what, &thing);
    EXPECT_EQ(as_base.what->number, 4);
    EXPECT_EQ(as_base.pose, moved(1));
    EXPECT_EQ(posed.kept, nullptr);
    EXPECT_EQ(as_base.kept, nullptr);
    static_assert(!std::is_constructible_v<Posed<Thing>, Thing, Pose>);
    static_assert(!std::is_constructible_v<Moving<Thing>, Thing, Pose, Pose>);
    static_assert(!std::is_constructible_v<Posed<SpecialThing>, Posed<Thing>>);
}

// Made of a shared pointer, it keeps the thing, as do its copies, also those of the base.
TEST(Posed, KeepsWhatASharedPointerGave) {
    auto thing = std::make_shared<const SpecialThing>(SpecialThing{{5}});
    const std::weak_ptr<const SpecialThing> watched = thing;
    auto first = std::make_unique<Posed<SpecialThing>>(thing, moved(1));
    EXPECT_EQ(first->what, thing.get());
    auto as_base = std::make_unique<Posed<Thing>>(*first);
    const Posed<Thing> of_the_base(thing, moved(2));
    const auto deduced = std::make_unique<Posed<SpecialThing>>(Posed(std::make_shared<SpecialThing>(*thing), Pose()));
    EXPECT_EQ(deduced->what->number, 5);
    thing.reset();
    first.reset();
    EXPECT_EQ(watched.use_count(), 2);
    EXPECT_EQ(as_base->what, of_the_base.what);
    EXPECT_EQ(as_base->what->number, 5);
    Posed<Thing> copy = *as_base;
    as_base.reset();
    EXPECT_EQ(copy.what->number, 5);
    copy = Posed<Thing>(std::make_shared<Thing>(Thing{6}), moved(3));
    EXPECT_EQ(copy.what->number, 6);
    EXPECT_EQ(watched.use_count(), 1);
}

TEST(Posed, RefusesANullPointer) {
    EXPECT_INVALID(Posed<Thing>(std::shared_ptr<const Thing>(), Pose()), Argument::null);
    EXPECT_INVALID(Posed<Thing>(std::shared_ptr<SpecialThing>(), Pose()), Argument::null);
    EXPECT_INVALID(Moving<Thing>(std::shared_ptr<const Thing>(), Pose(), Pose()), Argument::null);
}

TEST(Moving, RefersOrKeepsAsPosedDoes) {
    const Thing thing{7};
    const Moving<Thing> referring(thing, moved(1), moved(2));
    EXPECT_EQ(referring.what, &thing);
    EXPECT_EQ(referring.kept, nullptr);
    auto shared = std::make_shared<const SpecialThing>(SpecialThing{{8}});
    const std::weak_ptr<const SpecialThing> watched = shared;
    const Moving deduced(shared, moved(1), moved(2));
    static_assert(std::is_same_v<decltype(deduced), const Moving<SpecialThing>>);
    const Moving<Thing> keeping(std::move(shared), moved(1), moved(2));
    EXPECT_EQ(watched.use_count(), 2);
    EXPECT_EQ(keeping.what->number, 8);
    EXPECT_EQ(keeping.from, moved(1));
    EXPECT_EQ(keeping.to, moved(2));
}

}  // namespace
}  // namespace ecods::pose_test
