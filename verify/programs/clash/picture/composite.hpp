// What is seen along one line of sight.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "programs/clash/picture/fragments.hpp"

namespace ecods::clash {

using Rgb = std::array<std::uint8_t, 3>;

constexpr Rgb background_color{244, 246, 249};
constexpr Rgb first_color{72, 136, 206};
constexpr Rgb second_color{243, 176, 62};
constexpr Rgb contact_color{216, 27, 67};
constexpr Rgb line_color{140, 0, 44};

// How the region that both parts fill is painted: in the color of contact, with stripes of the parts that are wholly in
// it.
struct Stripes {
    bool first = false;
    bool second = false;
};

struct Look {
    std::array<bool, 2> is_solid{};  // of the clash's parts: whether they have an inside
    Stripes stripes;
};

// A surface at a sample, for what contours are drawn along.
struct Surface {
    enum class Kind : std::uint8_t { none, first, second, context, contact, mark };

    Kind kind = Kind::none;
    std::array<std::int8_t, 3> normal = {};
    float depth = 0;

    // The kind and the normal as one number.
    std::uint32_t plane_key() const noexcept {
        return std::uint32_t{static_cast<std::uint8_t>(kind)} |
               std::uint32_t{static_cast<std::uint8_t>(normal[0])} << 8 |
               std::uint32_t{static_cast<std::uint8_t>(normal[1])} << 16 |
               std::uint32_t{static_cast<std::uint8_t>(normal[2])} << 24;
    }
};

struct Sample {
    Rgb color = background_color;
    Surface front;    // the first surface of the two parts, otherwise of the context
    Surface contact;  // of the contact, which is seen through what is in front of it
};

// Where the two parts have a contact behind the sample, it is seen through what hides it; elsewhere they are opaque.
// Fragments are those of one sample, from front to back.
Sample composite(std::span<const Fragment> fragments, std::size_t column, std::size_t row, const Look& look);

Rgb mix(const Rgb& a, const Rgb& b, double share_of_b);

}  // namespace ecods::clash
