// Points in rationals, for tests of turns.
#pragma once

#include <gmpxx.h>

#include <array>

#include "ecods/pose.hpp"

namespace ecods::exact::turns_test {

using Rational = mpq_class;
using Place = std::array<Rational, 3>;

inline Place operator-(const Place& a, const Place& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Place cross_of(const Place& a, const Place& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Rational dot_of(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Place place_of(const Vec3& v) {
    return {v[0], v[1], v[2]};
}

}  // namespace ecods::exact::turns_test
