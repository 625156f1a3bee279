// What replay finds, and what it refuses.

#include "ecods/trace.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/trace/replay_text.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::replay_test {
namespace {

const std::string pose = " 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0\n";
const std::string head = "ecods-trace 2\nworld sweep_and_prune 0\n";
const std::string mesh =
    "mesh 1 3 1\nv 0x0p+0 0x0p+0 0x0p+0\nv 0x1p+0 0x0p+0 0x0p+0\nv 0x0p+0 0x1p+0 0x0p+0\nt 0 1 2\n";
const std::string two = head + mesh + "create 1.0 1" + pose + "create 2.0 1" + pose;  // 9 lines

TEST(Replay, NamesTheFirstUpdateThatDiffersWithItsCallAndLine) {
    World world;
    std::ostringstream out;
    world.trace_to(out);
    const BodyId a = world.create_body(scenes::cube(0.5), at(0));
    for (int i = 0; i < 5; ++i) {
        world.set_pose(a, at(i + 1));
        world.update();
    }
    world.end_trace();
    // The third update: its pose is given another last digit.
    std::string text = out.str();
    const std::size_t at_three = text.find("0x1.8p+1");
    ASSERT_NE(at_three, std::string::npos);
    text.replace(at_three, 8, "0x1.9p+1");
    const ReplayReport report = replay_text(text);
    ASSERT_TRUE(report.difference);
    EXPECT_EQ(report.difference->update, 2u);
    EXPECT_EQ(report.difference->call, 6u) << "create, and two calls each";
    EXPECT_EQ(report.difference->line, 2u + 21u + 1u + 6u);
    EXPECT_NE(report.difference->what.find("digest"), std::string::npos);
    EXPECT_EQ(report.update_count, 2u);
}

TEST(Replay, AWrongNumberOfPairsOrIdDiffers) {
    const std::string text = two + "update ";
    std::ostringstream digest;
    World world;
    const auto triangle = Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    world.create_body(triangle, at(0));
    world.create_body(triangle, at(0));
    world.update();
    digest << std::hex << world.digest();
    EXPECT_FALSE(replay_text(text + digest.str() + " 1\n").difference);
    EXPECT_TRUE(replay_text(text + digest.str() + " 2\n").difference);
    const ReplayReport other_id = replay_text(head + mesh + "create 2.0 1" + pose);
    ASSERT_TRUE(other_id.difference);
    EXPECT_EQ(other_id.difference->what, "the new body is 1.0");
    EXPECT_FALSE(replay_text("ecods-trace 2\nworld brute_force 7\n" + mesh + "create 5.3 1" + pose).difference);
}

TEST(Replay, AnUpdateWithoutAResultIsRunAndNotCompared) {
    for (const char* last : {"update", "update\n", "update failed\n", "update failed\nupdate\nnote\nnote it ends\n"}) {
        const ReplayReport report = replay_text(two + last);
        EXPECT_FALSE(report.difference);
        EXPECT_EQ(report.colliding_count, 1u) << last;
    }
}

// A text that is none, the line where it goes wrong, and the reason that is given.
struct Malformed {
    std::string text;
    std::size_t line;
    std::string reason;
};
const std::vector<Malformed> malformed{
    {"", 1, "a trace begins with"},
    {"ecods-trace 3\nworld sweep_and_prune 0\n", 1, "ecods-trace 2"},
    {"ecods-trace 2\nworld sweep_and_prune 0\nset_solids 1\n", 3, "no such call"},
    {"ecods-trace 2", 2, "'world ...'"},
    {"ecods-trace 2\nmesh 1 2 3\n", 2, "'mesh' is where a line 'world ...'"},
    {"ecods-trace 2\nworld sort_and_pray 0\n", 2, "no such broad phase"},
    {"ecods-trace 2\nworld sweep_and_prune -1\n", 2, "'-1' is no number"},
    {"ecods-trace 2\nworld sweep_and_prune 0 0\n", 2, "'0' is too much"},
    {head + "fly 1.0\n", 3, "no such call"},
    {head + "\n", 3, "a call is missing"},
    {head + " update\n", 3, "no such call"},
    {head + "update 12\n", 3, "a number of pairs is missing"},
    {head + "update xyz 0\n", 3, "'xyz' is no hexadecimal number: a digest"},
    {head + "update 0 0 0\n", 3, "is too much"},
    {head + "mesh 1 4294967296 1\n", 3, "up to 4294967295"},
    {head + "mesh 1 4000000000 4000000000\nv 0x0p+0 0x0p+0 0x0p+0\n", 5, "the trace ends where"},
    {head + "mesh 1 1 1\nt 0 0 0\n", 4, "'t' is where a line 'v ...' belongs"},
    {head + "mesh 1 1 1\nv 0x0p+0 0x0p+0\n", 4, "a coordinate is missing"},
    {head + "mesh 1 1 1\nv 0x0p+0 0x0p+0 nan\n", 4, "'nan' is no finite"},
    {head + "mesh 1 1 1\nv 0x0p+0 0x0p+0 0xinf\n", 4, "'0xinf' is no finite"},
    {head + "mesh 1 1 1\nv 0x0p+0 0x0p+0 0x1p+1024\n", 4, "is no finite"},
    {head + "mesh 1 1 1\nv 0x0p+0 0x0p+0 0x-1p+0\n", 4, "is no finite"},
    {head + "mesh 1 1 1\nv 0x0p+0 0x0p+0 1.5\n", 4, "is no finite"},
    {head + "mesh 1 1 1\nv 0x0p+0 0x0p+0 0x0p+0\nt 0 0 1\n", 5, "vertex index 1 is out of range"},
    {head + "mesh 1 1 0\nv 0x0p+0 0x0p+0 0x0p+0\n", 4, "no triangles"},
    {head + mesh + mesh, 12, "the number of this mesh is taken"},
    {head + "create 1.0 1" + pose, 3, "no such mesh"},
    {head + mesh + "create 0.0 1" + pose, 8, "'0.0' is no body"},
    {head + mesh + "create 1 1" + pose, 8, "'1' is no body"},
    {head + mesh + "create 1.-1 1" + pose, 8, "is no body"},
    {head + mesh + "create 1.0 1 0x0p+0\n", 8, "a coordinate is missing"},
    {two + "create 1.0 1" + pose, 10, "this body is here already"},
    {two + "destroy 3.0\n", 10, "there is no such body"},
    {two + "destroy 1.0\ndestroy 1.0\n", 11, "there is no such body"},
    {two + "set_pose 1.1" + pose, 10, "there is no such body"},
    {two + "set_shape 1.0 4\n", 10, "no such mesh or shape"},
    {two + "set_poses 18446744073709551615\np 1.0" + pose, 12, "the trace ends where a line 'p ...'"},
    {two + "set_poses 1\np 9.0" + pose, 11, "there is no such body"},
    {two + "set_filter 1.0 g 0\n", 10, "'g' is no hexadecimal number: groups"},
    {two + "set_filter 1.0 10000000000000000 0\n", 10, "is no hexadecimal number"},
    {two + "set_pair_enabled 1.0 1.0 0\n", 10, "a pair is two bodies"},
    {two + "set_pair_enabled 1.0 2.0 2\n", 10, "up to 1"},
    {two + "set_user_data 1.0\n", 10, "user data is missing"},
    {two + "set_clearance\n", 10, "a coordinate is missing"},
    {two + "set_clearance none 1\n", 10, "is too much"},
    {two + "set_clearance some\n", 10, "is no finite"},
    {two + "set_clearance -0x1p+0\n", 10, "distance is -1"},
    {two + std::string("\0\x80 \xff", 4), 10, "no such call"},
    {two + "set_user_data 1.0 " + std::string(100, '\x7f') + "\n", 10, "?...' is no"},
};

TEST(Replay, AMalformedTextIsRefusedWithItsLine) {
    for (const Malformed& c : malformed) {
        try {
            replay_text(c.text);
            ADD_FAILURE() << "was read: " << c.text;
        } catch (const InvalidTrace& error) {
            EXPECT_EQ(error.line, c.line) << error.what() << "\n" << c.text;
            EXPECT_NE(std::string(error.what()).find(c.reason), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW(replay_text(head + "shape 1 5 any\n"), NotSupported);
}

// A text with any byte changed, or cut off anywhere, is run or refused.
TEST(Replay, AnyTextIsRunOrRefused) {
    std::ostringstream out;
    World world;
    world.trace_to(out);
    const BodyId a = world.create_body(scenes::cube(0.5), at(0));
    const BodyId b = world.create_body(scenes::cube(0.5), at(0.5));
    world.update();
    world.set_poses(std::vector<BodyId>{a, b}, std::vector<Pose>{at(3), at(4)});
    world.set_pair_enabled(a, b, false);
    world.update();
    world.destroy_body(a);
    world.update();
    const std::string good = out.str();
    scenes::Random random(11);
    const std::string bytes = "0123456789abcdefxp+-. \n\tZ";
    int refused = 0;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        std::string text = good;
        for (std::uint32_t k = 0; k <= random.below(3); ++k) {
            const std::size_t where = random.below(static_cast<std::uint32_t>(good.size()));
            text[where] = bytes[random.below(static_cast<std::uint32_t>(bytes.size()))];
        }
        if (random.below(4) == 0) text.resize(random.below(static_cast<std::uint32_t>(good.size())));
        try {
            replay_text(text);
        } catch (const InvalidTrace&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 1000);
    EXPECT_LT(refused, 2990);
}

TEST(Replay, AStreamThatFailsIsRefused) {
    class Failing final : public std::streambuf {
        int underflow() override { throw std::runtime_error("the disk is gone"); }
    };
    Failing failing;
    std::istream in(&failing);
    EXPECT_THROW(replay(in), InvalidTrace);
}

// Works for nobody.
class IdleExecutor final : public Executor {
  public:
    std::size_t worker_count() const noexcept override { return 2; }
    void run(std::size_t, const std::function<void(std::size_t, std::size_t)>&) override {}
};

// Not the trace's fault.
TEST(Replay, AnExecutorThatFailsIsTold) {
    std::string text = head + mesh;
    for (int i = 1; i <= 40; ++i) text += "create " + std::to_string(i) + ".0 1" + pose;
    text += "update\n";
    EXPECT_EQ(replay_text(text).colliding_count, 40u * 39 / 2);
    EXPECT_THROW(replay_text(text, {.executor = std::make_shared<IdleExecutor>()}), ExecutorFailed);
}

}  // namespace
}  // namespace ecods::replay_test
