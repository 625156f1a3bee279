// What every engine of many convex solids offers: meshes are made ready once, then in each frame all are at new poses,
// and the pairs within a limit are asked for.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "engines/engine.hpp"

namespace ecods::bench {

struct NearPair {
    IndexPair bodies;
    double distance = 0;  // 0 if they meet
};

class PolytopesEngine {
  public:
    virtual ~PolytopesEngine() = default;

    // Moves all bodies and finds all pairs at a distance of at most the limit. This is what is timed.
    virtual void run_frame(std::span<const Pose> poses, double limit) = 0;

    // Of the last frame, ascending. Not timed.
    virtual std::vector<NearPair> pairs() const = 0;
    virtual std::size_t asked_count() const { return 0; }  // pairs of which the distance was asked; 0 where unknown
};

struct PolytopesMaker {
    std::string name;
    std::string use;
    bool is_ecods = false;
    std::unique_ptr<PolytopesEngine> (*set_up)(std::span<const std::shared_ptr<const Mesh>> meshes,
                                               std::span<const Pose> poses) = nullptr;
};

std::unique_ptr<PolytopesEngine> set_up_polytopes_ecods(std::span<const std::shared_ptr<const Mesh>> meshes,
                                                        std::span<const Pose> poses);
std::unique_ptr<PolytopesEngine> set_up_polytopes_ecods_update(std::span<const std::shared_ptr<const Mesh>> meshes,
                                                               std::span<const Pose> poses);
std::unique_ptr<PolytopesEngine> set_up_polytopes_fcl(std::span<const std::shared_ptr<const Mesh>> meshes,
                                                      std::span<const Pose> poses);

// All of the above.
std::vector<PolytopesMaker> polytopes_engines();
constexpr const char* polytopes_yardstick = "FCL manager, libccd";
constexpr const char* own_polytopes = "ECoDS world of convex";

}  // namespace ecods::bench
