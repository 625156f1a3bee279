// Tells whether an error has the reason that a test expects, and not just the class that has such reasons.
#pragma once

#include <exception>

#include "ecods/error.hpp"

namespace ecods::scenes {

// True if the error is an E with that reason.
template <class E, class Member, class Reason>
bool has_reason(const std::exception& error, Reason expected, Member E::*member) {
    const auto* const typed = dynamic_cast<const E*>(&error);
    return typed != nullptr && typed->*member == expected;
}

inline bool is_about(const std::exception& error, InvalidMesh::Reason expected) {
    return has_reason(error, expected, &InvalidMesh::reason);
}
inline bool is_about(const std::exception& error, NotSolid::Reason expected) {
    return has_reason(error, expected, &NotSolid::reason);
}
inline bool is_about(const std::exception& error, Argument expected) {
    return has_reason(error, expected, &InvalidArgument::argument);
}
inline bool is_about(const std::exception& error, Question expected) {
    return has_reason(error, expected, &NotSupported::question);
}

}  // namespace ecods::scenes
