// What every engine of distances offers: meshes are made ready once, then pairs of them at poses are asked about.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scenes/mesh_pairs.hpp"

namespace ecods::bench {

class DistanceEngine {
  public:
    virtual ~DistanceEngine() = default;

    // Timed, with everything that a change of pose demands. `d` is the distance, rounded once: what is asked about it
    // depends on the engine, most do not look at it.
    virtual double ask(const scenes::MeshQuery& query, double d) = 0;
};

// What an answer is.
enum class DistanceAnswer {
    distance,  // a number
    bounds,    // the upper end of an interval, or NaN if it does not contain d
    within,    // 1 or 0
};

struct DistanceMaker {
    std::string name;
    std::string use;  // how it is used, and what its precision is: for the page
    bool is_ecods = false;
    DistanceAnswer answer = DistanceAnswer::distance;
    double factor = 1;          // of `within`: it asks about d times this
    bool is_for_paths = false;  // keeps what it found from query to query, and is only asked about paths
    std::unique_ptr<DistanceEngine> (*set_up)(std::span<const scenes::NamedMesh> meshes, double factor) = nullptr;
};

std::unique_ptr<DistanceEngine> set_up_distance_ecods(std::span<const scenes::NamedMesh> meshes, double factor);
std::unique_ptr<DistanceEngine> set_up_distance_ecods_witness(std::span<const scenes::NamedMesh> meshes, double factor);
std::unique_ptr<DistanceEngine> set_up_distance_ecods_bounds(std::span<const scenes::NamedMesh> meshes, double factor);
std::unique_ptr<DistanceEngine> set_up_distance_ecods_closest(std::span<const scenes::NamedMesh> meshes, double factor);
std::unique_ptr<DistanceEngine> set_up_distance_ecods_within(std::span<const scenes::NamedMesh> meshes, double factor);
std::unique_ptr<DistanceEngine> set_up_distance_fcl_obbrss(std::span<const scenes::NamedMesh> meshes, double factor);
std::unique_ptr<DistanceEngine> set_up_distance_fcl_rss(std::span<const scenes::NamedMesh> meshes, double factor);

// All of the above. Ratios are taken to FCL OBBRSS, and of other questions to ECoDS's distance.
std::vector<DistanceMaker> distance_engines();
constexpr const char* distance_yardstick = "FCL OBBRSS";
constexpr const char* own_distance = "ECoDS";

}  // namespace ecods::bench
