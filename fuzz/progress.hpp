// A line on the terminal that tells how far a campaign is; nothing where the output is not a terminal.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string_view>

namespace ecods::fuzz {

class Progress {
  public:
    void show(std::uint64_t runs, std::uint64_t count, std::string_view of_what) {
        if (!is_terminal_ || Clock::now() - shown_ < std::chrono::milliseconds(200)) return;
        shown_ = Clock::now();
        fmt::print(stderr, "\r{} runs, {} {}", runs, count, of_what);
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
