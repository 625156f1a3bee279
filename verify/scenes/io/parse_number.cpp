#include "scenes/io/parse_number.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

namespace ecods::scenes {
namespace {

// The exponent after an e, held within +-2^62: far beyond the length of any word, so that sums with that do not wrap.
std::int64_t exponent_of(std::string_view digits) {
    constexpr std::int64_t limit = std::int64_t{1} << 62;
    const bool is_negative = digits.starts_with('-');
    if (is_negative || digits.starts_with('+')) digits.remove_prefix(1);
    std::int64_t value = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (result.ec != std::errc() || value > limit) value = limit;
    return is_negative ? -value : value;
}

// The double nearest to a decimal that from_chars finds beyond the range: it gives no value, and does not say on which
// side. All doubles but zero lie between 1e-400 and 1e400, so the place of the first digit decides.
double beyond_range(std::string_view word) {
    const bool is_negative = word.starts_with('-');
    const std::size_t e = std::min(word.find_first_of("eE"), word.size());
    const std::string_view digits = word.substr(0, e);
    const std::size_t first = std::min(digits.find_first_of("123456789"), digits.size());
    const std::size_t point = std::min(digits.find('.'), digits.size());
    std::int64_t place = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
    if (e < word.size()) place += exponent_of(word.substr(e + 1));
    const double magnitude = place > 0 && first < digits.size() ? std::numeric_limits<double>::infinity() : 0;
    return is_negative ? -magnitude : magnitude;
}

}  // namespace

bool parse_number(std::string_view word, double& value) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    const char* end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, value);
    if (result.ptr != end || word.empty()) return false;
    if (result.ec == std::errc::result_out_of_range) value = beyond_range(word);
    return result.ec != std::errc::invalid_argument;
}

bool parse_integer(std::string_view word, std::int64_t& value) {
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

}  // namespace ecods::scenes
