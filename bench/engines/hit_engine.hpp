// What every engine of hits offers: posed meshes are made ready once, then segments are asked about. Triangles are
// numbered through all bodies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scenes/segment_workloads.hpp"

namespace ecods::bench {

// The first hit of a segment. The parameter is NaN where nothing is hit.
struct HitAnswer {
    double parameter = std::numeric_limits<double>::quiet_NaN();
    std::uint32_t triangle = 0;
};

class HitEngine {
  public:
    virtual ~HitEngine() = default;

    // One answer for each segment, in their order. Timed. All at once, for engines that answer several together.
    virtual void first_hits(std::span<const Segment> segments, std::span<HitAnswer> answers) = 0;

    // All triangles that are hit, in any order. Timed. Only for engines with `has_lists`.
    virtual void all_hits(const Segment& /*segment*/, std::vector<std::uint32_t>& triangles) { triangles.clear(); }
};

// Of how many bodies the engine is asked.
enum class HitBodies { one, many, any };

struct HitMaker {
    std::string name;
    std::string use;  // how it is used, and what its precision is: for the page
    bool is_ecods = false;
    bool has_lists = false;
    bool is_for_paths = false;  // keeps what it found from segment to segment, and is only asked about paths
    HitBodies bodies = HitBodies::any;
    std::unique_ptr<HitEngine> (*set_up)(const scenes::SegmentWorkload& workload) = nullptr;
};

std::unique_ptr<HitEngine> set_up_hit_ecods(const scenes::SegmentWorkload& workload);
std::unique_ptr<HitEngine> set_up_hit_ecods_witness(const scenes::SegmentWorkload& workload);
std::unique_ptr<HitEngine> set_up_hit_ecods_world(const scenes::SegmentWorkload& workload);
std::unique_ptr<HitEngine> set_up_hit_embree(const scenes::SegmentWorkload& workload);
std::unique_ptr<HitEngine> set_up_hit_embree_robust(const scenes::SegmentWorkload& workload);
std::unique_ptr<HitEngine> set_up_hit_embree_packets(const scenes::SegmentWorkload& workload);
std::unique_ptr<HitEngine> set_up_hit_embree_instances(const scenes::SegmentWorkload& workload);
std::unique_ptr<HitEngine> set_up_hit_bullet(const scenes::SegmentWorkload& workload);
std::unique_ptr<HitEngine> set_up_hit_cgal(const scenes::SegmentWorkload& workload);

// All of the above. Ratios are taken to Embree's default.
std::vector<HitMaker> hit_engines();
constexpr const char* hit_yardstick = "Embree";
constexpr const char* own_hits = "ECoDS";
constexpr const char* own_world_hits = "ECoDS world";

}  // namespace ecods::bench
