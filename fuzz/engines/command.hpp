// An engine that is a program of any language: it is asked by lines of JSON on a pipe (README.md here).
#pragma once

#include <string>

#include "fuzz/engines/engine_under_test.hpp"

namespace ecods::fuzz {

// The command is one for the shell, which becomes it ("exec COMMAND"): no pipes, no "&&". It ends with the process that
// made the engine, however that ends. What it says on its error stream is shown. An answer that is none throws.
EngineMaker command_engine(const std::string& name, const std::string& command);

}  // namespace ecods::fuzz
