// What a trace says of shapes: meshes that come and go, and shapes of the caller's own.
#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "ecods/world.hpp"
#include "scenes/shapes.hpp"
#include "unit/trace/replay_text.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::trace_shapes_test {
namespace {

constexpr ShapeKind ball_kind{9};

class Ball final : public Shape {
  public:
    explicit Ball(std::string name) : name_(std::move(name)) {}
    ShapeKind kind() const noexcept override { return ball_kind; }
    Aabb box(const Pose& pose) const override { return {pose.t - Vec3::Ones(), pose.t + Vec3::Ones()}; }
    std::uint64_t digest() const noexcept override { return name_.size(); }
    const std::string& name() const { return name_; }

  private:
    std::string name_;
};

class BallTest final : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask&) const override {
        if (a.pose.t.x() < -100) throw std::runtime_error("a test that fails");
        return (a.pose.t - b.pose.t).norm() <= 2;
    }
    Relation relation(const Posed<Shape>&, const Posed<Shape>&, const Ask&) const override {
        return Relation::touching;
    }
};

void add_ball_test(World& world) {
    world.set_test(ball_kind, ball_kind, std::make_shared<BallTest>());
}

const TraceOptions writes_balls{.write_shape = [](const Shape& s) { return dynamic_cast<const Ball&>(s).name(); }};

TEST(Trace, ShapesOfOnesOwnNeedAWriterAndAReader) {
    World world;
    add_ball_test(world);
    std::ostringstream out;
    world.trace_to(out);
    EXPECT_THROW(world.create_body(std::make_shared<Ball>("b"), at(0)), NotSupported);
    EXPECT_TRUE(world.bodies().empty());
    world.end_trace();
    world.create_body(std::make_shared<Ball>("early bird"), at(0));
    EXPECT_THROW(world.trace_to(out), NotSupported);

    std::ostringstream good;
    world.trace_to(good, writes_balls);
    const BodyId late = world.create_body(std::make_shared<Ball>(""), at(1));
    EXPECT_THROW(world.create_body(std::make_shared<Ball>("two\nlines"), at(0)), NotSupported);
    EXPECT_THROW(world.set_shape(late, std::make_shared<Ball>("a\rb")), NotSupported);
    world.update();
    world.end_trace();
    EXPECT_EQ(world.colliding_pairs().size(), 1u);

    EXPECT_THROW(replay_text(good.str()), NotSupported);
    std::vector<std::string> names;
    const ReplayReport report =
        replay_text(good.str(), {.set_up = add_ball_test, .read_shape = [&](ShapeKind kind, std::string_view text) {
                                     EXPECT_EQ(kind, ball_kind);
                                     names.emplace_back(text);
                                     return std::make_shared<Ball>(std::string(text));
                                 }});
    EXPECT_FALSE(report.difference);
    EXPECT_EQ(report.colliding_count, 1u);
    EXPECT_EQ(names, (std::vector<std::string>{"early bird", ""}));
}

TEST(Trace, AnUpdateThatThrewSaysSo) {
    World world;
    add_ball_test(world);
    std::ostringstream out;
    world.trace_to(out, writes_balls);
    const BodyId ball = world.create_body(std::make_shared<Ball>("b"), at(-101));
    world.create_body(std::make_shared<Ball>("b"), at(-101));
    EXPECT_THROW(world.update(), std::runtime_error);
    world.set_pose(ball, at(0));
    world.update();
    EXPECT_NE(out.str().find("\nupdate failed\nset_pose"), std::string::npos) << out.str();
    const auto lines_end = out.str().rfind('\n', out.str().size() - 2);
    EXPECT_EQ(out.str().substr(lines_end + 1, 7), "update ");
}

// Numbers of shapes that are gone are forgotten, and no number is given twice.
TEST(Trace, OfManyShapesThatComeAndGo) {
    std::ostringstream out;
    World world;
    world.trace_to(out);
    const BodyId stays = world.create_body(triangle, at(0));
    for (int i = 0; i < 400; ++i) {
        const double size = 1 + i;
        const auto mesh = Mesh::create({{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}});
        const BodyId comes = world.create_body(mesh, at(i % 7));
        if (i % 10 == 0) world.set_shape(stays, i % 20 == 0 ? mesh : triangle);
        world.update();
        world.destroy_body(comes);
    }
    world.update();
    world.end_trace();
    const ReplayReport report = replay_text(out.str());
    EXPECT_FALSE(report.difference) << report.difference->what;
    EXPECT_EQ(report.update_count, 401u);
}

// A test cannot be written; that it was set stands there.
TEST(Trace, NotesThatATestWasSet) {
    class Never final : public TwoBodyTest {
        bool intersects(const Posed<Shape>&, const Posed<Shape>&, const Ask&) const override { return false; }
        Relation relation(const Posed<Shape>&, const Posed<Shape>&, const Ask&) const override {
            return Relation::apart;
        }
    };
    std::ostringstream out;
    World world;
    world.trace_to(out);
    world.set_test(ShapeKind{1}, ShapeKind{2}, std::make_shared<Never>());
    world.end_trace();
    EXPECT_NE(out.str().find("\nnote "), std::string::npos);
    EXPECT_EQ(replay_text(out.str()).update_count, 0u);
}

// Meshes that are gone leave the writer's memory, and a new one at the address of an old one is not taken for it.
TEST(Trace, ManyMeshesComeAndGo) {
    std::ostringstream out;
    World world;
    world.trace_to(out);
    const BodyId body = world.create_body(scenes::cube(1), at(0));
    const BodyId other = world.create_body(scenes::cube(1), at(0));
    std::vector<std::shared_ptr<const Mesh>> kept;
    for (int i = 1; i <= 300; ++i) {
        // All at addresses of their own, for a while.
        if (i == 150) kept.clear();
        kept.push_back(scenes::cube(0.01 * i));
        world.set_shape(body, kept.back());
        world.set_pose(other, at(1 + 0.01 * i + (i % 2 == 0 ? 0 : 0x1p-40)));
        world.update();
    }
    world.end_trace();
    const ReplayReport report = replay_text(out.str());
    EXPECT_FALSE(report.difference);
    EXPECT_EQ(report.update_count, 300u);
}

TEST(TraceOfRounded, BadLinesAreRefused) {
    const auto replay_of = [](const std::string& line) {
        std::istringstream in("ecods-trace 2\nworld sweep_and_prune 0\nmesh 1 1 1\nv 0x0p+0 0x0p+0 0x0p+0\nt 0 0 0\n" +
                              line);
        return replay(in).body_count;
    };
    const std::string create =
        "\ncreate 1.0 2 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0\n";
    EXPECT_EQ(replay_of("rounded 2 1 0x1p-1" + create), 1U);
    for (const char* const line :
         {"rounded 2 1 -0x1p-1", "rounded 2 1 inf", "rounded 2 1 nan", "rounded 2 3 0x1p-1", "rounded 1 1 0x1p-1",
          "rounded 2 1", "rounded 2 1 0x1p-1 7", "rounded 2 1 0x1p-1\nrounded 3 2 0x1p-1"}) {
        EXPECT_THROW(replay_of(std::string(line) + create), InvalidTrace) << line;
    }
}

}  // namespace
}  // namespace ecods::trace_shapes_test
