// Numbers are written as decimal or hexadecimal text, which does not depend on the locale.
#pragma once

#include <cstdint>
#include <string>

namespace ecods {

// Append the shortest hexadecimal text of x. A double is written exactly, for example -0x1.8p+3. An integer has no 0x.
void append_hex(std::string& text, double x);
void append_hex(std::string& text, std::uint64_t x);

void append(std::string& text, std::uint64_t x);  // in decimal

// Returns the shortest decimal that reads back as the same double; "nan", "inf" or "-inf" for other values.
std::string decimal_text(double x);

}  // namespace ecods
