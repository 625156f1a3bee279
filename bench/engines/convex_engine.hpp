// How far are two convex solids from each other, or how deep in each other?
#pragma once

#include <array>

#include "engines/engine.hpp"
#include "scenes/convex_workloads.hpp"

namespace ecods::bench {

struct ConvexAnswer {
    double number = 0;  // the distance, not positive if they are said to meet; the depth, NaN if said apart
    std::array<double, 3> direction = {};  // of a depth: along which b is to move; of any length

    friend bool operator==(const ConvexAnswer&, const ConvexAnswer&) = default;
};

struct Convex {
    using Workload = scenes::ConvexWorkload;
    using Answer = ConvexAnswer;
    using Engine = QueryEngine<Convex>;
    struct Traits {};
};

using ConvexMaker = Maker<Convex>;

// Each library's engines that answer the question.
std::vector<ConvexMaker> ecods_convex(scenes::ConvexQuestion question);
std::vector<ConvexMaker> fcl_convex(scenes::ConvexQuestion question);
std::vector<ConvexMaker> ccd_convex(scenes::ConvexQuestion question);
std::vector<ConvexMaker> bullet_convex(scenes::ConvexQuestion question);

// All of the above. Ratios are taken to these: of distances to the first, of depths to the others.
std::vector<ConvexMaker> convex_engines(scenes::ConvexQuestion question);
constexpr const char* convex_distance_yardstick = "FCL libccd";
constexpr const char* convex_depth_yardstick = "libccd EPA";
constexpr const char* convex_second_yardstick = "Bullet";

}  // namespace ecods::bench
