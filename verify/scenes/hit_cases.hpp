// Segments and rays beside posed meshes on which hits go wrong, by family; some with answers that are known without
// computing one.
//
// All are deterministic: a family and a random generator's state give the same bits on every machine.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "ecods/closest_points.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/segment.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {

struct HitCase {
    std::shared_ptr<const Mesh> mesh;
    Pose pose;
    std::variant<Segment, Ray> line;
    // Of the first hit, where the recipe knows it: rounded once; and what is hit.
    struct Known {
        double parameter;
        Feature feature;
    };
    std::optional<Known> known = {};
};

enum class HitFamily {
    lattice,          // small lattice triangles and ends in a basis of full mantissas: vertices, edges, faces' planes
    lattice_one_ulp,  // the same, one coordinate of an end a unit in the last place off
    integer_matrix,   // small lattices under a matrix of small integers, singular ones and reflections among them
    points,           // segments of length 0 on vertices, edges, faces and beside them, and ones of one unit
    rational,         // known: a vertex, an edge or a face at the parameter p / q, in an integer rotation
    limits,           // rays that end at, just before and just after a lattice plane
    distance_cases,   // the bodies of distance_cases.hpp: lines through rounded corners of both, and beside them
};

std::span<const HitFamily> hit_families();
std::string_view name(HitFamily family);

HitCase make_hit_case(HitFamily family, Random& random);

}  // namespace ecods::scenes
