// When a translated triangle is first within a distance of another one: by the distances of the two at fractions of the
// time, all pairs of features each, and by bisection. No formula of time is used.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>

#include "oracle/rounded.hpp"
#include "oracle/vector.hpp"

namespace ecods::oracle {

class RoundedMotion {
  public:
    using Corners = std::array<Vector<mpq_class>, 3>;

    // The first triangle goes along `motion`; p > 0.
    RoundedMotion(const Corners& a, const Corners& b, const Vector<mpq_class>& motion, const mpq_class& p)
        : a_(a), b_(b), motion_(motion), square_(p * p) {}

    // True if the triangles are within p at this time.
    bool is_near(const mpq_class& time) const { return squared(time) <= square_; }

    // The first time up to `last`, rounded to the nearest double; nullopt if there is none, or only a moment of less
    // than 2^-110 of the time. The triangles must not be within p at time 0.
    std::optional<double> first(double last) const;

    // Closest points of the triangles at a time at which they share none.
    std::array<Vector<mpq_class>, 2> closest(const mpq_class& time) const;

    // True if the double is the last time at which the triangles are near, rounded.
    bool is_last(double time) const;

  private:
    Corners moved(const mpq_class& time) const;
    mpq_class squared(const mpq_class& time) const;  // of the distance

    Corners a_, b_;
    Vector<mpq_class> motion_;
    mpq_class square_;
};

}  // namespace ecods::oracle
