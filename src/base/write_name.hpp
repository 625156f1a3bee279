// write_name writes the names of enumerators to a stream.
#pragma once

#include <array>
#include <cstddef>
#include <ostream>

namespace ecods {

// Writes names[value], or the value as a number if value >= count.
template <class Enum, std::size_t count>
std::ostream& write_name(std::ostream& out, Enum value, const std::array<const char*, count>& names) {
    const auto at = static_cast<std::size_t>(value);
    return at < count ? out << names[at] : out << at;
}

}  // namespace ecods
