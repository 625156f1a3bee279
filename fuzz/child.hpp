// Work in a process of its own: a crash or a hang there is an answer here.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>

namespace ecods::fuzz {

struct ChildEnd {
    std::string output = {};  // what the work returned; empty if it did not
    std::string how = {};     // empty: it returned; else "crash" or "hang"
    std::string detail = {};  // of a crash or hang
};

// The process must have one thread when a child is made.
class Child {
  public:
    // Begins at once. More processor time than that, or twenty times that time on the clock, is a hang.
    Child(const std::function<std::string()>& work, unsigned seconds_max);
    Child(Child&& other) noexcept;
    Child& operator=(Child&&) = delete;
    ~Child();  // kills it if it still runs

    // Readable when there is something to receive.
    int descriptor() const noexcept { return pipe_; }

    // Takes what is there. Whether the child is still at work.
    bool receive();

    // Waits for the end.
    ChildEnd end();

  private:
    using Clock = std::chrono::steady_clock;
    bool is_late() const { return Clock::now() - start_ > std::chrono::seconds(20 * seconds_max_); }

    pid_t process_ = -1;
    int pipe_ = -1;
    unsigned seconds_max_;
    Clock::time_point start_ = Clock::now();
    bool was_late_ = false;
    std::string output_ = {};
};

// One child, from beginning to end.
ChildEnd run_in_child(const std::function<std::string()>& work, unsigned seconds_max);

}  // namespace ecods::fuzz
