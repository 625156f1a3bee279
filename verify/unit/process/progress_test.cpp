#include "process/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <functional>
#include <string>

#include "process/descriptor.hpp"

namespace ecods::process {
namespace {

void work() {
    Progress steps("work", 3);
    steps.step();
    steps.step();
    steps.wipe();
    Progress().show("2 of many");
}

constexpr char end_mark = '#';

// What appears on a terminal that is the error stream meanwhile.
std::string on_terminal(const std::function<void()>& work) {
    const Descriptor master(posix_openpt(O_RDWR | O_NOCTTY));
    if (master.number() < 0 || grantpt(master.number()) != 0 || unlockpt(master.number()) != 0) return "no terminal";
    const Descriptor terminal(open(ptsname(master.number()), O_RDWR | O_NOCTTY));
    const Descriptor before(dup(STDERR_FILENO));
    std::fflush(stderr);
    dup2(terminal.number(), STDERR_FILENO);
    work();
    std::fputc(end_mark, stderr);
    std::fflush(stderr);
    dup2(before.number(), STDERR_FILENO);
    // One read need not give all that was written.
    std::string text;
    while (!text.ends_with(end_mark)) {
        std::array<char, 4096> part{};
        const ssize_t count = read(master.number(), part.data(), part.size());
        if (count <= 0) return text + " and no end";
        text.append(part.data(), static_cast<std::size_t>(count));
    }
    text.pop_back();
    return text;
}

TEST(Progress, ALineOnATerminal) {
    const std::string text = on_terminal(work);
    if (text == "no terminal") GTEST_SKIP();
    // The second step is not shown when it comes soon after the first.
    EXPECT_TRUE(text.starts_with("\r\033[Kwork\r\033[Kwork: 1 of 3\r\033[K")) << text;
    EXPECT_TRUE(text.ends_with("\r\033[K\r\033[K2 of many\r\033[K")) << text;
}

TEST(Progress, NothingInAPipeOrFile) {
    testing::internal::CaptureStderr();
    work();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace ecods::process
