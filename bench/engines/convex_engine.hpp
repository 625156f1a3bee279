// What every engine of convex solids offers: meshes are made ready once, then pairs of them at poses are asked about.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scenes/convex_workloads.hpp"

namespace ecods::bench {

struct ConvexAnswer {
    double number = 0;              // the distance, not positive if they are said to meet; the depth, NaN if said apart
    Vec3 direction = Vec3::Zero();  // of a depth: along which b is to move; of any length
};

class ConvexEngine {
  public:
    virtual ~ConvexEngine() = default;

    // Timed, with everything that a change of pose demands. `index` is the query's: some keep something for each.
    virtual ConvexAnswer ask(const scenes::MeshQuery& query, std::size_t index) = 0;
};

struct ConvexMaker {
    std::string name;
    std::string use;  // how it is used, and what its precision is: for the page
    bool is_ecods = false;
    std::unique_ptr<ConvexEngine> (*set_up)(const scenes::ConvexWorkload& workload) = nullptr;
};

std::unique_ptr<ConvexEngine> set_up_convex_ecods(const scenes::ConvexWorkload& workload);
std::unique_ptr<ConvexEngine> set_up_convex_ecods_witness(const scenes::ConvexWorkload& workload);
std::unique_ptr<ConvexEngine> set_up_convex_ecods_closest(const scenes::ConvexWorkload& workload);
std::unique_ptr<ConvexEngine> set_up_convex_fcl_libccd(const scenes::ConvexWorkload& workload);
std::unique_ptr<ConvexEngine> set_up_convex_fcl_indep(const scenes::ConvexWorkload& workload);
std::unique_ptr<ConvexEngine> set_up_convex_ccd_epa(const scenes::ConvexWorkload& workload);
std::unique_ptr<ConvexEngine> set_up_convex_ccd_mpr(const scenes::ConvexWorkload& workload);
std::unique_ptr<ConvexEngine> set_up_convex_bullet(const scenes::ConvexWorkload& workload);

// Those that answer the question. Ratios are taken to these: of distances to the first, of depths to the others.
std::vector<ConvexMaker> convex_engines(scenes::ConvexQuestion question);
constexpr const char* convex_distance_yardstick = "FCL libccd";
constexpr const char* convex_depth_yardstick = "libccd EPA";
constexpr const char* convex_second_yardstick = "Bullet";

}  // namespace ecods::bench
