// ECoDS without a world: the questions of hit.hpp about one body.
#include "ecods/hit.hpp"
#include "engines/hit_engine.hpp"

namespace ecods::bench {

namespace {

class HitEcods final : public HitEngine {
  public:
    HitEcods(const scenes::SegmentWorkload& workload, bool has_witness)
        : shape_(workload.meshes.front().mesh), body_(shape_, workload.bodies.front().pose), has_witness_(has_witness) {
        shape_.tree_bytes();  // makes the tree
    }

    void first_hits(std::span<const Segment> segments, std::span<HitAnswer> answers) override {
        for (std::size_t i = 0; i < segments.size(); ++i) {
            const std::optional<Hit> hit = has_witness_ ? first_hit(segments[i], body_, memory_, witness_)
                                                        : first_hit(segments[i], body_, memory_);
            answers[i] = hit ? HitAnswer{hit->parameter, hit->triangle()} : HitAnswer{};
        }
    }

    void all_hits(const Segment& segment, std::vector<std::uint32_t>& triangles) override {
        triangles.clear();
        for (const Hit& hit : ecods::all_hits(segment, body_, memory_)) triangles.push_back(hit.triangle());
    }

  private:
    MeshShape shape_;
    Posed<MeshShape> body_;
    QueryMemory memory_;
    PairWitness witness_;
    bool has_witness_;
};

}  // namespace

std::unique_ptr<HitEngine> set_up_hit_ecods(const scenes::SegmentWorkload& workload) {
    return std::make_unique<HitEcods>(workload, false);
}

std::unique_ptr<HitEngine> set_up_hit_ecods_witness(const scenes::SegmentWorkload& workload) {
    return std::make_unique<HitEcods>(workload, true);
}

}  // namespace ecods::bench
