// The main function that all programs share.
#pragma once

#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

#include "programs/command_line.hpp"

namespace ecods::programs {

// Prints each line of an error behind the program's name. Asks for no memory, as there may be none.
inline void print_error(const char* program, std::string_view lines) {
    for (bool has_line = true; has_line;) {
        const std::size_t end = lines.find('\n');
        has_line = end != std::string_view::npos;
        const std::string_view line = lines.substr(0, end);
        std::fprintf(stderr, "%s: %.*s\n", program, static_cast<int>(line.size()), line.data());
        if (has_line) lines.remove_prefix(end + 1);
    }
}

// The exit status of run(argc, argv), or exit_misused if it throws: the error is printed then. A size that no memory
// could have is out of memory, too.
inline int run_main(const char* program, int argc, char** argv, int (*run)(int, char**)) {
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        print_error(program, "out of memory");
    } catch (const std::length_error&) {
        print_error(program, "out of memory");
    } catch (const std::exception& error) {
        print_error(program, error.what());
    }
    return exit_misused;
}

}  // namespace ecods::programs
