// Another program that answers a line with a line.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace ecods::bench {

class Conversation {
  public:
    // Starts it, without a shell. Throws std::runtime_error when it cannot be started.
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
    int to_child_ = -1;
    int from_child_ = -1;
    std::string buffer_;  // read, but not asked for yet
};

}  // namespace ecods::bench
