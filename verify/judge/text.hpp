// Answers as text, and bit for bit the same: what the judges of all questions share.
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <sstream>
#include <string>

#include "ecods/results.hpp"
#include "ecods/shape.hpp"
#include "oracle/distance.hpp"

namespace ecods::judge {

inline bool same_bits(double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}

inline bool same_bits(const Vec3& x, const Vec3& y) {
    return same_bits(x[0], y[0]) && same_bits(x[1], y[1]) && same_bits(x[2], y[2]);
}

// In hexadecimal floats.
inline std::string text(const Vec3& v) {
    return fmt::format("({:a}, {:a}, {:a})", v[0], v[1], v[2]);
}

// "edge 7.2": of triangle 7, the one after corner 2.
inline std::string text(const Feature& feature) {
    constexpr const char* names[] = {"vertex", "edge", "face"};
    return fmt::format("{} {}.{}", names[static_cast<std::size_t>(feature.kind)], feature.triangle, feature.corner);
}

inline std::string text(ClosestKind kind) {
    constexpr const char* names[] = {"vertex-vertex", "vertex-edge", "vertex-face", "edge-edge", "intersecting"};
    return names[static_cast<std::size_t>(kind)];
}

// As its operator<< writes it.
template <class Answer>
std::string written(const Answer& answer) {
    std::ostringstream out;
    out << answer;
    return out.str();
}

// The body as the oracle takes it.
template <class Of>
oracle::Soup soup(const Posed<Of>& body) {
    return {body.what->mesh().vertices(), body.what->mesh().triangles(), body.pose};
}

}  // namespace ecods::judge
