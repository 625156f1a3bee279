// Every program that this object is linked to ends with status 2 and a message where its standard output cannot be
// written, so that nobody takes a report that was cut off for a whole one. A program calls nothing: as in closeout of
// GNU's portability library, the last flush is made, and looked at, when the program exits.
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace {

constexpr int exit_unwritten = 2;

std::terminate_handler terminate_before = nullptr;

// A file that a program opens must not get the number of a standard stream that was closed: text would be written into
// it. Input then is empty, messages are lost, and output is an error as soon as there is any.
void open_closed_streams() {
    constexpr std::array modes{O_RDONLY, O_RDONLY, O_WRONLY};
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
        const bool is_closed = fcntl(stream, F_GETFD) < 0 && errno == EBADF;
        // The number is the least that is free, which is this one.
        if (is_closed) open("/dev/null", modes[static_cast<std::size_t>(stream)]);
    }
}

[[noreturn]] void end_unwritten() {
    std::fprintf(stderr, "%s: standard output: cannot be written\n", program_invocation_short_name);
    _exit(exit_unwritten);
}

void check_at_exit() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) end_unwritten();
}

// An exception that leaves main may be what fmt throws where it cannot print, also to the stream of errors, where no
// message can be had.
void terminate() {
    if (std::ferror(stdout) != 0) end_unwritten();
    if (std::ferror(stderr) != 0) _exit(exit_unwritten);
    terminate_before();
    std::abort();
}

[[maybe_unused]] const bool is_checked = [] {
    open_closed_streams();
    terminate_before = std::set_terminate(terminate);
    return std::atexit(check_at_exit) == 0;
}();

}  // namespace
