// ECoDS without a world: the questions of cast.hpp about two bodies.
#include "ecods/cast.hpp"

#include <limits>

#include "ecods/distance.hpp"
#include "engines/cast_engine.hpp"
#include "engines/own_casts.hpp"

namespace ecods::bench {

namespace {

class CastEcods final : public Casts::Engine {
  public:
    explicit CastEcods(const scenes::CastWorkload& workload) : casts_(workload) {}

    double ask(const scenes::CastQuery& query, std::size_t /*index*/) override {
        const std::optional<FirstContact> contact = casts_(query);
        return contact ? contact->time : std::numeric_limits<double>::quiet_NaN();
    }

  private:
    OwnCasts casts_;
};

class EndDistance final : public Casts::Engine {
  public:
    explicit EndDistance(const scenes::CastWorkload& workload) : posed_(workload.meshes) {}

    double ask(const scenes::CastQuery& query, std::size_t /*index*/) override {
        return distance({posed_.at(query.a.mesh_index), query.a_end}, posed_(query.b), memory_);
    }

  private:
    OwnShapes<MeshShape> posed_;
    QueryMemory memory_;
};

}  // namespace

std::vector<CastMaker> ecods_casts() {
    return {{.name = "ECoDS",
             .use = "cast() of a translation or between poses, one QueryMemory; exact, rounded once",
             .is_ecods = true,
             .set_up = makes<CastEcods>()},
            {.name = own_end_distance,
             .use = "distance() at the end of the motion: what it costs to ask how far that is",
             .is_ecods = true,
             .traits = {.answer = CastAnswer::distance},
             .set_up = makes<EndDistance>()}};
}

}  // namespace ecods::bench
