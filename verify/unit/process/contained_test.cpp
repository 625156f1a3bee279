#include "process/contained.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace ecods::process {
namespace {

using Turn = Contained::Run;
constexpr std::chrono::seconds limit{20};

TEST(Contained, KeepsItsStateFromTurnToTurn) {
    const double base = 40;
    Contained child([&] { return Turn([count = base]() mutable {
                              return std::vector<double>{++count, 0.5};
                          }); },
                    limit);
    EXPECT_EQ(child.run().values, (std::vector<double>{41, 0.5}));
    EXPECT_EQ(child.run().values, (std::vector<double>{42, 0.5}));
    EXPECT_TRUE(child.run().is_right());
}

TEST(Contained, TakesLongAnswers) {
    Contained child([] { return Turn([] { return std::vector<double>(100'000, 1.0); }); }, limit);
    EXPECT_EQ(child.run().values.size(), 100'000u);
}

TEST(Contained, NamesACrash) {
    Contained child(
        [] {
            return Turn([]() -> std::vector<double> {
                std::signal(SIGSEGV, SIG_DFL);  // a sanitizer's handler would end the process with a status
                raise(SIGSEGV);
                return {};
            });
        },
        limit);
    EXPECT_EQ(child.run().end, End::crashed);
    EXPECT_NE(child.run().failure.find("crashed"), std::string::npos);  // and stays so
}

TEST(Contained, NamesAHang) {
    Contained child(
        [] {
            return Turn([]() -> std::vector<double> {
                for (;;) pause();
            });
        },
        std::chrono::seconds(1));
    const Outcome outcome = child.run();
    EXPECT_EQ(outcome.end, End::hung);
    EXPECT_EQ(outcome.failure, "took longer than 1 s");
}

TEST(Contained, ProcessorTimeIsALimitOfItsOwn) {
    Contained child(
        [] {
            return Turn([]() -> std::string {
                std::signal(SIGXCPU, SIG_DFL);
                for (volatile bool goes_on = true; goes_on;) {
                }
                return "";
            });
        },
        Limits{.clock = limit, .processor = std::chrono::seconds(1), .is_pinned = false});
    const Outcome outcome = child.run();
    EXPECT_EQ(outcome.end, End::hung);
    EXPECT_EQ(outcome.failure, "took longer than 1 s of processor time");
}

TEST(Contained, NamesAnEndOfItsOwn) {
    Contained child([] { return Turn([]() -> std::string { _exit(3); }); }, limit);
    const Outcome outcome = child.run();
    EXPECT_EQ(outcome.end, End::crashed);
    EXPECT_EQ(outcome.failure, "ended with status 3");
}

TEST(Contained, BytesComeBackAsTheyAre) {
    const std::string bytes(200'000, '\0');
    Contained child([&] { return Turn([&] { return bytes + "end\n"; }); }, limit);
    EXPECT_EQ(child.run().text, bytes + "end\n");
    EXPECT_TRUE(child.run().values.empty());
}

// As a campaign does it: all at work at once, each taken in when it is done.
TEST(Contained, TurnsInParts) {
    std::vector<Contained> children;
    for (int i = 0; i < 3; ++i) {
        children.emplace_back([i] { return Turn([i] { return std::string(50'000, char('a' + i)); }); }, limit);
        children.back().begin();
    }
    for (Contained& child : children) {
        while (child.receive()) usleep(100);
        EXPECT_FALSE(child.receive()) << "the turn is over";
    }
    for (int i = 0; i < 3; ++i) EXPECT_EQ(children[std::size_t(i)].end().text, std::string(50'000, char('a' + i)));
    Contained gone([] { return Turn([]() -> std::string { _exit(0); }); }, limit);
    gone.begin();
    while (gone.receive()) usleep(100);
    EXPECT_EQ(gone.end().failure, "ended with status 0");
}

TEST(Contained, NamesWhatWasThrown) {
    Contained child([]() -> Turn { throw std::runtime_error("no tree"); }, limit);
    EXPECT_EQ(child.run().end, End::threw);
    EXPECT_EQ(child.run().failure, "threw: no tree");
}

// The parent waits for one child while others hold the same pipes open.
TEST(Contained, ManyAtOnce) {
    std::vector<Contained> children;
    for (int i = 0; i < 5; ++i)
        children.emplace_back([i] { return Turn([i] { return std::vector<double>{double(i)}; }); }, limit);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(children[std::size_t(i)].run().values.at(0), i);
}

}  // namespace
}  // namespace ecods::process
