// Numbers and names as they stand in a trace, both ways.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ecods/broad_phase.hpp"
#include "ecods/ids.hpp"
#include "geometry/words.hpp"

namespace ecods {

inline constexpr std::string_view trace_header = "ecods-trace 1";

// A body as a trace names it: slot and generation in the world that wrote the trace. It is no id of any other world.
struct TracedBody {
    std::uint32_t slot = 0;
    std::uint32_t generation = 0;
    friend constexpr bool operator==(const TracedBody&, const TracedBody&) = default;
};
constexpr TracedBody traced(BodyId body) noexcept {
    return {body.slot, body.generation};
}

// Nothing unless the whole word is such a number or name.
std::optional<double> parse_hex_double(std::string_view word);  // finite
std::optional<std::uint64_t> parse_hex(std::string_view word);
std::optional<std::uint64_t> parse_decimal(std::string_view word, std::uint64_t max);
std::optional<TracedBody> parse_body(std::string_view word);

std::string_view name_of(BroadPhaseKind kind) noexcept;
std::optional<BroadPhaseKind> parse_broad_phase(std::string_view word);

}  // namespace ecods
