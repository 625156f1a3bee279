// Checks claims about two posed meshes, or a segment and one.
#pragma once

#include "body.hpp"

namespace certificate_checker {

// Throws Refusal unless the proof proves its claim about a and b; `hit` and `miss` are about the segment.
void check_pair(Body& a, Body& b, const Proof& proof);
void check_segment(Body& a, const std::array<Vector<double>, 2>& segment, const Proof& proof, Budget& budget);

// Whether the boxes of a and b have a gap that is greater than 0, or than a clearance.
bool are_boxes_apart(Body& a, Body& b, const std::optional<double>& clearance);

}  // namespace certificate_checker
