// Numbers as text that is the same in every locale: decimal and hexadecimal.
#pragma once

#include <cstdint>
#include <string>

namespace ecods {

// The shortest hexadecimal form, which is exact: -0x1.8p+3. A whole number without 0x.
void append_hex(std::string& text, double x);
void append_hex(std::string& text, std::uint64_t x);

void append(std::string& text, std::uint64_t x);  // decimal

}  // namespace ecods
