// One line on the terminal that tells how far a long piece of work is. In a pipe or file it stays quiet.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace ecods::bench {

class Progress {
  public:
    Progress(std::string label, std::size_t step_count);
    ~Progress();  // wipes the line
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void step();  // from any thread

  private:
    std::string label_;
    std::size_t step_count_;
    std::size_t done_ = 0;
    bool is_shown_;
    std::chrono::steady_clock::time_point last_;
    std::mutex mutex_;
};

}  // namespace ecods::bench
