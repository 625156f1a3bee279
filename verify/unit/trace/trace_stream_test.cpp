// A trace is the same text whatever flags, widths and locales its stream has; memory that runs
// out is no fault of the text.

#include <gtest/gtest.h>

#include <functional>
#include <locale>
#include <new>
#include <sstream>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/trace.hpp"
#include "ecods/world.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::trace_stream_test {
namespace {

// Decimal commas, and digits in groups.
class Commas final : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\1"; }
    std::string do_truename() const override { return "ja"; }
};

std::locale commas() {
    return {std::locale::classic(), new Commas};
}

// While it lives, streams that are made have decimal commas.
class GlobalCommas {
  public:
    GlobalCommas() : before_(std::locale::global(commas())) {}
    ~GlobalCommas() { std::locale::global(before_); }
    GlobalCommas(const GlobalCommas&) = delete;
    GlobalCommas& operator=(const GlobalCommas&) = delete;

  private:
    std::locale before_;
};

// Every kind of call. `before_each` comes before each of them.
void make_every_call(World& world, std::ostream& out, const std::function<void()>& before_each) {
    const auto cube = scenes::cube(0.1);
    before_each();
    world.trace_to(out);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 12; ++i) {
        before_each();
        bodies.push_back(world.create_body(cube, at(0.15 * i, 1234.5, -0x1.8p-1060)));
    }
    const std::vector<std::function<void()>> calls{
        [&] { world.update(); },
        [&] { world.set_pose(bodies[1], at(0.3, 1e300)); },
        [&] { world.set_poses(bodies, std::vector<Pose>(bodies.size(), at(1234567.125))); },
        [&] { world.set_shape(bodies[2], scenes::cube(1.5)); },
        [&] { world.set_filter(bodies[3], {.groups = 1000000, .mask = 0xfedcba9876543210}); },
        [&] { world.set_pair_enabled(bodies[4], bodies[5], false); },
        [&] { world.set_user_data(bodies[6], 1234567890); },
        [&] { world.update(); },
        [&] { world.destroy_body(bodies[7]); },
        [&] { world.update(); },
        [&] { world.end_trace(); }};
    for (const auto& call : calls) {
        before_each();
        call();
    }
}

// As it is in a program that has changed nothing.
std::string plain_text() {
    World world;
    std::ostringstream out;
    make_every_call(world, out, [] {});
    return out.str();
}

void disturb(std::ios& stream) {
    stream.setf(std::ios::hex | std::ios::left, std::ios::basefield | std::ios::adjustfield);
    stream.setf(std::ios::showbase | std::ios::showpos | std::ios::uppercase | std::ios::boolalpha);
    stream.unsetf(std::ios::skipws);
    stream.precision(2);
    stream.fill('*');
    stream.width(30);
}

TEST(TraceStream, FlagsAndWidthsOfTheStreamChangeNothing) {
    World world;
    std::ostringstream out;
    make_every_call(world, out, [&] { disturb(out); });
    EXPECT_EQ(out.str(), plain_text());
}

TEST(TraceStream, LocalesChangeNothing) {
    const std::string plain = plain_text();
    World world, other;
    std::ostringstream out;
    out.imbue(commas());
    make_every_call(world, out, [] {});
    EXPECT_EQ(out.str(), plain);

    const GlobalCommas global;
    std::ostringstream made_with_commas;
    ASSERT_EQ((made_with_commas << 1.5, made_with_commas.str()), "1,5") << "the test itself";
    made_with_commas.str("");
    make_every_call(other, made_with_commas, [] {});
    EXPECT_EQ(made_with_commas.str(), plain);
}

TEST(TraceStream, FlagsWidthsAndLocalesChangeNoReplay) {
    const std::string plain = plain_text();
    const auto expect_same = [&](std::istream& in) {
        const ReplayReport report = replay(in, {.checks_invariants = true});
        EXPECT_FALSE(report.difference) << report.difference->what;
        EXPECT_EQ(report.update_count, 3u);
        EXPECT_EQ(report.body_count, 11u);
    };
    std::istringstream in(plain);
    disturb(in);
    in.imbue(commas());
    in.exceptions(std::ios::eofbit | std::ios::failbit);
    expect_same(in);

    const GlobalCommas global;
    std::istringstream made_with_commas(plain);
    expect_same(made_with_commas);
}

// ---- out of memory

// Gives a text, and then fails in some way.
template <class Failure>
class FailingBuffer final : public std::streambuf {
  public:
    explicit FailingBuffer(std::string text) : text_(std::move(text)) {
        setg(text_.data(), text_.data(), &*text_.end());
    }
    int underflow() override { throw Failure(); }

  private:
    std::string text_;
};

struct DiskIsGone {};

TEST(TraceStream, AReplayOutOfMemorySaysSo) {
    const std::string plain = plain_text();
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{5}, plain.find('\n') + 1, plain.size() / 2, plain.size()}) {
        FailingBuffer<std::bad_alloc> out_of_memory(plain.substr(0, size));
        std::istream in(&out_of_memory);
        EXPECT_THROW(replay(in), std::bad_alloc) << size;
        FailingBuffer<DiskIsGone> disk(plain.substr(0, size));
        std::istream unreadable(&disk);
        EXPECT_THROW(replay(unreadable), InvalidTrace) << size;
    }
    std::istringstream failed(plain);
    failed.setstate(std::ios::failbit);
    EXPECT_THROW(replay(failed), InvalidTrace);
}

// ---- data of the caller's own

// A trace of the replay is the trace, behind the head, which says how many ids were given before.
std::string traced_again(const std::string& text) {
    std::istringstream in(text);
    std::ostringstream again;
    const ReplayReport report =
        replay(in, {.checks_invariants = true, .set_up = [&](World& world) { world.trace_to(again); }});
    EXPECT_FALSE(report.difference) << report.difference->what;
    return again.str();
}

std::string without_head(const std::string& text) {
    return text.substr(text.find('\n', text.find("world")));
}

// The whole number comes back, of bodies that were there before the trace as of others.
TEST(TraceStream, UserDataIsWrittenAndReadWhole) {
    constexpr std::uint64_t early = 0xfedcba9876543210, late = 0x123456789abcdef0;
    World world;
    const BodyId first = world.create_body(scenes::cube(1), at(0));
    world.create_body(scenes::cube(1), at(1));
    world.set_user_data(first, early);
    std::ostringstream out;
    world.trace_to(out);
    const BodyId third = world.create_body(scenes::cube(1), at(2));
    world.set_user_data(third, late);
    world.end_trace();
    EXPECT_NE(out.str().find(" 1 ffffffffffffffff fedcba9876543210\n"), std::string::npos);
    EXPECT_NE(out.str().find("\nset_user_data 3.0 123456789abcdef0\n"), std::string::npos);
    EXPECT_EQ(without_head(traced_again(out.str())), without_head(out.str()));
}

// A body that is made with options is one line; what is left at its default is not written.
TEST(TraceStream, ABodyMadeWithOptionsIsOneLine) {
    const auto cube = scenes::cube(1);
    World world;
    std::ostringstream out;
    world.trace_to(out);
    world.create_body({.mesh = cube, .pose = at(0), .filter = {.groups = 2, .mask = 0x1f}, .user_data = 42});
    world.create_body({.mesh = cube, .pose = at(0), .filter = {.groups = 2, .mask = 0}});
    world.create_body({.mesh = cube, .pose = at(0), .user_data = 7});
    world.create_body({.mesh = cube, .pose = at(0)});
    world.update();
    world.end_trace();
    const auto count = [&](const std::string& name) {
        std::size_t lines = 0;
        for (std::size_t i = 0; (i = out.str().find("\n" + name + " ", i)) != std::string::npos; ++i) ++lines;
        return lines;
    };
    EXPECT_EQ(count("create_with"), 3u);
    EXPECT_EQ(count("create"), 1u);
    EXPECT_EQ(count("set_filter") + count("set_user_data"), 0u);
    EXPECT_NE(out.str().find(" 2 1f 2a\n"), std::string::npos);
    EXPECT_EQ(traced_again(out.str()), out.str());
    EXPECT_EQ(world.colliding_pairs().size(), 3u) << "all but those of the body that meets nothing";
}

}  // namespace
}  // namespace ecods::trace_stream_test
