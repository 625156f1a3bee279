// What is known of the first time at which two triangles on their way share a point, and of the features they do on.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>

#include "ecods/cast.hpp"

namespace ecods {

// One vertex, edge or face by what it is made of, which is the same from every triangle that has it: a vertex by its
// index and `none`; an edge by the indices of its ends, the lesser first; a face by its triangle's index twice.
struct ContactFeature {
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::uint32_t first = none;
    std::uint32_t second = none;

    friend auto operator<=>(const ContactFeature&, const ContactFeature&) = default;
};

struct ContactInterval {
    // From time 0 on there is no contact before; infinity if there is none. 0 says nothing.
    double lower = 0;
    // The first contact is not later; infinity if it is not known whether there is one.
    double upper = std::numeric_limits<double>::infinity();

    // Where this is set, the first contact is at one point, inside these two features and no others. Pairs of triangles
    // that have the same features have the same first contact.
    bool is_certain = false;
    FirstContact contact;  // by these triangles; `time` is not set
    ContactFeature a, b;
};

// The order in which one of several is chosen.
inline auto rank(const FirstContact& c) noexcept {
    return std::tuple(c.kind, c.a.triangle, c.a.corner, c.b.triangle, c.b.corner, c.a.kind);
}

// The first of the open contacts of a sieve by their rounded times and ranks; round(open) gives that of a pair, if
// there is one.
template <class Sieve, class Round>
std::optional<FirstContact> first_contact(Sieve& sieve, Round&& round) {
    return sieve.least([&](const auto& open, const auto&) { return round(open); },
                       [](const FirstContact& c) { return c.time; }, [](const FirstContact& c) { return rank(c); });
}

}  // namespace ecods
