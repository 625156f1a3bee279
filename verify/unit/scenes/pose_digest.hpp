// One number for all poses of a scene, to see whether it is the same everywhere.
#pragma once

#include <bit>
#include <cstdint>

#include "scenes/scene.hpp"

namespace ecods::scenes {

// FNV-1a over the bits, 64 at a time.
inline std::uint64_t pose_digest(const Scene& scene) {
    std::uint64_t digest = 0xcbf29ce484222325;
    const auto add = [&](double x) { digest = (digest ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3; };
    const auto add_pose = [&](const Pose& pose) {
        for (int i = 0; i < 9; ++i) add(pose.R(i / 3, i % 3));
        for (int i = 0; i < 3; ++i) add(pose.t[i]);
    };
    for (const SceneBody& body : scene.bodies) add_pose(body.pose);
    for (const Frame& frame : scene.frames)
        for (const Move& move : frame.moves) add_pose(move.pose);
    return digest;
}

}  // namespace ecods::scenes
