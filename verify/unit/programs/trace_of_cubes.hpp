// A trace for programs to read.
#pragma once

#include <sstream>
#include <string>

#include "ecods/world.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/shapes.hpp"

namespace ecods::scenes {

// Two cubes; one passes through the other in three frames.
inline std::string trace_of_cubes() {
    std::ostringstream out;
    World world;
    world.trace_to(out);
    world.create_body(cube(0.5), {});
    const BodyId moving = world.create_body(cube(0.5), at(-2));
    for (const double x : {-1.0, 0.25, 2.0}) {
        world.set_pose(moving, at(x));
        world.update();
    }
    world.end_trace();
    return out.str();
}

}  // namespace ecods::scenes
