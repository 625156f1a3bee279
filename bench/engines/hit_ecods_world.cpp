// An ECoDS world that is asked for hits.
#include <algorithm>

#include "ecods/world.hpp"
#include "engines/hit_engine.hpp"

namespace ecods::bench {

namespace {

class HitEcodsWorld final : public HitEngine {
  public:
    explicit HitEcodsWorld(const scenes::SegmentWorkload& workload) : first_triangles_(first_triangles(workload)) {
        for (const scenes::MeshAt& body : workload.bodies)
            bodies_.push_back(world_.create_body(workload.meshes[body.mesh_index].mesh, body.pose));
        world_.update();
    }

    void first_hits(std::span<const Segment> segments, std::span<HitAnswer> answers) override {
        for (std::size_t i = 0; i < segments.size(); ++i) {
            const std::optional<BodyHit> hit = world_.first_hit(segments[i], memory_);
            answers[i] = hit ? HitAnswer{hit->hit.parameter, number_of(*hit)} : HitAnswer{};
        }
    }

    void all_hits(const Segment& segment, std::vector<std::uint32_t>& triangles) override {
        triangles.clear();
        for (const BodyHit& hit : world_.all_hits(segment, memory_)) triangles.push_back(number_of(hit));
    }

  private:
    std::uint32_t number_of(const BodyHit& hit) const {
        const auto body =
            std::lower_bound(bodies_.begin(), bodies_.end(), hit.body);  // ids are given in ascending order
        return first_triangles_[static_cast<std::size_t>(body - bodies_.begin())] + hit.hit.triangle();
    }

    World world_;
    std::vector<BodyId> bodies_;
    std::vector<std::uint32_t> first_triangles_;
    QueryMemory memory_;
};

}  // namespace

std::unique_ptr<HitEngine> set_up_hit_ecods_world(const scenes::SegmentWorkload& workload) {
    return std::make_unique<HitEcodsWorld>(workload);
}

}  // namespace ecods::bench
