#include "harness/contained.hpp"

#include <fmt/core.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <utility>

namespace ecods::bench {

namespace {

using Clock = std::chrono::steady_clock;

bool write_all(int file, const void* data, std::size_t size) {
    const char* at = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t count = write(file, at, size);
        if (count <= 0) return false;
        at += count;
        size -= static_cast<std::size_t>(count);
    }
    return true;
}

enum class Read { done, closed, late };

Read read_all(int file, void* data, std::size_t size, Clock::time_point deadline) {
    char* at = static_cast<char*>(data);
    while (size > 0) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) return Read::late;
        pollfd ready{file, POLLIN, 0};
        if (poll(&ready, 1, static_cast<int>(left)) <= 0) continue;
        const ssize_t count = read(file, at, size);
        if (count <= 0) return Read::closed;
        at += count;
        size -= static_cast<std::size_t>(count);
    }
    return Read::done;
}

// A reply: the number of values and of bytes of an error message, then these.
struct Head {
    std::size_t value_count = 0;
    std::size_t message_size = 0;
};

// The child's life: a byte is a turn, the end of the pipe is the end.
[[noreturn]] void serve(const std::function<Contained::Run()>& set_up, int from_parent, int to_parent) {
    pin_to_one_processor();
    Contained::Run run;
    for (char turn = 0; read(from_parent, &turn, 1) == 1;) {
        std::vector<double> values;
        std::string message;
        try {
            if (!run) run = set_up();
            values = run();
        } catch (const std::exception& error) {
            message = error.what();
        } catch (...) {
            message = "an unknown exception";
        }
        const Head head{values.size(), message.size()};
        if (!write_all(to_parent, &head, sizeof head) ||
            !write_all(to_parent, values.data(), values.size() * sizeof(double)) ||
            !write_all(to_parent, message.data(), message.size()))
            break;
    }
    // No destructors: the objects are copies of the parent's, and an engine may hang in its own.
    std::fflush(stdout);
    _exit(0);
}

std::string end_of(pid_t child) {
    int status = 0;
    if (waitpid(child, &status, 0) != child) return "vanished";
    if (WIFSIGNALED(status)) return fmt::format("crashed ({})", strsignal(WTERMSIG(status)));
    return fmt::format("ended with status {}", WEXITSTATUS(status));
}

}  // namespace

Contained::Contained(std::function<Run()> set_up, std::chrono::seconds limit) : limit_(limit) {
    std::array<int, 2> down{}, up{};
    if (pipe(down.data()) != 0) {
        failure_ = "no pipe";
        return;
    }
    if (pipe(up.data()) != 0) {
        close(down[0]);
        close(down[1]);
        failure_ = "no pipe";
        return;
    }
    std::fflush(stdout);
    child_ = fork();
    if (child_ == 0) {
        close(down[1]);
        close(up[0]);
        serve(set_up, down[0], up[1]);
    }
    close(down[0]);
    close(up[1]);
    to_child_ = down[1];
    from_child_ = up[0];
    if (child_ < 0) failure_ = "no process";
}

Contained::Contained(Contained&& other) noexcept
    : limit_(other.limit_),
      child_(std::exchange(other.child_, -1)),
      to_child_(std::exchange(other.to_child_, -1)),
      from_child_(std::exchange(other.from_child_, -1)),
      failure_(std::move(other.failure_)) {}

Contained::~Contained() {
    if (to_child_ >= 0) close(to_child_);
    if (from_child_ >= 0) close(from_child_);
    // A later child has inherited the pipe, so that its end may not be seen: the child is ended, not asked.
    if (child_ > 0) {
        kill(child_, SIGKILL);
        waitpid(child_, nullptr, 0);
    }
}

Outcome Contained::fail(const std::string& reason) {
    failure_ = reason;
    return {{}, failure_};
}

Outcome Contained::run() {
    if (!failure_.empty()) return {{}, failure_};
    const char turn = 1;
    signal(SIGPIPE, SIG_IGN);  // a child that is gone shows in the result of write
    const Clock::time_point deadline = Clock::now() + limit_;
    Head head;
    Read state = write_all(to_child_, &turn, 1) ? read_all(from_child_, &head, sizeof head, deadline) : Read::closed;
    Outcome outcome;
    std::string message;
    if (state == Read::done) {
        outcome.values.resize(head.value_count);
        state = read_all(from_child_, outcome.values.data(), head.value_count * sizeof(double), deadline);
    }
    if (state == Read::done) {
        message.resize(head.message_size);
        state = read_all(from_child_, message.data(), head.message_size, deadline);
    }
    if (state == Read::late) {
        kill(child_, SIGKILL);
        end_of(std::exchange(child_, -1));
        return fail(fmt::format("took longer than {} s", limit_.count()));
    }
    if (state == Read::closed) return fail(end_of(std::exchange(child_, -1)));
    if (!message.empty()) return fail("threw: " + message);
    return outcome;
}

void pin_to_one_processor() {
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
    for (int i = CPU_SETSIZE - 1; i >= 0; --i) {
        if (!CPU_ISSET(i, &allowed)) continue;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(i, &one);
        sched_setaffinity(0, sizeof one, &one);
        return;
    }
}

}  // namespace ecods::bench
