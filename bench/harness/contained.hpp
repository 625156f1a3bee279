// Runs an engine in a process of its own, so that one that crashes, hangs or throws is named and the others go on.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace ecods::bench {

// What one run gave; numbers of any meaning. When it failed, the reason in words.
struct Outcome {
    std::vector<double> values;
    std::string failure;

    bool is_right() const { return failure.empty(); }
};

// A child process that waits for its turn. Everything that exists when it is made is there in the child, too, and
// nothing that the child does comes back but the values. Make it while the program has one thread.
class Contained {
  public:
    using Run = std::function<std::vector<double>()>;

    // `set_up` is called in the child, at the first turn; what it returns, at every turn. A turn that takes longer than
    // the limit ends the child.
    Contained(std::function<Run()> set_up, std::chrono::seconds limit);
    ~Contained();  // ends the child
    Contained(Contained&& other) noexcept;
    Contained(const Contained&) = delete;
    Contained& operator=(const Contained&) = delete;
    Contained& operator=(Contained&&) = delete;

    // One turn. After a failure, all further turns fail in the same way.
    Outcome run();

  private:
    Outcome fail(const std::string& reason);

    std::chrono::seconds limit_;
    pid_t child_ = -1;
    int to_child_ = -1;
    int from_child_ = -1;
    std::string failure_;
};

// Keeps the calling process on one of the processors that it may use, the last. Does nothing where that is refused.
void pin_to_one_processor();

}  // namespace ecods::bench
