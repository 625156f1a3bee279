// Simpler numbers and meshes for a script.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "fuzz/script/script.hpp"

namespace ecods::fuzz {

// Ways to make a number rounder, from the coarsest on: zero, the nearest integer, the leading 1, 4, 10 or 26 bits.
inline constexpr int roundness_count = 6;

// Returns `x` itself where the result would have as many digits, or more.
double rounder(double x, int roundness);

// Calls `act` for every number of the script's poses and meshes: it may change it. Meshes that are shared stay shared;
// identity matrices, the simplest ones, are left alone.
void for_each_number(Script& script, const std::function<void(double&)>& act);
void for_each_pose(Script& script, const std::function<void(Pose&)>& act);

// Gives the field with this index, of those of a call that are not at their simplest, its simplest value: no refit, no
// solid, no kind of one's own, no filter, no data, no option of an update. False if the call has no such field.
bool simplify_field(Call& call, std::size_t index);

// Drops a call that sets fields of one body, and gives them to the call that creates it, where that has such fields.
// False, and nothing has changed, if there is none.
bool fields_to_creation(Script& script, std::size_t call);

// Whether each mesh that a solid or a convex solid is to be made of bounds one.
bool have_their_forms(const Script& script);

// The distinct meshes, in order of appearance.
std::vector<std::shared_ptr<const Mesh>> meshes_of(const Script& script);
// Puts one mesh in place of another, everywhere.
void replace_mesh(Script& script, const Mesh* old, const std::shared_ptr<const Mesh>& mesh);

// The mesh without `count` triangles from `begin` on, and without the vertices that no other uses. Null if no triangle
// is left.
std::shared_ptr<const Mesh> without_triangles(const Mesh& mesh, std::size_t begin, std::size_t count);

}  // namespace ecods::fuzz
