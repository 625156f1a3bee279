#include "trace/trace_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "geometry/find_invalid.hpp"

namespace ecods {
namespace {

// Lists the names, in the order of the values of BroadPhaseKind.
static_assert(static_cast<int>(BroadPhaseKind::brute_force) == 0 && static_cast<int>(BroadPhaseKind::automatic) == 3);
constexpr std::array<std::string_view, 4> broad_phase_names = {"brute_force", "sweep_and_prune", "kept_candidates",
                                                               "automatic"};

template <class Number, class... How>
std::optional<Number> parse_chars(std::string_view word, How... how) {
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number, how...);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return number;
}

}  // namespace

std::optional<double> parse_hex_double(std::string_view word) {
    const bool is_negative = word.starts_with('-');
    if (is_negative) word.remove_prefix(1);
    if (!word.starts_with("0x")) return std::nullopt;
    word.remove_prefix(2);
    if (word.starts_with('-')) return std::nullopt;
    const auto number = parse_chars<double>(word, std::chars_format::hex);
    if (!number || !is_finite(*number)) return std::nullopt;
    return is_negative ? -*number : *number;
}

std::optional<std::uint64_t> parse_hex(std::string_view word) {
    return parse_chars<std::uint64_t>(word, 16);
}

std::optional<std::uint64_t> parse_decimal(std::string_view word, std::uint64_t max) {
    const auto number = parse_chars<std::uint64_t>(word);
    return number && *number <= max ? number : std::nullopt;
}

std::optional<TracedBody> parse_body(std::string_view word) {
    const std::size_t dot = word.find('.');
    if (dot == std::string_view::npos) return std::nullopt;
    const auto slot = parse_chars<std::uint32_t>(word.substr(0, dot));
    const auto generation = parse_chars<std::uint32_t>(word.substr(dot + 1));
    if (!slot || *slot == 0 || !generation) return std::nullopt;
    return TracedBody{*slot, *generation};
}

std::string_view name_of(BroadPhaseKind kind) noexcept {
    return broad_phase_names[static_cast<std::size_t>(kind)];
}

std::optional<BroadPhaseKind> parse_broad_phase(std::string_view word) {
    const auto* const found = std::ranges::find(broad_phase_names, word);
    if (found == broad_phase_names.end()) return std::nullopt;
    return static_cast<BroadPhaseKind>(found - broad_phase_names.begin());
}

}  // namespace ecods
