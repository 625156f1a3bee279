// A line on the terminal that tells how far a campaign is; nothing where the output is not a terminal.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>

namespace ecods::fuzz {

class Progress {
  public:
    void show(std::uint64_t runs, std::uint64_t failures) {
        if (!is_terminal_ || Clock::now() - shown_ < std::chrono::milliseconds(200)) return;
        shown_ = Clock::now();
        fmt::print(stderr, "\r{} runs, {} failures", runs, failures);
    }
    ~Progress() {
        if (is_terminal_) fmt::print(stderr, "\r\x1b[K");
    }

  private:
    using Clock = std::chrono::steady_clock;
    bool is_terminal_ = isatty(STDERR_FILENO) == 1;
    Clock::time_point shown_ = {};
};

}  // namespace ecods::fuzz
