// Which of many convex solids are within a limit of each other, while they move?
#pragma once

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "engines/engine.hpp"
#include "engines/frame_engine.hpp"

namespace ecods::bench {

struct NearPair {
    IndexPair bodies;
    double distance = 0;  // 0 if they meet

    friend bool operator==(const NearPair&, const NearPair&) = default;
};

// In each frame all bodies are at new poses, which are its moves.
struct Polytopes {
    struct Workload {
        std::vector<std::shared_ptr<const Mesh>> meshes;
        std::vector<Pose> poses;
        double limit = 0;  // pairs at a distance of at most this are found
    };
    using Engine = FrameEngine<Pose, NearPair>;
    struct Traits {};
};

using PolytopesEngine = Polytopes::Engine;
using PolytopesMaker = Maker<Polytopes>;

std::vector<PolytopesMaker> ecods_polytopes();
std::vector<PolytopesMaker> fcl_polytopes();

// All of the above.
std::vector<PolytopesMaker> polytopes_engines();
constexpr const char* polytopes_yardstick = "FCL manager, libccd";

}  // namespace ecods::bench
