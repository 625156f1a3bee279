// What the bodies of one run have in common.
#pragma once

#include <vector>

#include "fuzz/base/counters.hpp"
#include "fuzz/motion/profile.hpp"
#include "fuzz/script/script.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

struct Setting {
    const Profile& profile;
    double unit = 1;                 // a power of two: the size of things
    Vec3 origin{0, 0, 0};            // the middle of the scene
    Mat3 lattice{Mat3::Identity()};  // of stacks, in common
    std::vector<Part> parts = {};
    std::uint32_t body_count = 0;  // at the beginning, and about so many later
};

Setting make_setting(const Profile& profile, scenes::Random& random, Counters& counters);

}  // namespace ecods::fuzz
