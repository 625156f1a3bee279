// The two-cylinder engine of Debian's assimp-testmodels, made to run.
#pragma once

#include <cstddef>
#include <filesystem>

#include "scenes/scene.hpp"

namespace ecods::scenes {

// Where Debian installs the model.
std::filesystem::path engine_file();

// Replaces the frames of the engine as read from its file by `frame_count` steps of the crank, 10 degrees each; 72 make
// the full cycle of four strokes. What moves, as the geometry of the parts demands: the crankshaft and its gear turn,
// the camshaft and its gear turn half as fast the other way, rods, pistons and their pins follow the crank exactly. Ten
// parts move. Valves, lifters and all else rest: the valve train is not followed, so the cams may pass into the
// lifters. Throws std::runtime_error when a part is missing.
void run_engine(Scene& engine, std::size_t frame_count);

}  // namespace ecods::scenes
