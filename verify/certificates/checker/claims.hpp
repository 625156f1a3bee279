// Checks claims about two posed meshes, a segment and one, or the bodies of a world.
#pragma once

#include "certificate.hpp"

namespace certificate_checker {

// Throws Refusal unless the proof proves its claim about a and b; `hit` and `miss` are about the segment.
void check_pair(const PosedMesh& a, const PosedMesh& b, const Proof& proof, Budget& budget);
void check_segment(const PosedMesh& a, const Segment& segment, const Proof& proof, Budget& budget);
// Reads and checks the sections of a world.
WorldCounts check_world(Text& in, const WorldHead& head, Budget& budget);

}  // namespace certificate_checker
