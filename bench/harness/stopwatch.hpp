// Processor time of this process, in all its threads. Every engine here works in one thread, so on a machine of its own
// this is the time that passes; on a busy one it leaves out what others took.
#pragma once

#include <ctime>

namespace ecods::bench {

class Stopwatch {
  public:
    double nanoseconds() const { return now() - start_; }

  private:
    static double now() {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
    }

    double start_ = now();
};

// So long an engine works untimed before its frames are timed: a core that another engine had takes milliseconds to be
// as quick as it is from then on, and all frames of a quick engine are over in as many.
inline constexpr double warm_up_ns = 20e6;

}  // namespace ecods::bench
