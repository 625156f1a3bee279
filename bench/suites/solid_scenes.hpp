// Solids for the suite of that name: meshes whose relations follow from how they are made.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ecods/solid.hpp"
#include "scenes/random.hpp"

namespace ecods::bench {

// A box from 0 to (n, n, height), cut as a plate of n cells. Diagonals go one way or the other.
std::shared_ptr<const Mesh> slab(std::uint32_t n, double height, bool other_diagonals = false);

struct SolidScene {
    std::string name;
    std::shared_ptr<const Solid> a, b;
    Pose pose_a, pose_b;
    Relation relation;
    bool do_surfaces_meet;
};

// Round ones whose boxes overlap, and slabs that are flush; meshes of about so many triangles.
std::vector<SolidScene> solid_scenes(std::uint32_t triangle_count);

struct PointScene {
    std::string name;
    Pose pose;
    std::vector<Vec3> points;
    bool has_target;  // whether the stricter bound is for it
};

// Points at a mesh of about unit size.
std::vector<PointScene> point_scenes(const Mesh& mesh, std::size_t point_count);

}  // namespace ecods::bench
