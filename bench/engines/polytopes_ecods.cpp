// ecods::World of convex solids: World::signed_distances.
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "engines/polytopes_engine.hpp"
#include "engines/world_bodies.hpp"

namespace ecods::bench {

namespace {

class PolytopesEcods final : public PolytopesEngine {
  public:
    PolytopesEcods(const Polytopes::Workload& workload, bool has_update)
        : limit_(workload.limit), has_update_(has_update) {
        for (std::size_t i = 0; i < workload.meshes.size(); ++i)
            bodies_.add(std::make_shared<const ConvexSolid>(workload.meshes[i]), workload.poses[i]);
        bodies_.world.update();
    }

    void run_frame(std::span<const Pose> poses) override {
        bodies_.world.set_poses(bodies_.ids(), poses);
        if (has_update_) bodies_.world.update();
        found_ = bodies_.world.signed_distances(limit_);
    }

    std::vector<NearPair> pairs() const override {
        std::vector<NearPair> pairs;
        for (const auto& [bodies, distance] : found_)
            pairs.push_back({{bodies_.index_of(bodies.a), bodies_.index_of(bodies.b)}, std::max(0.0, distance)});
        return pairs;
    }

  private:
    WorldBodies bodies_;
    std::vector<PairDistance> found_;
    double limit_;
    bool has_update_;
};

}  // namespace

std::vector<PolytopesMaker> ecods_polytopes() {
    return {{.name = "ECoDS world of convex",
             .use = "set_poses() and signed_distances(), the depth of those that meet included; rounded once",
             .is_ecods = true,
             .set_up = makes<PolytopesEcods>(false)},
            {.name = "ECoDS world of convex, update",
             .use = "the same with update() in between, which finds collisions, too",
             .is_ecods = true,
             .set_up = makes<PolytopesEcods>(true)}};
}

}  // namespace ecods::bench
