// Numbers become text that is the same in every locale: decimal and hexadecimal.
#pragma once

#include <cstdint>
#include <string>

namespace ecods {

// Append the shortest hexadecimal form. A double is exact, as in -0x1.8p+3; a whole number has no 0x.
void append_hex(std::string& text, double x);
void append_hex(std::string& text, std::uint64_t x);

void append(std::string& text, std::uint64_t x);  // in decimal

}  // namespace ecods
