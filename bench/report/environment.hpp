// The machine, the compiler and the versions that a report was made with.
#pragma once

#include <string>

#include "report/table.hpp"

namespace ecods::bench {

Table environment(const std::string& command);

}  // namespace ecods::bench
