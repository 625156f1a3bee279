// Numbers and names as they stand in a trace, both ways.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ecods/broad_phase.hpp"
#include "ecods/ids.hpp"
#include "ecods/pose.hpp"

namespace ecods {

inline constexpr std::string_view trace_header = "ecods-trace 1";

void append_hex(std::string& text, double x);
void append_hex(std::string& text, std::uint64_t x);
void append(std::string& text, std::uint64_t x);  // decimal
void append(std::string& text, BodyId body);
void append(std::string& text, const Vec3& point);
void append(std::string& text, const Pose& pose);

// Nothing where the whole word is not what is asked for.
std::optional<double> parse_hex_double(std::string_view word);  // finite
std::optional<std::uint64_t> parse_hex(std::string_view word);
std::optional<std::uint64_t> parse_decimal(std::string_view word, std::uint64_t max);
std::optional<BodyId> parse_body(std::string_view word);

std::string name_of(BroadPhaseKind kind);
std::optional<BroadPhaseKind> parse_broad_phase(std::string_view word);

}  // namespace ecods
