// ECoDS's questions of hit.hpp about one body; and a world that is asked for hits.
#include "ecods/hit.hpp"

#include "engines/hit_engine.hpp"
#include "engines/own_hits.hpp"

namespace ecods::bench {

namespace {

HitAnswer to_answer(const std::optional<Hit>& hit) {
    return hit ? HitAnswer{hit->parameter, static_cast<double>(hit->triangle())} : HitAnswer{};
}

void list_triangles(const std::vector<Hit>& hits, std::vector<std::uint32_t>& triangles) {
    triangles.clear();
    for (const Hit& hit : hits) triangles.push_back(hit.triangle());
}

template <bool has_witness>
class HitEcods final : public FirstHits::Engine, public HitLists {
  public:
    explicit HitEcods(const scenes::SegmentWorkload& workload)
        : posed_(workload.meshes), body_(posed_(workload.bodies.front())) {}

    HitAnswer ask(const Segment& segment, std::size_t /*index*/) override {
        if constexpr (has_witness) return to_answer(first_hit(segment, body_, {memory_, witness_}));
        return to_answer(first_hit(segment, body_, memory_));
    }

    void list(const Segment& segment, std::vector<std::uint32_t>& triangles) override {
        list_triangles(all_hits(segment, body_, memory_), triangles);
    }

  private:
    OwnShapes<MeshShape> posed_;
    Posed<MeshShape> body_;
    QueryMemory memory_;
    PairWitness witness_;
};

class HitEcodsWorld final : public FirstHits::Engine, public HitLists {
  public:
    explicit HitEcodsWorld(const scenes::SegmentWorkload& workload) : bodies_(workload) {}

    HitAnswer ask(const Segment& segment, std::size_t /*index*/) override {
        const std::optional<BodyHit> hit = bodies_.world().first_hit(segment, {}, memory_);
        return hit ? HitAnswer{hit->hit.parameter, static_cast<double>(bodies_.triangle_of(*hit))} : HitAnswer{};
    }

    void list(const Segment& segment, std::vector<std::uint32_t>& triangles) override {
        triangles.clear();
        for (const BodyHit& hit : bodies_.world().all_hits(segment, {}, memory_))
            triangles.push_back(bodies_.triangle_of(hit));
    }

  private:
    SegmentWorld bodies_;
    QueryMemory memory_;
};

}  // namespace

std::vector<HitMaker> ecods_hits() {
    return {{.name = own_hits,
             .use = "first_hit(), all_hits(), one QueryMemory; exact, parameters rounded once",
             .is_ecods = true,
             .has_lists = true,
             .traits = {.bodies = HitBodies::one},
             .set_up = makes<HitEcods<false>>()},
            {.name = "ECoDS, witness",
             .use = "first_hit() with one PairWitness for all of a path; the same",
             .is_ecods = true,
             .traits = {.is_for_paths = true, .bodies = HitBodies::one},
             .set_up = makes<HitEcods<true>>()},
            {.name = own_world_hits,
             .use = "World::first_hit(), all_hits(), one QueryMemory; exact, parameters rounded once",
             .is_ecods = true,
             .has_lists = true,
             .traits = {.bodies = HitBodies::many},
             .set_up = makes<HitEcodsWorld>()}};
}

}  // namespace ecods::bench
