// The system's handles of pipes and processes.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <utility>

namespace ecods::process {

// A file descriptor that is closed with its owner. Negative: none.
class Descriptor {
  public:
    Descriptor() = default;
    explicit Descriptor(int number) noexcept : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }

    int number() const noexcept { return number_; }
    void close() noexcept;

  private:
    int number_ = -1;
};

struct Pipe {
    Descriptor out;  // to read from
    Descriptor in;   // to write to
};

// Programs that are started do not inherit it. Throws std::runtime_error where the system gives no more.
Pipe make_pipe();

// Whether all was written. From the first call on, a reader that is gone is an error and ends nobody.
bool write_all(const Descriptor& file, const void* data, std::size_t size);

// Waits for the end of a child process, and returns the status that waitpid() gives.
int wait_for(pid_t child);

}  // namespace ecods::process
