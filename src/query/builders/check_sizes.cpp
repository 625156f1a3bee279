#include "query/builders/check_sizes.hpp"

#include <bit>

#include "base/double_key.hpp"
#include "base/make_error.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods::builders {

void require_size(const std::string& part, double value) {
    // Compares keys, since comparisons of doubles may take subnormal numbers for zero.
    if (!is_finite(value) || key_of(value) <= 0) throw invalid_size(part, value);
}

// Returns half of the number, computed from its bits: the exponent becomes one less; a subnormal number, and the least
// normal ones, lose their last digit, which must be 0.
double require_half(const std::string& part, double value) {
    require_size(part, value);
    constexpr std::uint64_t exponent_one = std::uint64_t{1} << 52;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    if (bits >= 2 * exponent_one) return std::bit_cast<double>(bits - exponent_one);
    if (bits % 2 != 0) throw size_not_even(part, value);
    return std::bit_cast<double>(bits / 2);
}

void require_count(const std::string& part, std::size_t count, std::size_t min, std::size_t max) {
    if (count < min || count > max) throw invalid_count(part, count, min, max);
}

}  // namespace ecods::builders
