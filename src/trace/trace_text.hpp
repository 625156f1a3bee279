// Converts numbers and names to the text of a trace and back.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ecods/broad_phase.hpp"
#include "ecods/ids.hpp"
#include "geometry/words.hpp"

namespace ecods {

// A trace begins with one of these lines. In version 1, solids collided as their surfaces.
inline constexpr std::string_view trace_header = "ecods-trace 2", old_trace_header = "ecods-trace 1";

// A TracedBody names a body as a trace does, by slot and generation in the world that wrote the trace. It is not an id
// in any other world.
struct TracedBody {
    std::uint32_t slot = 0;
    std::uint32_t generation = 0;
    friend constexpr bool operator==(const TracedBody&, const TracedBody&) = default;
};
constexpr TracedBody traced(BodyId body) noexcept {
    return {body.slot, body.generation};
}

// These parsers return nullopt unless the whole word is a number or a name of their kind.
std::optional<double> parse_hex_double(std::string_view word);  // only finite numbers
std::optional<std::uint64_t> parse_hex(std::string_view word);
std::optional<std::uint64_t> parse_decimal(std::string_view word, std::uint64_t max);
std::optional<TracedBody> parse_body(std::string_view word);

std::string_view name_of(BroadPhaseKind kind) noexcept;
std::optional<BroadPhaseKind> parse_broad_phase(std::string_view word);

}  // namespace ecods
