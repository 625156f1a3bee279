#include "judge/along_questions.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "ecods/cast.hpp"
#include "ecods/turn.hpp"
#include "judge/cast_truth.hpp"
#include "judge/text.hpp"
#include "judge/way_questions.hpp"
#include "oracle/float_environment.hpp"
#include "oracle/way.hpp"

namespace ecods::judge {
namespace {

double double_of(std::uint64_t bits) {
    return std::bit_cast<double>(bits);
}

// Returns the double nearest to a number from 0 to 1, ties to even; of a positive one at least 2^-1074.
double nearest(const mpq_class& number) {
    if (number == 0) return 0;
    std::uint64_t below = 0, above = std::bit_cast<std::uint64_t>(1.0);  // below < number <= above, as doubles
    while (above - below > 1) {
        const std::uint64_t middle = below + (above - below) / 2;
        (mpq_class(double_of(middle)) < number ? below : above) = middle;
    }
    const mpq_class half = (mpq_class(double_of(below)) + mpq_class(double_of(above))) / 2;
    const bool is_low = number < half || (number == half && below % 2 == 0);
    return double_of(is_low ? std::max<std::uint64_t>(below, 1) : above);
}

std::optional<FirstContact> true_contact(const oracle::WaySoup& way, const oracle::Soup& b) {
    const oracle::FloatEnvironment environment;
    const auto exact = oracle::first_contact(way, b);
    if (!exact) return std::nullopt;
    FirstContact contact = *to_first_contact(exact->contact);
    const mpq_class leg(static_cast<unsigned long>(exact->leg)), count(way.quaternions.size() - 1);
    contact.time = nearest(mpq_class(leg + mpq_class(contact.time)) / count);
    return contact;
}

}  // namespace

std::optional<Wrong> ask_about_along(const Way<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    const auto expected = true_contact(way_soup(a), soup(b));
    const Posed<MeshShape> start(*a.what, a.pose);
    const Motion along = Along{a.nodes}, rest;
    std::optional<Wrong> wrong;
    const auto require = [&](const char* what, const std::optional<FirstContact>& got,
                             const std::optional<FirstContact>& right) {
        if (!wrong && !is_same(got, right)) wrong = Wrong{what, text(right), text(got)};
    };
    require("cast along nodes", cast(start, along, b, rest, 1, ask), expected);
    auto back = cast(b, rest, start, along, 1, ask);
    if (back) std::swap(back->a, back->b);
    require("cast along nodes, of the second body", back, expected);
    if (!expected) return wrong;
    const double time = expected->time;
    require("cast along nodes up to its time", cast(start, along, b, rest, time, ask), expected);
    const auto after = std::bit_cast<std::uint64_t>(time) + 1;
    require("cast along nodes up to a time after it", cast(start, along, b, rest, double_of(after), ask), expected);
    if (std::bit_cast<std::uint64_t>(time) != 0) {
        require("cast along nodes up to a time before it", cast(start, along, b, rest, double_of(after - 2), ask), {});
    }
    return wrong;
}

}  // namespace ecods::judge
