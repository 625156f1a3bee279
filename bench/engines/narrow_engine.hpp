// What every engine of the narrow phase offers: meshes are made ready once, then pairs of them at poses are asked
// about.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ecods/ids.hpp"
#include "scenes/mesh_pairs.hpp"

namespace ecods::bench {

struct NarrowWork {
    std::uint64_t box_tests = 0;
    std::uint64_t triangle_tests = 0;
};

class NarrowEngine {
  public:
    virtual ~NarrowEngine() = default;

    // Whether the two touch. Timed, with everything that a change of pose demands.
    virtual bool query(const scenes::MeshQuery& query) = 0;

    // The same query, with its work counted. Not timed; nothing where the engine does not count.
    virtual std::optional<NarrowWork> work(const scenes::MeshQuery& /*query*/) { return std::nullopt; }

    // How far apart the two are. Not timed; nothing where the engine does not report it.
    virtual std::optional<double> distance(const scenes::MeshQuery& /*query*/) { return std::nullopt; }

    // All pairs of triangles that touch, in any order. Timed. Only for engines with `has_lists`.
    virtual void list(const scenes::MeshQuery& /*query*/, std::vector<TrianglePair>& pairs) { pairs.clear(); }
};

struct NarrowMaker {
    std::string name;
    std::string use;  // how it is used, and what its precision is: for the page
    bool is_ecods = false;
    bool has_lists = false;
    bool is_slow = false;  // timed once, however many repetitions the others have
    // Builds the trees of all meshes. This is what a build is timed by.
    std::unique_ptr<NarrowEngine> (*set_up)(std::span<const scenes::NamedMesh> meshes) = nullptr;
};

std::unique_ptr<NarrowEngine> set_up_narrow_ecods(std::span<const scenes::NamedMesh> meshes);
std::unique_ptr<NarrowEngine> set_up_narrow_fcl_obbrss(std::span<const scenes::NamedMesh> meshes);
std::unique_ptr<NarrowEngine> set_up_narrow_fcl_obb(std::span<const scenes::NamedMesh> meshes);
std::unique_ptr<NarrowEngine> set_up_narrow_ode(std::span<const scenes::NamedMesh> meshes);
std::unique_ptr<NarrowEngine> set_up_narrow_bullet(std::span<const scenes::NamedMesh> meshes);
std::unique_ptr<NarrowEngine> set_up_narrow_cgal(std::span<const scenes::NamedMesh> meshes);

// All of the above that this build has: those of the main job, then the others. The one that ratios are taken to is FCL
// OBBRSS, the second.
std::vector<NarrowMaker> narrow_engines();
std::vector<NarrowMaker> main_narrow_engines();
std::vector<NarrowMaker> more_narrow_engines();
constexpr const char* narrow_yardstick = "FCL OBBRSS";

}  // namespace ecods::bench
