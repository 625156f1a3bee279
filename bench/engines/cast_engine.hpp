// What every engine of casts offers: meshes are made ready once, then motions of one towards another are asked about.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "scenes/cast_workloads.hpp"

namespace ecods::bench {

class CastEngine {
  public:
    virtual ~CastEngine() = default;

    // The time of the first contact, or NaN if there is none. Timed, with everything that a change of poses demands.
    virtual double ask(const scenes::CastQuery& query) = 0;
};

// What the engine is asked.
enum class CastAnswer {
    time,
    distance,  // no cast: the distance at the end of the motion, to compare the cost with
};

struct CastMaker {
    std::string name;
    std::string use;  // how it is used, and what its precision is: for the page
    bool is_ecods = false;
    CastAnswer answer = CastAnswer::time;
    bool is_for_hulls = false;  // moves convex hulls only
    std::size_t triangle_max =
        std::numeric_limits<std::size_t>::max();  // of its largest mesh: of more it is not asked, for the time
    std::unique_ptr<CastEngine> (*set_up)(const scenes::CastWorkload& workload) = nullptr;
};

std::unique_ptr<CastEngine> set_up_cast_ecods(const scenes::CastWorkload& workload);
std::unique_ptr<CastEngine> set_up_cast_ecods_distance(const scenes::CastWorkload& workload);
std::unique_ptr<CastEngine> set_up_cast_fcl_obbrss(const scenes::CastWorkload& workload);
std::unique_ptr<CastEngine> set_up_cast_fcl_rss(const scenes::CastWorkload& workload);
std::unique_ptr<CastEngine> set_up_cast_fcl_default(const scenes::CastWorkload& workload);
std::unique_ptr<CastEngine> set_up_cast_fcl_samples(const scenes::CastWorkload& workload);
std::unique_ptr<CastEngine> set_up_cast_bullet(const scenes::CastWorkload& workload);

// All of the above. Ratios are taken to FCL's conservative advancement.
std::vector<CastMaker> cast_engines();
constexpr const char* cast_yardstick = "FCL advancement";
constexpr const char* own_end_distance = "ECoDS distance";

}  // namespace ecods::bench
