// Checks claims about all bodies of a world.
#pragma once

#include <functional>

#include "claims.hpp"

namespace certificate_checker {

// The mesh with this digest; throws Refusal for the line if there is none.
using FindMesh = std::function<const Mesh&(const PosedMesh&)>;

// Reads and checks the certificate whose first line is the current one. Returns the claim in words; throws Refusal.
std::string check_world(Text& in, const FindMesh& find_mesh, Budget& budget);

}  // namespace certificate_checker
