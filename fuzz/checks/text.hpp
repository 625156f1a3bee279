// Ids, answers and lists of them, as failures show them.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ecods/ids.hpp"
#include "ecods/primitives.hpp"
#include "ecods/world.hpp"
#include "judge/text.hpp"

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
    return judge::written(relation);
}

inline std::string text(const FirstContact& contact) {
    return fmt::format("{:a} {}:{}", contact.time, contact.a.triangle, contact.b.triangle);
}

inline std::string text(const BodyContact& met) {
    return text(met.body) + " " + text(met.contact);
}

inline std::string text(const Meeting& meeting) {
    return text(meeting.bodies) + " " + text(meeting.contact);
}

inline std::string text(const BodyHit& hit) {
    return fmt::format("{} {:a}:{}", text(hit.body), hit.hit.parameter, hit.hit.triangle());
}

inline std::string text(const PairRelation& pair) {
    return text(pair.bodies) + " " + judge::written(pair.relation);
}

inline std::string text(const BodyAt& at) {
    return text(at.body) + " " + judge::written(at.side);
}

// The first few; how many there are in all.
template <class Item>
std::string text(std::span<const Item> items) {
    constexpr std::size_t shown_max = 12;
    std::string result = fmt::format("{} [", items.size());
    for (std::size_t i = 0; i < items.size() && i < shown_max; ++i) result.append(i == 0 ? "" : " ") += text(items[i]);
    return result.append(items.size() > shown_max ? " ...]" : "]");
}

template <class Item>
std::string text(const std::vector<Item>& items) {
    return text(std::span<const Item>(items));
}

template <class Item>
std::string text(const std::optional<Item>& item) {
    return item ? text(*item) : "none";
}

}  // namespace ecods::fuzz
