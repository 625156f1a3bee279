// Numbers, points, poses and names are written as words of a line of text, which does not depend on the locale.
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
void append(std::string& text, double x);  // hexadecimal; infinity is "inf"
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

// append_words() appends each word and a space after it. end_line() replaces the space after the last word by a line
// end. append_line() does both.
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

// Writes the text unchanged, whatever flags, width or locale the stream has.
inline void write_text(std::ostream& out, std::string_view text) {
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace ecods
