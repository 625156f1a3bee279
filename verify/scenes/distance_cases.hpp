// Pairs of posed meshes on which distances go wrong, by family; some with distances that are known without computing
// one.
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

struct DistanceCase {
    std::shared_ptr<const Mesh> a;
    std::shared_ptr<const Mesh> b;
    Pose pose_a;
    Pose pose_b;
    std::optional<double> distance;  // rounded once, where the recipe knows it
};

enum class DistanceFamily {
    apart,             // two random triangles at any distance, in random poses
    hard_pairs,        // those of hard_pairs.hpp, as they are or moved apart
    needles,           // fans of triangles thin by 2^-20 to 2^-45, whose tips come near each other
    bricks,            // boxes of 12 to 108 triangles on a grid of tenths, in one pose or in two: ties of many features
    parallel_faces,    // known: triangles in parallel planes of a lattice, each in an integer rotation of its own
    lattice_features,  // known: a lattice feature at an integer distance, or that times 2^-k, in integer rotations
    gaps,              // a vertex above a face by 2^-1 to 2^-60, in a random rotation
    vertex_on_face,    // the same by nothing, or by what rounding leaves
    far,               // near each other, and 1e8, 2^50 or more from the origin
    squeezed,          // a column of the matrix is 2^-10 to 2^-60 of the others, or they are sheared
    singular,          // a matrix without an inverse
    scaled,            // at scales of 2^-900 to 2^900
    subnormal,         // integers of some digits, times 2^-1074
    wide_exponents,    // coordinates of any exponents
    half_way,          // known: distances half-way between two doubles, or a hair beside
    small_meshes,      // spheres, tori and boxes of 6 to 84 triangles in random poses, near each other or not
    zero_area,         // segments and points among the triangles
};

std::span<const DistanceFamily> distance_families();
std::string_view name(DistanceFamily family);

DistanceCase make_distance_case(DistanceFamily family, Random& random);

}  // namespace ecods::scenes
