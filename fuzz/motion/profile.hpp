// Kinds of scenes, as a table: how many bodies of what, where, and what happens to them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace ecods::fuzz {

// How often changes of a group are made, beside one another. The groups are described in poses.cpp, extremes.cpp,
// calm.cpp and changes.cpp.
struct Weights {
    std::uint32_t step = 0;     // to somewhere near
    std::uint32_t contact = 0;  // into exact contact, by construction
    std::uint32_t ulp = 0;      // by a unit in the last place
    std::uint32_t size = 0;     // larger, smaller, flat
    std::uint32_t jump = 0;     // to anywhere
    std::uint32_t matrix = 0;   // another matrix: permutations, integers, rotations, the other's
    std::uint32_t life = 0;     // creation, destruction
    std::uint32_t shape = 0;    // another shape, refits
    std::uint32_t filter = 0;   // filters, pairs switched off and on, user data
    std::uint32_t bulk = 0;     // many poses at once
    std::uint32_t calm = 0;     // all go on as they did
    std::uint32_t tests = 0;    // two-body tests that are registered again, or throw
    std::uint32_t misuse = 0;   // bad input
    std::uint32_t extreme = 0;  // to the ends of the range of doubles
    std::uint32_t own = 0;      // what other bodies have: their poses, shapes, filters
    std::uint32_t solids = 0;   // related or not; surfaces and solids; one within the other
    std::uint32_t radius = 0;   // another radius; the core without one, and back
    std::uint32_t any = 0;      // any call of the table (trace/calls.hpp), its fields drawn at random
};

enum class Meshes { hard, cubes, round, solids };
enum class Scale {
    unit,
    any,
    far,
    extreme
};  // any: now and then subnormal, huge or far; far: always; extreme: each
    // mesh has a size of its own
enum class Layout {
    scattered,
    stacked,
    crowded
};  // stacked: a lattice of bodies that touch exactly; crowded: calm.hpp

struct Profile {
    std::string_view name;
    std::string_view about;
    std::uint32_t bodies_min;
    std::uint32_t bodies_max;
    std::uint32_t frames;
    std::uint32_t changes_max;  // of a frame that does not rest
    double space;               // bodies lie within so many units of the middle, in each direction
    Weights weights;
    Meshes meshes = Meshes::hard;
    Scale scale = Scale::unit;
    Layout layout = Layout::scattered;
    bool has_user_shapes = false;
    bool has_radii = false;
    std::uint32_t manner_one_in = 0;  // of so many calls, one is made in a manner (script/manners.hpp); 0: none
    std::uint32_t again_one_in = 16;  // before one of so many frames, all worlds are made again (MakeAgain)
};

// In the order in which --profile motion takes turns.
std::span<const Profile> profiles();

// Null if there is none of this name.
const Profile* find_profile(std::string_view name);

}  // namespace ecods::fuzz
