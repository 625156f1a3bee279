// The contact of bodies that share a point before they move.
#pragma once

#include "ecods/cast.hpp"

namespace ecods {

// The bodies must intersect. Part of another question.
FirstContact contact_at_start(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory);

}  // namespace ecods
