// Errors about a program's own mistakes are passed to the misuse handler, and then thrown.
#pragma once

#include "ecods/error.hpp"

namespace ecods {

// Passes the error to the handler that set_misuse_handler installed, if there is one.
void report_misuse(const Error& error);

template <class SomeError>
[[noreturn]] void throw_misuse(const SomeError& error) {
    report_misuse(error);
    throw error;
}

}  // namespace ecods
