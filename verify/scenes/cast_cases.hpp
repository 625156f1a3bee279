// Bodies on their way to each other on which casts go wrong, by family; some with times that are known without
// computing one.
//
// All are deterministic: a family and a random generator's state give the same bits on every machine.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {

// The first contact, where the recipe knows it: its time rounded once, or negative if there is none.
using KnownTime = std::optional<double>;

// a is translated.
struct CastCase {
    std::shared_ptr<const Mesh> a, b;
    Pose pose_a, pose_b;
    Vec3 motion = Vec3::Zero();
    KnownTime time = {};
};

enum class CastFamily {
    lattice,          // small lattice triangles and steps in a basis of full mantissas: grazing, sliding, at 0, at 1
    lattice_one_ulp,  // the same, one number a unit in the last place off
    integer_matrix,   // small lattices under matrices of small integers, singular ones and reflections among them
    rational,         // known: lattice features that meet at p / q, or just not, in an integer rotation
    in_one_plane,     // lattice triangles that slide in the plane of both
    boxes,            // boxes of small integer sizes: many triangles and features meet at once
    distance_cases,   // the bodies of distance_cases.hpp, sent at each other's corners, past them, and just not so far
};

std::span<const CastFamily> cast_families();
std::string_view name(CastFamily family);

CastCase make_cast_case(CastFamily family, Random& random);

// Both go from one pose to another.
struct MoveCase {
    std::shared_ptr<const Mesh> a, b;
    Pose from_a, to_a, from_b, to_b;
    KnownTime time = {};
};

enum class MoveFamily {
    lattice,          // corners that go from lattice point to lattice point, each by itself
    lattice_one_ulp,  // the same, one number a unit in the last place off
    integer_matrix,   // small lattices between matrices of small integers: flat bodies at the ends and on the way
    in_one_plane,     // the first, all corners in one plane all the time
    double_roots,     // known: a vertex and an edge that only graze each other half-way, or just not
    turned_over,      // bodies that go through a flat pose
    casts,            // those above, as motions; known where these are
    short_numbers,    // rotations of 20 bits a bit apart: poses on the way are doubles
    distance_cases,   // the bodies of distance_cases.hpp, each on its way to another pose of its own kind
};

std::span<const MoveFamily> move_families();
std::string_view name(MoveFamily family);

MoveCase make_move_case(MoveFamily family, Random& random);

}  // namespace ecods::scenes
