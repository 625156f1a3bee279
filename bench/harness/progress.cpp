#include "harness/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace ecods::bench {

Progress::Progress(std::string label, std::size_t step_count)
    : label_(std::move(label)), step_count_(step_count), is_shown_(isatty(STDERR_FILENO) == 1) {
    if (is_shown_) fmt::print(stderr, "\r\033[K{}", label_);
}

Progress::~Progress() {
    if (is_shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::step() {
    const std::lock_guard lock(mutex_);
    ++done_;
    const auto now = std::chrono::steady_clock::now();
    if (!is_shown_ || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    fmt::print(stderr, "\r\033[K{}: {} of {}", label_, done_, step_count_);
}

}  // namespace ecods::bench
