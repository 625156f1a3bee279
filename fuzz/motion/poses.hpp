// Where bodies go: the moves that hurt.
#pragma once

#include <cstdint>
#include <span>

#include "fuzz/motion/setting.hpp"

namespace ecods::fuzz {

// A place in the scene, half of them on a lattice of half units; and a pose there.
Vec3 any_place(const Setting& setting, scenes::Random& random);
Pose any_pose(const Setting& setting, scenes::Random& random);

// The i-th place of a lattice of cubes that touch.
Pose stacked_pose(const Setting& setting, std::uint32_t i);

struct PoseContext {
    const ModelBody& body;
    const ModelBody& other;  // maybe the same
    const Pose& home;        // where the body was created
    const Setting& setting;
    scenes::Random& random;
};

struct Move {
    const char* name;
    std::uint32_t Weights::*group;
    Pose (*next)(const PoseContext&);
};
std::span<const Move> moves();

}  // namespace ecods::fuzz
