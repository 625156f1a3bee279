// The first contacts of a workload of casts, by ECoDS.
#pragma once

#include <optional>

#include "ecods/cast.hpp"
#include "engines/own_shapes.hpp"
#include "scenes/cast_workloads.hpp"

namespace ecods::bench {

class OwnCasts {
  public:
    explicit OwnCasts(const scenes::CastWorkload& workload)
        : posed_(workload.meshes), is_translation_(workload.is_translation) {}

    std::optional<FirstContact> operator()(const scenes::CastQuery& query) {
        if (is_translation_) return cast(posed_(query.a), query.motion, posed_(query.b), 1, memory_);
        return cast(Moving<MeshShape>(posed_.at(query.a.mesh_index), query.a.pose, query.a_end),
                    Moving<MeshShape>(posed_.at(query.b.mesh_index), query.b.pose, query.b.pose), 1, memory_);
    }

  private:
    OwnShapes<MeshShape> posed_;
    QueryMemory memory_;
    bool is_translation_;
};

}  // namespace ecods::bench
