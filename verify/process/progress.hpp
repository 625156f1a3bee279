// One line on the terminal that says how far a long piece of work is. Nothing where the error stream is a pipe or file.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace ecods::process {

// Calls may come from any thread.
class Progress {
  public:
    Progress() : Progress("", 0) {}
    Progress(std::string label, std::size_t step_count);  // shows the label
    ~Progress();                                          // wipes the line
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void step();                         // shows "label: 3 of 7", seldom enough to cost nothing
    void show(const std::string& text);  // likewise, in place of the steps
    void wipe();                         // until something is shown again: before something else is printed

  private:
    void show_at_times(const std::string& text);

    std::string label_;
    std::size_t step_count_;
    std::size_t done_ = 0;
    bool is_terminal_;
    bool is_shown_ = false;
    std::chrono::steady_clock::time_point last_ = {};
    std::mutex mutex_;
};

}  // namespace ecods::process
