// Ids and lists of pairs, as failures show them.
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>

#include "ecods/ids.hpp"
#include "ecods/predicates.hpp"

namespace ecods::fuzz {

inline std::string text(BodyId body) {
    return fmt::format("{}.{}", body.slot, body.generation);
}

inline std::string text(const BodyPair& pair) {
    return text(pair.a) + "-" + text(pair.b);
}

inline std::string text(const TrianglePair& pair) {
    return fmt::format("{}-{}", pair.a, pair.b);
}

inline std::string text(Relation relation) {
    return relation == Relation::disjoint ? "disjoint" : relation == Relation::touching ? "touching" : "crossing";
}

// The first few; how many there are in all.
template <class Item>
std::string text(std::span<const Item> items) {
    constexpr std::size_t shown_max = 12;
    std::string result = fmt::format("{} [", items.size());
    for (std::size_t i = 0; i < items.size() && i < shown_max; ++i) result.append(i == 0 ? "" : " ") += text(items[i]);
    return result.append(items.size() > shown_max ? " ...]" : "]");
}

}  // namespace ecods::fuzz
