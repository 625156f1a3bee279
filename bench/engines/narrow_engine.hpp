// Do two meshes touch?
#pragma once

#include "ecods/ids.hpp"
#include "engines/engine.hpp"
#include "scenes/mesh_pairs.hpp"

namespace ecods::bench {

struct Touch {
    using Workload = scenes::MeshPairs;
    using Answer = double;  // 1 if the two share a point, otherwise 0
    using Engine = QueryEngine<Touch>;
    struct Traits {};
    using Item = TrianglePair;  // all that touch are listed
};

using NarrowMaker = Maker<Touch>;
using NarrowLists = Lists<Touch::Engine::Query, Touch::Item>;
using NarrowWork = CountsWork<Touch::Engine::Query>;

std::vector<NarrowMaker> ecods_narrow();
std::vector<NarrowMaker> fcl_narrow();  // its first is the one that ratios are taken to
std::vector<NarrowMaker> ode_narrow();
std::vector<NarrowMaker> bullet_narrow();
std::vector<NarrowMaker> cgal_narrow();

// All that this build has: those of the main job, then the others.
std::vector<NarrowMaker> narrow_engines();
std::vector<NarrowMaker> main_narrow_engines();
constexpr const char* narrow_yardstick = "FCL OBBRSS";

}  // namespace ecods::bench
