#include "fuzz/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace ecods::fuzz {
namespace {

// What the child writes last: without it, it did not get to its end.
constexpr char end_mark = '\n';

[[noreturn]] void be_child(const std::function<std::string()>& work, unsigned seconds_max, int pipe) {
    // No file of a crash: the seed is enough.
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const rlimit time{seconds_max, seconds_max + 5};
    setrlimit(RLIMIT_CPU, &time);
    std::string text;
    int status = 0;
    try {
        text = work() + end_mark;
    } catch (const std::exception& error) {
        fmt::print(stderr, "ecods_fuzz: {}\n", error.what());
        status = 3;
    }
    for (std::size_t written = 0; written < text.size();) {
        const ssize_t count = write(pipe, text.data() + written, text.size() - written);
        if (count < 0 && errno != EINTR) break;
        if (count > 0) written += static_cast<std::size_t>(count);
    }
    // What the parent had not yet printed must not be printed twice.
    _exit(status);
}

}  // namespace

Child::Child(const std::function<std::string()>& work, unsigned seconds_max) : seconds_max_(seconds_max) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error(std::strerror(errno));
    std::fflush(nullptr);
    process_ = fork();
    if (process_ < 0) throw std::runtime_error(std::strerror(errno));
    if (process_ == 0) {
        close(ends[0]);
        be_child(work, seconds_max, ends[1]);
    }
    close(ends[1]);
    pipe_ = ends[0];
}

Child::Child(Child&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      pipe_(std::exchange(other.pipe_, -1)),
      seconds_max_(other.seconds_max_),
      start_(other.start_),
      was_late_(other.was_late_),
      output_(std::move(other.output_)) {}

Child::~Child() {
    if (pipe_ >= 0) close(pipe_);
    if (process_ < 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
}

bool Child::receive() {
    if (is_late()) {
        was_late_ = true;
        kill(process_, SIGKILL);
    }
    pollfd readable{pipe_, POLLIN, 0};
    if (poll(&readable, 1, 0) <= 0) return true;
    std::array<char, 65536> buffer;
    const ssize_t count = read(pipe_, buffer.data(), buffer.size());
    if (count > 0) output_.append(buffer.data(), static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && errno == EINTR);
}

ChildEnd Child::end() {
    for (bool goes_on = true; goes_on;) {
        pollfd readable{pipe_, POLLIN, 0};
        poll(&readable, 1, 1000);
        goes_on = receive();
    }
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    if (was_late_) return {.how = "hang", .detail = "time ran out on the clock"};
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGXCPU) {
            return {.how = "hang", .detail = fmt::format("{} seconds of processor time ran out", seconds_max_)};
        }
        return {.how = "crash", .detail = fmt::format("signal {}", strsignal(signal))};
    }
    if (output_.empty() || output_.back() != end_mark) {
        return {.how = "crash", .detail = fmt::format("exit status {}", WEXITSTATUS(status))};
    }
    output_.pop_back();
    return {.output = std::move(output_)};
}

ChildEnd run_in_child(const std::function<std::string()>& work, unsigned seconds_max) {
    return Child(work, seconds_max).end();
}

}  // namespace ecods::fuzz
