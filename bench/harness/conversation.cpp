#include "harness/conversation.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>

extern char** environ;

namespace ecods::bench {

namespace {

std::array<int, 2> make_pipe() {
    std::array<int, 2> ends{};
    // Not handed on: each program sees the end of its input although another one was started after it.
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    return ends;
}

}  // namespace

Conversation::Conversation(const std::vector<std::string>& arguments) : name_(arguments.at(0)) {
    const std::array<int, 2> input = make_pipe(), output = make_pipe();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const int failure = posix_spawnp(&child_, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(input[0]);
    close(output[1]);
    to_child_ = input[1];
    from_child_ = output[0];
    if (failure != 0) {
        close(to_child_);
        close(from_child_);
        throw std::runtime_error(name_ + " cannot be started");
    }
    std::signal(SIGPIPE, SIG_IGN);  // an end of the program shows in the result of write
}

Conversation::~Conversation() {
    close(to_child_);
    close(from_child_);
    waitpid(child_, nullptr, 0);
}

std::string Conversation::read_line() {
    for (std::size_t end; (end = buffer_.find('\n')) == std::string::npos;) {
        std::array<char, 4096> part;
        const ssize_t count = read(from_child_, part.data(), part.size());
        if (count <= 0) throw std::runtime_error(name_ + " ended without an answer");
        buffer_.append(part.data(), static_cast<std::size_t>(count));
    }
    const std::size_t end = buffer_.find('\n');
    std::string line = buffer_.substr(0, end);
    buffer_.erase(0, end + 1);
    return line;
}

std::string Conversation::ask(const std::string& line) {
    const std::string text = line + '\n';
    // A question is short: it fits into the pipe at once.
    if (write(to_child_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
        throw std::runtime_error(name_ + " takes no questions");
    return read_line();
}

}  // namespace ecods::bench
