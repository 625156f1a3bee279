#include "harness/contained.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace ecods::bench {
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
    EXPECT_NE(child.run().failure.find("crashed"), std::string::npos);
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
    EXPECT_EQ(child.run().failure, "took longer than 1 s");
}

TEST(Contained, NamesWhatWasThrown) {
    Contained child([]() -> Turn { throw std::runtime_error("no tree"); }, limit);
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
}  // namespace ecods::bench
