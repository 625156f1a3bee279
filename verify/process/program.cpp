#include "process/program.hpp"

#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>

extern char** environ;

namespace ecods::process {

namespace {

// Where a program's three streams come from and go to. None: /dev/null for the input, this process's for the errors.
struct Streams {
    const Descriptor& in;
    const Descriptor& out;
    const Descriptor& err;
};

// Negative when it cannot be started.
pid_t start(const std::vector<std::string>& arguments, const Streams& streams) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (streams.in.number() < 0) {
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", 0, 0);
    } else {
        posix_spawn_file_actions_adddup2(&actions, streams.in.number(), STDIN_FILENO);
    }
    posix_spawn_file_actions_adddup2(&actions, streams.out.number(), STDOUT_FILENO);
    if (streams.err.number() >= 0) posix_spawn_file_actions_adddup2(&actions, streams.err.number(), STDERR_FILENO);
    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    pid_t child = -1;
    const int failure = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failure == 0 ? child : -1;
}

// Whether there was something before the end.
bool append_from(const Descriptor& file, std::string& text) {
    std::array<char, 4096> part;
    const ssize_t count = read(file.number(), part.data(), part.size());
    if (count < 0 && errno == EINTR) return true;
    if (count > 0) text.append(part.data(), static_cast<std::size_t>(count));
    return count > 0;
}

// Both at once, since a program waits while one of its pipes is full.
void read_both(Descriptor& out, Descriptor& err, ProgramResult& result) {
    while (out.number() >= 0 || err.number() >= 0) {
        std::array<pollfd, 2> ready{pollfd{out.number(), POLLIN, 0}, pollfd{err.number(), POLLIN, 0}};
        if (poll(ready.data(), ready.size(), -1) < 0) continue;
        if (ready[0].revents != 0 && !append_from(out, result.out)) out.close();
        if (ready[1].revents != 0 && !append_from(err, result.err)) err.close();
    }
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& arguments) {
    Pipe out = make_pipe(), err = make_pipe();
    const pid_t child = start(arguments, {Descriptor(), out.in, err.in});
    out.in.close();
    err.in.close();
    if (child < 0) return {127, "", arguments.at(0) + " cannot be started"};
    ProgramResult result;
    read_both(out.out, err.out, result);
    const int status = wait_for(child);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
}

Conversation::Conversation(const std::vector<std::string>& arguments) : name_(arguments.at(0)) {
    Pipe input = make_pipe(), output = make_pipe();
    child_ = start(arguments, {input.out, output.in, Descriptor()});
    if (child_ < 0) throw std::runtime_error(name_ + " cannot be started");
    to_child_ = std::move(input.in);
    from_child_ = std::move(output.out);
}

Conversation::~Conversation() {
    to_child_.close();
    from_child_.close();
    wait_for(child_);
}

std::string Conversation::read_line() {
    while (buffer_.find('\n') == std::string::npos) {
        if (!append_from(from_child_, buffer_)) throw std::runtime_error(name_ + " ended without an answer");
    }
    const std::size_t end = buffer_.find('\n');
    std::string line = buffer_.substr(0, end);
    buffer_.erase(0, end + 1);
    return line;
}

std::string Conversation::ask(const std::string& line) {
    const std::string text = line + '\n';
    if (!write_all(to_child_, text.data(), text.size())) throw std::runtime_error(name_ + " takes no questions");
    return read_line();
}

}  // namespace ecods::process
