#include "process/contained.hpp"

#include <fmt/core.h>
#include <poll.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>

namespace ecods::process {

namespace {

// A reply as bytes: this, the numbers, the text.
struct Head {
    std::size_t value_count = 0;
    std::size_t text_size = 0;
    bool has_thrown = false;  // the text is the exception's

    std::size_t size() const { return sizeof(Head) + value_count * sizeof(double) + text_size; }
};

bool send(const Descriptor& to, const Reply& reply, bool has_thrown) {
    Head head;
    head.value_count = reply.values.size();
    head.text_size = reply.text.size();
    head.has_thrown = has_thrown;
    return write_all(to, &head, sizeof head) &&
           write_all(to, reply.values.data(), reply.values.size() * sizeof(double)) &&
           write_all(to, reply.text.data(), reply.text.size());
}

void limit_child(const Limits& limits) {
    // No file of a crash.
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    if (limits.processor.count() > 0) {
        const auto seconds = static_cast<rlim_t>(limits.processor.count());
        const rlimit time{seconds, seconds + 5};
        setrlimit(RLIMIT_CPU, &time);
    }
    if (limits.is_pinned) pin_to_one_processor();
}

// The child's life: a byte is a turn, the end of the pipe is the end.
[[noreturn]] void serve(const std::function<Contained::Run()>& set_up, const Descriptor& from_parent,
                        const Descriptor& to_parent) {
    Contained::Run run;
    for (char turn = 0; read(from_parent.number(), &turn, 1) == 1;) {
        Reply reply{std::string()};
        bool has_thrown = false;
        try {
            if (!run) run = set_up();
            reply = run();
        } catch (const std::exception& error) {
            reply = std::string(error.what());
            has_thrown = true;
        } catch (...) {
            reply = std::string("an unknown exception");
            has_thrown = true;
        }
        if (!send(to_parent, reply, has_thrown)) break;
    }
    // No destructors: the objects are copies of the parent's, and an engine may hang in its own.
    std::fflush(stdout);
    _exit(0);
}

}  // namespace

Contained::Contained(const std::function<Run()>& set_up, const Limits& limits) : limits_(limits) {
    Pipe down = make_pipe(), up = make_pipe();
    // The child must not print again what the parent had not yet printed.
    std::fflush(nullptr);
    child_ = fork();
    if (child_ < 0) throw std::runtime_error(std::string("no process: ") + std::strerror(errno));
    if (child_ == 0) {
        down.in.close();
        up.out.close();
        limit_child(limits);
        serve(set_up, down.out, up.in);
    }
    to_child_ = std::move(down.in);
    from_child_ = std::move(up.out);
}

Contained::Contained(Contained&& other) noexcept
    : limits_(other.limits_),
      child_(std::exchange(other.child_, -1)),
      to_child_(std::move(other.to_child_)),
      from_child_(std::move(other.from_child_)),
      is_at_work_(other.is_at_work_),
      deadline_(other.deadline_),
      buffer_(std::move(other.buffer_)),
      outcome_(std::move(other.outcome_)) {}

Contained::~Contained() {
    // A later child has inherited the pipe, so that its end may not be seen: the child is ended, not asked.
    if (child_ <= 0) return;
    kill(child_, SIGKILL);
    wait_for(child_);
}

void Contained::fail(End end, std::string reason) {
    is_at_work_ = false;
    outcome_ = {.values = {}, .text = {}, .end = end, .failure = std::move(reason)};
}

// The child closed its pipe: it has ended.
void Contained::fail_by_end() {
    const int status = wait_for(std::exchange(child_, -1));
    if (!WIFSIGNALED(status)) return fail(End::crashed, fmt::format("ended with status {}", WEXITSTATUS(status)));
    if (WTERMSIG(status) == SIGXCPU)
        return fail(End::hung, fmt::format("took longer than {} s of processor time", limits_.processor.count()));
    fail(End::crashed, fmt::format("crashed ({})", strsignal(WTERMSIG(status))));
}

void Contained::begin() {
    if (!outcome_.is_right()) return;
    buffer_.clear();
    is_at_work_ = true;
    deadline_ = Clock::now() + limits_.clock;
    const char turn = 1;
    if (!write_all(to_child_, &turn, 1)) fail_by_end();
}

bool Contained::receive() {
    if (!is_at_work_) return false;
    if (Clock::now() > deadline_) {
        kill(child_, SIGKILL);
        wait_for(std::exchange(child_, -1));
        fail(End::hung, fmt::format("took longer than {} s", limits_.clock.count()));
        return false;
    }
    pollfd ready{descriptor(), POLLIN, 0};
    if (poll(&ready, 1, 0) <= 0) return true;
    std::array<char, 65536> part;
    const ssize_t count = read(descriptor(), part.data(), part.size());
    if (count < 0 && errno == EINTR) return true;
    if (count <= 0) {
        fail_by_end();
    } else {
        buffer_.append(part.data(), static_cast<std::size_t>(count));
        parse();
    }
    return is_at_work_;
}

// The reply, if it is there as a whole.
void Contained::parse() {
    Head head;
    if (buffer_.size() < sizeof head) return;
    std::memcpy(&head, buffer_.data(), sizeof head);
    if (buffer_.size() < head.size()) return;
    const char* values = buffer_.data() + sizeof head;
    const std::size_t value_bytes = head.value_count * sizeof(double);
    std::string text(values + value_bytes, head.text_size);
    if (head.has_thrown) return fail(End::threw, "threw: " + text);
    is_at_work_ = false;
    outcome_ = {.values = std::vector<double>(head.value_count), .text = std::move(text)};
    if (value_bytes > 0) std::memcpy(outcome_.values.data(), values, value_bytes);
}

Outcome Contained::end() {
    while (receive()) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
        pollfd ready{descriptor(), POLLIN, 0};
        poll(&ready, 1, static_cast<int>(std::clamp<std::int64_t>(left + 1, 0, 1000)));
    }
    return outcome_;
}

Outcome Contained::run() {
    begin();
    return end();
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

}  // namespace ecods::process
