// Checks claims about two posed meshes.
#pragma once

#include "body.hpp"

namespace certificate_checker {

// (x + y) / 2, which need not be a double.
struct Midpoint {
    double x = 0;
    double y = 0;
};

// When two parts are apart along a vector n.
struct Rule {
    enum class Gap : std::uint8_t { positive, weak, half_open, at_least, more_than } gap = Gap::positive;
    Midpoint m;  // at_least, more_than: the gap beside this distance
};

// Throws Refusal unless the proof proves its claim about a and b; `hit` and `miss` are about the segment.
void check_pair(Body& a, Body& b, const Proof& proof);
void check_segment(Body& a, const std::array<std::array<double, 3>, 2>& segment, const Vector<double>& origin,
                   const Proof& proof, Budget& budget);

// Whether the boxes of a and b have a gap that is greater than 0, or than a clearance.
bool are_boxes_apart(Body& a, Body& b, const std::optional<double>& clearance);

}  // namespace certificate_checker
