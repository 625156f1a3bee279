// The bodies of a workload of segments in an ECoDS world.
#pragma once

#include <cstdint>
#include <vector>

#include "engines/own_shapes.hpp"
#include "engines/world_bodies.hpp"
#include "scenes/segment_workloads.hpp"

namespace ecods::bench {

class SegmentWorld {
  public:
    explicit SegmentWorld(const scenes::SegmentWorkload& workload) : first_triangles_(first_triangles(workload)) {
        for (const scenes::MeshAt& body : workload.bodies)
            bodies_.add(workload.meshes[body.mesh_index].mesh, body.pose);
        bodies_.world.update();
    }

    const World& world() const { return bodies_.world; }

    // The number of the hit's triangle through all bodies.
    std::uint32_t triangle_of(const BodyHit& hit) const {
        return first_triangles_[bodies_.index_of(hit.body)] + hit.hit.triangle();
    }

  private:
    WorldBodies bodies_;
    std::vector<std::uint32_t> first_triangles_;
};

}  // namespace ecods::bench
