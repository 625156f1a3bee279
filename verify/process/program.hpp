// Other programs: run to their end, or talked with line by line. They are started without a shell.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "process/descriptor.hpp"

namespace ecods::process {

struct ProgramResult {
    int status = 0;   // 127: it cannot be started; 128 and more: it was ended by the signal of that number less 128
    std::string out;  // standard output
    std::string err;  // standard errors

    std::string text() const { return out + err; }
};

// Runs a program to its end, without input.
ProgramResult run_program(const std::vector<std::string>& arguments);

// A program that answers a line with a line.
class Conversation {
  public:
    // Throws std::runtime_error when it cannot be started.
    explicit Conversation(const std::vector<std::string>& arguments);
    ~Conversation();  // closes the program's input and waits for its end
    Conversation(const Conversation&) = delete;
    Conversation& operator=(const Conversation&) = delete;

    // The program's next line, without its end; waits for it. Throws std::runtime_error when the program has ended.
    std::string read_line();

    // Sends a line and reads the answer.
    std::string ask(const std::string& line);

  private:
    std::string name_;
    pid_t child_ = -1;
    Descriptor to_child_;
    Descriptor from_child_;
    std::string buffer_;  // read, but not asked for yet
};

}  // namespace ecods::process
