// Numbers, points, poses and names as words of a line of text, in every locale the same.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "base/number_text.hpp"
#include "ecods/ids.hpp"
#include "ecods/pose.hpp"

namespace ecods {

struct Hex {
    std::uint64_t value;
};

void append(std::string& text, Hex x);
void append(std::string& text, double x);  // hexadecimal; infinity is inf
void append(std::string& text, std::string_view word);
void append(std::string& text, BodyId body);
void append(std::string& text, const CollisionFilter& filter);
void append(std::string& text, const Vec3& point);
void append(std::string& text, const Pose& pose);
template <std::unsigned_integral Number>
void append(std::string& text, Number x) {
    append(text, std::uint64_t{x});
}
template <class Value>
void append(std::string& text, const std::optional<Value>& value) {
    value ? append(text, *value) : append(text, std::string_view("none"));
}

// Appends words, a space behind each; and ends a line in place of the space behind its last word.
template <class... Words>
void append_words(std::string& text, const Words&... words) {
    ((append(text, words), text.push_back(' ')), ...);
}
inline void end_line(std::string& text) {
    text.back() = '\n';
}
template <class... Words>
void append_line(std::string& text, const Words&... words) {
    append_words(text, words...);
    end_line(text);
}

// Writes text as it is: no flag, width or locale of the stream has a part in it.
inline void write_text(std::ostream& out, std::string_view text) {
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace ecods
