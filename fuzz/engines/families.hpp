// Scenes of two meshes that are hard on a collision library, by family. All are rigid poses of meshes with coordinates
// of moderate size: nothing that a library refuses. The same seed is the same bits on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scenes/mesh_pairs.hpp"

namespace ecods::fuzz {

struct EngineFamily {
    std::string name;
    std::string what;
    std::function<scenes::MeshPairs(std::size_t count, std::uint32_t seed)> make;
};

const std::vector<EngineFamily>& engine_families();

}  // namespace ecods::fuzz
