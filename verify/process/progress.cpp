#include "process/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace ecods::process {

namespace {

void print_line(const std::string& text) {
    fmt::print(stderr, "\r\033[K{}", text);
}

}  // namespace

Progress::Progress(std::string label, std::size_t step_count)
    : label_(std::move(label)),
      step_count_(step_count),
      is_terminal_(isatty(STDERR_FILENO) == 1),
      is_shown_(is_terminal_ && !label_.empty()) {
    if (is_shown_) print_line(label_);
}

Progress::~Progress() {
    wipe();
}

void Progress::wipe() {
    const std::lock_guard lock(mutex_);
    if (is_shown_) print_line("");
    is_shown_ = false;
}

void Progress::step() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (is_terminal_) show_at_times(fmt::format("{}: {} of {}", label_, done_, step_count_));
}

void Progress::show(const std::string& text) {
    const std::lock_guard lock(mutex_);
    if (is_terminal_) show_at_times(text);
}

void Progress::show_at_times(const std::string& text) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    is_shown_ = true;
    print_line(text);
}

}  // namespace ecods::process
