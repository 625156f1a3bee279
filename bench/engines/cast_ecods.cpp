// ECoDS without a world: the questions of cast.hpp about two bodies.
#include "ecods/cast.hpp"

#include <deque>
#include <limits>

#include "ecods/distance.hpp"
#include "engines/cast_engine.hpp"

namespace ecods::bench {

namespace {

class CastEcods : public CastEngine {
  public:
    explicit CastEcods(const scenes::CastWorkload& workload) : is_translation_(workload.is_translation) {
        for (const scenes::NamedMesh& named : workload.meshes) {
            shapes_.emplace_back(named.mesh);
            shapes_.back().tree_bytes();  // makes the tree
        }
    }

    double ask(const scenes::CastQuery& query) override {
        const std::optional<FirstContact> contact = first_contact(query);
        return contact ? contact->time : std::numeric_limits<double>::quiet_NaN();
    }

  protected:
    std::deque<MeshShape> shapes_;
    QueryMemory memory_;

  private:
    std::optional<FirstContact> first_contact(const scenes::CastQuery& query) {
        const MeshShape &a = shapes_[query.a.mesh_index], &b = shapes_[query.b.mesh_index];
        if (is_translation_) return cast({a, query.a.pose}, query.motion, {b, query.b.pose}, memory_);
        return cast(Moving<MeshShape>(a, query.a.pose, query.a_end), Moving<MeshShape>(b, query.b.pose, query.b.pose),
                    memory_);
    }

    bool is_translation_;
};

class EndDistance final : public CastEcods {
  public:
    using CastEcods::CastEcods;

    double ask(const scenes::CastQuery& query) override {
        return distance({shapes_[query.a.mesh_index], query.a_end}, {shapes_[query.b.mesh_index], query.b.pose},
                        memory_);
    }
};

}  // namespace

std::unique_ptr<CastEngine> set_up_cast_ecods(const scenes::CastWorkload& workload) {
    return std::make_unique<CastEcods>(workload);
}

std::unique_ptr<CastEngine> set_up_cast_ecods_distance(const scenes::CastWorkload& workload) {
    return std::make_unique<EndDistance>(workload);
}

}  // namespace ecods::bench
