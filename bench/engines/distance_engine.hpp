// How far are two meshes from each other?
#pragma once

#include "engines/engine.hpp"
#include "scenes/distance_workloads.hpp"

namespace ecods::bench {

// What an answer is.
enum class DistanceAnswer {
    distance,  // a number
    bounds,    // the upper end of an interval, or NaN if it does not contain the distance
    within,    // 1 or 0
};

struct Distance {
    using Workload = scenes::DistanceWorkload;
    using Answer = double;
    using Engine = QueryEngine<Distance>;
    struct Traits {
        DistanceAnswer answer = DistanceAnswer::distance;
        double factor = 1;           // of `within`: it asks about the distance times this
        bool is_for_paths = false;   // keeps what it found from query to query, and is only asked about paths
        bool is_for_points = false;  // is only asked about points
    };

    static bool is_asked(const Traits& traits, const Workload& workload) {
        return (workload.is_path || !traits.is_for_paths) && (workload.are_points || !traits.is_for_points);
    }
};

using DistanceMaker = Maker<Distance>;

std::vector<DistanceMaker> ecods_distance();
std::vector<DistanceMaker> ecods_within();
std::vector<DistanceMaker> fcl_distance();
std::vector<DistanceMaker> cgal_distance();  // of points

// All of the above. Ratios are taken to FCL OBBRSS, and of other questions to ECoDS's distance.
std::vector<DistanceMaker> distance_engines();
constexpr const char* distance_yardstick = "FCL OBBRSS";
constexpr const char* own_distance = "ECoDS";

}  // namespace ecods::bench
