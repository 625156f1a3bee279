#include <bit>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <thread>

#include "fuzz/engines/peers.hpp"
#include "fuzz/engines/rounded.hpp"

namespace ecods::fuzz {

const std::vector<EngineMaker>& engines_under_test() {
    static const std::vector<EngineMaker> engines = {
        {"ecods", "MeshShape, intersects(), one QueryMemory for all; exact", true, make_ecods},
        {"fcl", "BVHModel<OBBRSS>, collide() for one contact; double", false, make_fcl},
        {"bullet", "btGImpactMeshShape, margin 0, its algorithm from the dispatcher; float", false, make_bullet},
        {"ode", "trimesh, dCollide() for one contact; poses double, triangles float", false, make_ode},
        {"cgal", "Rigid_triangle_mesh_collision_detection over Epick; exact predicates on rounded vertices", false,
         make_cgal},
        {"rounded", "vertices rounded to doubles when posed, then ECoDS's exact test of every pair of triangles", false,
         make_rounded},
    };
    return engines;
}

namespace {

class Canary final : public EngineUnderTest {
  public:
    bool intersects(const scenes::MeshQuery& query) override {
        std::uint64_t hash = 0;
        for (const double x : query.b.pose.t) hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
        if (hash >> 60 == 0) std::abort();
        if (hash >> 60 == 1) std::this_thread::sleep_for(std::chrono::hours(1));
        return true;
    }
};

}  // namespace

EngineMaker canary_engine() {
    return {"canary", "says yes, crashes, hangs", false, [](std::span<const scenes::NamedMesh> /*meshes*/) {
                return std::unique_ptr<EngineUnderTest>(std::make_unique<Canary>());
            }};
}

}  // namespace ecods::fuzz
