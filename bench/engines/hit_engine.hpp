// Engines of hits find what a segment hits first. Triangles are numbered through all bodies.
#pragma once

#include <cstdint>
#include <limits>

#include "engines/engine.hpp"
#include "scenes/segment_workloads.hpp"

namespace ecods::bench {

// The first hit of a segment. The parameter is NaN where nothing is hit; the triangle's number is a double, as an
// answer consists of these.
struct HitAnswer {
    double parameter = std::numeric_limits<double>::quiet_NaN();
    double triangle = 0;
};

// How many bodies the engine is asked about.
enum class HitBodies { one, many, any };

struct FirstHits {
    using Workload = scenes::SegmentWorkload;
    using Answer = HitAnswer;
    using Engine = QueryEngine<FirstHits>;
    using Item = std::uint32_t;  // the triangles that are hit, all of which are listed
    struct Traits {
        bool is_for_paths = false;  // keeps what it found from segment to segment, and is only asked about paths
        HitBodies bodies = HitBodies::any;
    };

    static bool is_asked(const Traits& traits, const Workload& workload) {
        const HitBodies bodies = workload.bodies.size() == 1 ? HitBodies::one : HitBodies::many;
        return (workload.is_path || !traits.is_for_paths) &&
               (traits.bodies == HitBodies::any || traits.bodies == bodies);
    }
};

using HitMaker = Maker<FirstHits>;
using HitLists = Lists<FirstHits::Engine::Query, FirstHits::Item>;

std::vector<HitMaker> ecods_hits();
std::vector<HitMaker> embree_hits();
std::vector<HitMaker> bullet_hits();
std::vector<HitMaker> cgal_hits();

// All of the above. Ratios are taken to Embree's default.
std::vector<HitMaker> hit_engines();
constexpr const char* hit_yardstick = "Embree";
constexpr const char* own_hits = "ECoDS";
constexpr const char* own_world_hits = "ECoDS world";

}  // namespace ecods::bench
