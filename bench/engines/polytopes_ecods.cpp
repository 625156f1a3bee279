// ecods::World of convex solids: solid_distances().
#include <algorithm>

#include "ecods/convex_solid.hpp"
#include "ecods/world.hpp"
#include "engines/polytopes_engine.hpp"

namespace ecods::bench {

namespace {

class PolytopesEcods final : public PolytopesEngine {
  public:
    PolytopesEcods(std::span<const std::shared_ptr<const Mesh>> meshes, std::span<const Pose> poses, bool has_update)
        : has_update_(has_update) {
        for (std::size_t i = 0; i < meshes.size(); ++i)
            ids_.push_back(world_.create_body(std::make_shared<const ConvexSolid>(meshes[i]), poses[i]));
        world_.update();
    }

    void run_frame(std::span<const Pose> poses, double limit) override {
        world_.set_poses(ids_, poses);
        if (has_update_) world_.update();
        found_ = world_.solid_distances(limit);
    }

    std::vector<NearPair> pairs() const override {
        std::vector<NearPair> pairs;
        for (const SolidDistance& found : found_)
            pairs.push_back({{index_of(found.bodies.a), index_of(found.bodies.b)}, found.distance});
        return pairs;
    }

  private:
    std::size_t index_of(BodyId id) const {  // ids are given in ascending order
        return static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
    }

    World world_;
    std::vector<BodyId> ids_;
    std::vector<SolidDistance> found_;
    bool has_update_;
};

}  // namespace

std::unique_ptr<PolytopesEngine> set_up_polytopes_ecods(std::span<const std::shared_ptr<const Mesh>> meshes,
                                                        std::span<const Pose> poses) {
    return std::make_unique<PolytopesEcods>(meshes, poses, false);
}

std::unique_ptr<PolytopesEngine> set_up_polytopes_ecods_update(std::span<const std::shared_ptr<const Mesh>> meshes,
                                                               std::span<const Pose> poses) {
    return std::make_unique<PolytopesEcods>(meshes, poses, true);
}

}  // namespace ecods::bench
