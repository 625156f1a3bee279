// Checks the numbers that callers pass to builders.
#pragma once

#include <cstdint>
#include <string>

namespace ecods::builders {

// Throws InvalidArgument, which names `part`, unless the number is finite and positive.
void require_size(const std::string& part, double value);

// Returns half of the number. Throws InvalidArgument, which names `part`, unless the number is finite and positive and
// its half is a double.
double require_half(const std::string& part, double value);

// Throws InvalidArgument, which names `part`, unless the number is in the range.
void require_count(const std::string& part, std::size_t count, std::size_t min, std::size_t max);

}  // namespace ecods::builders
