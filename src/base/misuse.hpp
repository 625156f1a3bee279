// A program's own mistakes are reported to the misuse handler before they are thrown.
#pragma once

#include "ecods/error.hpp"

namespace ecods {

// Calls the handler that set_misuse_handler installed, if any.
void report_misuse(const Error& error);

template <class SomeError>
[[noreturn]] void throw_misuse(const SomeError& error) {
    report_misuse(error);
    throw error;
}

}  // namespace ecods
