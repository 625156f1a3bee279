// How pipes are to blocks and to each other; for building_relations.cpp. Throw std::logic_error where it is not known.
#pragma once

#include "scenes/building/building_relations.hpp"
#include "scenes/building/element_blocks.hpp"

namespace ecods::scenes {

// Of a pipe and a solid of blocks with disjoint interiors.
Contact contact_of_pipe(const Element& pipe, const Blocks& solid);
Contact contact_of_pipes(const Element& a, const Element& b);

// Throws unless a line of the pipe's surface, or an end of it, is as near to the block as the box around the pipe.
void require_extreme_at(const Element& pipe, const Block& block);

}  // namespace ecods::scenes
