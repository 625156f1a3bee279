// The changes that hurt.
#pragma once

#include <memory>
#include <vector>

#include "ecods/mesh.hpp"
#include "fuzz/counters.hpp"
#include "fuzz/scene.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

// What the bodies of one run have in common.
struct Setting {
    double unit = 1;       // a power of two: the size of things
    Vec3 origin{0, 0, 0};  // the middle of the scene
    std::vector<std::shared_ptr<const Mesh>> meshes = {};
    std::size_t bodies_max = 8;
};

Pose random_pose(const Setting& setting, scenes::Random& random);

// Makes one change to the scene, and counts it.
void change(Scene& scene, const Setting& setting, scenes::Random& random, Counters& counters);

}  // namespace ecods::fuzz
