// Certificates of worlds: what they are of, and when they are refused.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "ecods/certificate.hpp"
#include "ecods/error.hpp"
#include "ecods/world.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_certificate_test {
namespace {

class WorldCertificates : public testing::TestWithParam<BroadPhaseKind> {};

INSTANTIATE_TEST_SUITE_P(Kinds, WorldCertificates, broad_phases());

TEST_P(WorldCertificates, AreOfTheLists) {
    scenes::Random random(4);
    World world({.broad_phase = GetParam()});
    QueryMemory memory;
    const auto mesh = scenes::sphere(8, 6);
    std::vector<BodyId> ids;
    for (int k = 0; k < 20; ++k) {
        ids.push_back(world.create_body(
            mesh, Pose::from_quaternion(random.rotation(), 3 * random.direction() * random.uniform(0, 1))));
    }
    world.set_pair_enabled(ids[0], ids[1], false);
    world.set_filter(ids[2], {.groups = 1, .mask = 0});
    for (const std::optional<double> clearance : {std::optional<double>(), std::optional(0.25), std::optional(4.0)}) {
        world.set_clearance(clearance);
        for (const BodyId id : ids) {
            Pose pose = world.pose(id);
            pose.t += 0.1 * random.direction();
            world.set_pose(id, pose);
        }
        world.update();
        const WorldCertificate certificate = world.certify(memory);
        EXPECT_EQ(certificate.colliding_count(), world.colliding_pairs().size());
        EXPECT_EQ(certificate.close_count(), world.close_pairs().size());
        EXPECT_EQ(certificate.shapes().size(), 1u);
        const std::string text = certificate.to_string();
        EXPECT_EQ(text.rfind("ecods-world-certificate 2\nclearance ", 0), 0u);
        EXPECT_NE(text.find("\noff 1.0 2.0\n"), std::string::npos);
        EXPECT_EQ(text.find("\npair 1.0 2.0\n"), std::string::npos);
        EXPECT_EQ(text.find("\npair 3.0 "), std::string::npos);
        EXPECT_EQ(text.find(" 3.0\nclaim"), std::string::npos);
        EXPECT_TRUE(text.ends_with("\nend\nend world\n"));
    }
}

TEST_P(WorldCertificates, AreRefusedUntilTheNextUpdate) {
    World world({.broad_phase = GetParam()});
    QueryMemory memory;
    EXPECT_NO_THROW(world.certify(memory));
    const BodyId a = world.create_body(scenes::cube(1), at(0));
    const BodyId b = world.create_body(scenes::cube(1), at(3));
    const auto expect_refused_once = [&](const char* call) {
        SCOPED_TRACE(call);
        EXPECT_THROW(world.certify(memory), NotUpdated);
        world.update();
        EXPECT_NO_THROW(world.certify(memory));
    };
    expect_refused_once("create_body");
    world.set_pose(a, at(1.5));
    expect_refused_once("set_pose");
    world.set_filter(a, {.groups = 2});
    expect_refused_once("set_filter");
    world.set_pair_enabled(a, b, false);
    expect_refused_once("set_pair_enabled");
    world.set_clearance(1);
    expect_refused_once("set_clearance");
    world.set_clearance(2);
    expect_refused_once("set_clearance again");
    world.set_clearance({});
    expect_refused_once("no clearance");
    world.set_shape(a, std::make_shared<MeshShape>(scenes::cube(2)));
    expect_refused_once("set_shape");
    world.destroy_body(b);
    expect_refused_once("destroy_body");
}

class Point final : public Shape {
  public:
    ShapeKind kind() const noexcept override { return {7}; }
    Aabb box(const Pose& pose) const override { return {pose.t, pose.t}; }
    std::uint64_t digest() const noexcept override { return 1; }
};

class Never final : public TwoBodyTest {
    bool intersects(const Posed<Shape>&, const Posed<Shape>&, const Ask&) const override { return false; }
};

TEST_P(WorldCertificates, RefuseABodyOfTheCallersOwnKind) {
    World world({.broad_phase = GetParam()});
    QueryMemory memory;
    world.set_test({7}, ShapeKind::mesh(), std::make_shared<Never>());
    world.set_test({7}, {7}, std::make_shared<Never>());
    world.create_body(scenes::cube(1), at(0));
    const BodyId point = world.create_body(std::make_shared<Point>(), at(9));
    world.update();
    try {
        world.certify(memory);
        FAIL();
    } catch (const NotSupported& error) {
        EXPECT_EQ(error.question, Question::certify);
        EXPECT_EQ(error.body, point);
        EXPECT_EQ(error.a, ShapeKind{7});
        EXPECT_EQ(std::string(error.what()), "body 2.0 has a shape (kind 7) of which there are no certificates");
    }
}

// It outlives the world, and is not of what comes after.
TEST_P(WorldCertificates, KeepWhatTheyAreOf) {
    QueryMemory memory;
    std::optional<WorldCertificate> certificate;
    std::string text;
    {
        World world({.broad_phase = GetParam()});
        const BodyId a = world.create_body(scenes::cube(1), at(0));
        world.create_body(scenes::cube(1), at(2));
        world.update();
        certificate = world.certify(memory);
        text = certificate->to_string();
        world.set_pose(a, at(-9));
        world.update();
    }
    EXPECT_EQ(certificate->to_string(), text);
    EXPECT_EQ(certificate->colliding_count(), 1u);
    EXPECT_NE(text.find("claim touching"), std::string::npos) << text;
}

}  // namespace
}  // namespace ecods::world_certificate_test
