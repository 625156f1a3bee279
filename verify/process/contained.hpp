// A function in a process of its own: when it crashes, hangs or throws, that is an answer here.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "process/descriptor.hpp"

namespace ecods::process {

// A turn's result in the child: numbers of any meaning, or any bytes.
struct Reply {
    Reply(std::vector<double> numbers) : values(std::move(numbers)) {}
    Reply(std::string bytes) : text(std::move(bytes)) {}

    std::vector<double> values = {};
    std::string text = {};
};

enum class End { returned, threw, crashed, hung };  // crashed: ended by a signal, or ended itself

// How a turn ended, and its reply if it returned; otherwise the reason in words.
struct Outcome {
    std::vector<double> values = {};
    std::string text = {};
    End end = End::returned;
    std::string failure = {};

    bool is_right() const { return end == End::returned; }
};

struct Limits {
    std::chrono::seconds clock;           // of a turn
    std::chrono::seconds processor = {};  // of all turns together, if positive
    bool is_pinned = true;                // whether the child keeps to one processor, so that times can be compared
};

// A child process that waits for its turn. Everything that exists when it is made is there in the child, too, and
// nothing that the child does comes back but the replies. Make it while the program has one thread.
class Contained {
  public:
    using Run = std::function<Reply()>;

    // `set_up` is called in the child, at the first turn; the function that it returns, at every turn. A turn beyond a
    // limit ends the child. Throws std::runtime_error where the system gives no process.
    Contained(const std::function<Run()>& set_up, const Limits& limits);
    Contained(const std::function<Run()>& set_up, std::chrono::seconds clock) : Contained(set_up, Limits{clock}) {}
    ~Contained();  // ends the child
    Contained(Contained&& other) noexcept;
    Contained(const Contained&) = delete;
    Contained& operator=(const Contained&) = delete;
    Contained& operator=(Contained&&) = delete;

    // One turn. After a failure, all further turns fail in the same way.
    Outcome run();

    // A turn in parts, beside those of other children: begin() it, then receive() until it no longer goes on, then take
    // the outcome by end(), which waits if need be.
    void begin();
    bool receive();  // takes in what is there; whether the turn goes on
    int descriptor() const noexcept { return from_child_.number(); }  // readable when there is something to receive
    Outcome end();

  private:
    using Clock = std::chrono::steady_clock;

    void fail(End end, std::string reason);
    void fail_by_end();
    void parse();

    Limits limits_;
    pid_t child_ = -1;
    Descriptor to_child_;
    Descriptor from_child_;
    bool is_at_work_ = false;
    Clock::time_point deadline_ = {};
    std::string buffer_ = {};  // of the reply, as far as it came
    Outcome outcome_ = {};
};

// Keeps the calling process on one of the processors that it may use, the last. Does nothing where that is refused.
void pin_to_one_processor();

}  // namespace ecods::process
